#include "stats/two_measures.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "stats/detail/extended_real.hpp"
#include "stats/detail/probit_regression.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

using Eigen::Index;

// Both columns less their means, so that Newton's equations are well conditioned.
struct Centred {
    ProbitDesign design;
    Eigen::Vector2d means;
};

Centred centred(std::vector<TwoMeasureTrial> const& trials) {
    Centred made{{}, Eigen::Vector2d::Zero()};
    Index const rows = trials.size();
    made.design.columns.resize(rows, 3);
    for (Index i = 0; i < rows; ++i) {
        auto const& trial = trials[i];
        made.design.columns.row(i) << 1, trial.log_intensity[0], trial.log_intensity[1];
        made.design.overturned.push_back(trial.overturned);
        made.design.waves.push_back(trial.wave);
    }
    made.means = made.design.columns.rightCols<2>().colwise().mean();
    made.design.columns.rightCols<2>().rowwise() -= made.means.transpose();
    return made;
}

bool one_is_the_others_multiple(Eigen::MatrixXd const& columns) {
    constexpr double distinct = 1e-8;
    double const a = columns.col(1).squaredNorm();
    double const b = columns.col(2).squaredNorm();
    double const ab = columns.col(1).dot(columns.col(2));
    return a * b - ab * ab <= distinct * a * b;
}

std::optional<ProbitRegression> regress_alone(ProbitDesign const& both, Index column) {
    ProbitDesign alone{both.columns.leftCols(2), both.overturned, both.waves};
    alone.columns.col(1) = both.columns.col(1 + column);
    return regress(alone);
}

// constant, slopes, beta: of the measures as they are.
std::array<double, 4> in_logarithms(Eigen::VectorXd const& coefficients, Eigen::Vector2d const& means) {
    double const along = coefficients[1] + coefficients[2];
    return {coefficients[0] - coefficients.tail<2>().dot(means), coefficients[1], coefficients[2],
            along > 0 ? 1 / along : unknown};
}

}  // namespace

std::optional<TwoMeasureFit> fit_two_measures(std::vector<TwoMeasureTrial> const& trials, double confidence,
                                              BootstrapKey const& key) {
    if (trials.empty()) {
        return std::nullopt;
    }
    auto const data = centred(trials);
    if (one_is_the_others_multiple(data.design.columns)) {
        return std::nullopt;
    }
    auto const both = regress(data.design);
    std::array const alone{regress_alone(data.design, 0), regress_alone(data.design, 1)};
    if (!both || !alone[0] || !alone[1] || !(both->coefficients[1] + both->coefficients[2] > 0)) {
        return std::nullopt;
    }
    std::array<std::vector<double>, 4> replicates;
    for (int r = 0; r < key.replicates; ++r) {
        auto const again = both->reweighted(times_drawn(key, r, both->waves.size()));
        auto const values = again ? in_logarithms(*again, data.means) : std::array{unknown, unknown, unknown, unknown};
        for (std::size_t k = 0; k < values.size(); ++k) {
            replicates.at(k).push_back(values.at(k));
        }
    }
    auto const values = in_logarithms(both->coefficients, data.means);
    auto const estimate = [&](std::size_t k, Interval const& widest) {
        return Estimate{values.at(k), middle_of(replicates.at(k), confidence, widest)};
    };
    TwoMeasureFit fit;
    fit.constant = estimate(0, {-infinite, infinite});
    fit.slopes = {estimate(1, {-infinite, infinite}), estimate(2, {-infinite, infinite})};
    fit.beta = estimate(3, {0, infinite});
    fit.better = alone[1]->log_likelihood > alone[0]->log_likelihood ? 1 : 0;
    fit.deviance_gain = 2 * (both->log_likelihood - alone.at(fit.better)->log_likelihood);
    fit.trials = trials.size();
    fit.waves = both->waves.size();
    return fit;
}

}  // namespace overturn
