#include "stats/beta_split.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <map>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/probit_regression.hpp"

namespace overturn {
namespace {

using Eigen::Index;

constexpr Index scores_from = 2;  // columns: 1, ln x less its mean, scores

ProbitDesign design_of(std::vector<DrawnTrial> const& trials) {
    Index const rows = trials.size();
    Index const scores = trials.front().scores.size();
    ProbitDesign design;
    design.columns.resize(rows, scores_from + scores);
    double mean = 0;
    for (auto const& trial : trials) {
        mean += trial.log_intensity / static_cast<double>(rows);
    }
    for (Index i = 0; i < rows; ++i) {
        auto const& trial = trials[i];
        design.columns(i, 0) = 1;
        design.columns(i, 1) = trial.log_intensity - mean;
        for (Index k = 0; k < scores; ++k) {
            design.columns(i, scores_from + k) = trial.scores[k];
        }
        design.overturned.push_back(trial.overturned);
        design.waves.push_back(trial.wave);
    }
    return design;
}

// Of every wave, in the order of their numbers, the mean of its trials' scores and how many there are.
struct WaveMeans {
    Eigen::MatrixXd sums;  ///< one column per wave
    Eigen::VectorXd trials;
};

WaveMeans means_of(std::vector<DrawnTrial> const& trials) {
    std::map<std::int64_t, Index> places;
    for (auto const& trial : trials) {
        places.emplace(trial.wave, 0);
    }
    Index next = 0;
    for (auto& [wave, place] : places) {
        place = next++;
    }
    Index const scores = trials.front().scores.size();
    WaveMeans means{Eigen::MatrixXd::Zero(scores, next), Eigen::VectorXd::Zero(next)};
    for (auto const& trial : trials) {
        auto const place = places.at(trial.wave);
        means.trials[place] += 1;
        for (Index k = 0; k < scores; ++k) {
            means.sums(k, place) += trial.scores[k];
        }
    }
    return means;
}

// d ln median / d score of each.
Eigen::VectorXd shifts_of(Eigen::VectorXd const& coefficients) {
    return -coefficients.tail(coefficients.size() - scores_from) / coefficients[1];
}

// What chance adds to the sum of squares is in the sample once, and in each replicate once more.
void add_replicates(BetaSplit& split, ProbitRegression const& fit, WaveMeans const& means, double chance,
                    BootstrapKey const& key) {
    Eigen::VectorXd const sample_mean = means.sums.rowwise().sum() / means.trials.sum();
    Eigen::VectorXd const shifts = shifts_of(fit.coefficients);
    for (int r = 0; r < key.replicates; ++r) {
        auto const times = times_drawn(key, r, fit.waves.size());
        Eigen::Map<Eigen::VectorXd const> const weight(times.data(), times.size());
        Eigen::VectorXd const mean = means.sums * weight / means.trials.dot(weight);
        SplitReplicate replicate{unknown, shifts.dot(mean - sample_mean)};
        if (auto const again = fit.reweighted(times); again && (*again)[1] > 0) {
            replicate.beta_u = std::sqrt(std::max(0.0, shifts_of(*again).squaredNorm() - 2 * chance));
        }
        split.replicates.push_back(replicate);
    }
}

}  // namespace

bool BetaSplit::moves_median() const {
    constexpr double chance = 0.05;
    double const score = gsl_cdf_ugaussian_Qinv(chance / 2 / static_cast<double>(per_score.size()));
    for (std::size_t k = 0; k < per_score.size(); ++k) {
        if (std::abs(per_score[k]) > score * per_score_error[k]) {
            return true;
        }
    }
    return false;
}

std::optional<BetaSplit> split_beta(std::vector<DrawnTrial> const& trials, std::optional<BootstrapKey> const& key) {
    if (trials.empty()) {
        return std::nullopt;
    }
    OVERTURN_EXPECT(!trials.front().scores.empty());
    auto const fit = regress(design_of(trials));
    if (!fit || !(fit->coefficients[1] > 0)) {
        return std::nullopt;
    }
    double const slope = fit->coefficients[1];
    BetaSplit split;
    split.beta_r = 1 / slope;
    double squares = 0;
    double chance = 0;
    for (Index k = scores_from; k < fit->coefficients.size(); ++k) {
        double const shift = -fit->coefficients[k] / slope;
        // Error propagation of the ratio b_k / slope.
        auto const& v = fit->covariance;
        double const variance = (v(k, k) + 2 * shift * v(1, k) + shift * shift * v(1, 1)) / (slope * slope);
        split.per_score.push_back(shift);
        split.per_score_error.push_back(std::sqrt(variance));
        squares += shift * shift - variance;  // E c_hat^2 = c^2 + variance
        chance += variance;
    }
    split.beta_u = std::sqrt(std::max(0.0, squares));
    if (key) {
        add_replicates(split, *fit, means_of(trials), chance, *key);
    }
    return split;
}

}  // namespace overturn
