#include "stats/beta_split.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "stats/probit.hpp"

namespace overturn {
namespace {

using Eigen::Index;

struct Design {
    Eigen::MatrixXd columns;  ///< 1, (ln x - mean), scores
    std::vector<FragilityPoint> outcomes;
    std::vector<std::int64_t> waves;
    double mean_log_intensity = 0;

    [[nodiscard]] double log_likelihood_at(Eigen::VectorXd const& z) const {
        double sum = 0;
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            sum += log_likelihood(outcomes[i], z[static_cast<Index>(i)]);
        }
        return sum;
    }
};

Design design_of(std::vector<DrawnTrial> const& trials) {
    auto const rows = static_cast<Index>(trials.size());
    auto const scores = static_cast<Index>(trials.front().scores.size());
    Design design;
    design.columns.resize(rows, 2 + scores);
    design.outcomes.reserve(trials.size());
    for (auto const& trial : trials) {
        design.mean_log_intensity += trial.log_intensity / static_cast<double>(rows);
    }
    for (Index i = 0; i < rows; ++i) {
        auto const& trial = trials[static_cast<std::size_t>(i)];
        design.columns(i, 0) = 1;
        design.columns(i, 1) = trial.log_intensity - design.mean_log_intensity;
        for (Index k = 0; k < scores; ++k) {
            design.columns(i, 2 + k) = trial.scores[static_cast<std::size_t>(k)];
        }
        FragilityPoint outcome;
        outcome.log_intensity = trial.log_intensity;
        outcome.trials = 1;
        outcome.overturned = trial.overturned ? 1 : 0;
        design.outcomes.push_back(outcome);
        design.waves.push_back(trial.wave);
    }
    return design;
}

// d^2 log-likelihood / dz^2 of one outcome, from its first derivative s: -s (s + z) whichever way it ended.
double curvature(double s, double z) { return s * (s + z); }

struct Fit {
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd covariance;
};

// Covariance where only waves are independent: inverse information around the scatter of the waves' own scores.
Eigen::MatrixXd sandwich(Design const& design, Eigen::VectorXd const& first, Eigen::MatrixXd const& inverse) {
    std::map<std::int64_t, Eigen::VectorXd> gradients;
    for (Index i = 0; i < first.size(); ++i) {
        auto& sum =
            gradients.try_emplace(design.waves[static_cast<std::size_t>(i)], Eigen::VectorXd::Zero(inverse.rows()))
                .first->second;
        sum += first[i] * design.columns.row(i).transpose();
    }
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(inverse.rows(), inverse.cols());
    for (auto const& [wave, gradient] : gradients) {
        scatter += gradient * gradient.transpose();
    }
    auto const waves = static_cast<double>(gradients.size());
    return inverse * scatter * inverse * (waves > 1 ? waves / (waves - 1) : 1);
}

std::optional<Fit> newton(Design const& design) {
    constexpr int most_steps = 60;
    constexpr double enough = 1e-10;
    auto const& x = design.columns;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    double likelihood = design.log_likelihood_at(x * b);
    for (int step = 0; step < most_steps; ++step) {
        Eigen::VectorXd const z = x * b;
        Eigen::VectorXd first(z.size());
        Eigen::VectorXd weight(z.size());
        for (Index i = 0; i < z.size(); ++i) {
            first[i] = score(design.outcomes[static_cast<std::size_t>(i)], z[i]);
            weight[i] = curvature(first[i], z[i]);
        }
        Eigen::LDLT<Eigen::MatrixXd> const information(x.transpose() * weight.asDiagonal() * x);
        Eigen::VectorXd const whole = information.solve(x.transpose() * first);
        if (information.info() != Eigen::Success || !information.isPositive() || !whole.allFinite()) {
            return std::nullopt;
        }
        double share = 1;
        double next = design.log_likelihood_at(x * (b + whole));
        constexpr double smallest_share = 1e-6;
        constexpr double rounding = 1e-12;  // of the sum: near the top a good step may seem to go down
        while (!(next >= likelihood - rounding * std::abs(likelihood)) && share > smallest_share) {
            share /= 2;
            next = design.log_likelihood_at(x * (b + share * whole));
        }
        b += share * whole;
        likelihood = next;
        if (whole.lpNorm<Eigen::Infinity>() < enough * (1 + b.lpNorm<Eigen::Infinity>())) {
            return Fit{b, sandwich(design, first, information.solve(Eigen::MatrixXd::Identity(x.cols(), x.cols())))};
        }
    }
    return std::nullopt;  // separated: the coefficients run away
}

}  // namespace

std::optional<BetaSplit> split_beta(std::vector<DrawnTrial> const& trials) {
    if (trials.empty()) {
        return std::nullopt;
    }
    OVERTURN_EXPECT(!trials.front().scores.empty());
    auto const fit = newton(design_of(trials));
    if (!fit || !(fit->coefficients[1] > 0)) {
        return std::nullopt;
    }
    double const slope = fit->coefficients[1];
    BetaSplit split;
    split.beta_r = 1 / slope;
    double squares = 0;
    for (Index k = 2; k < fit->coefficients.size(); ++k) {
        double const shift = -fit->coefficients[k] / slope;
        // Error propagation of the ratio b_k / slope.
        auto const& v = fit->covariance;
        double const variance = (v(k, k) + 2 * shift * v(1, k) + shift * shift * v(1, 1)) / (slope * slope);
        split.per_score.push_back(shift);
        split.per_score_error.push_back(std::sqrt(variance));
        squares += shift * shift - variance;  // E c_hat^2 = c^2 + variance
    }
    split.beta_u = std::sqrt(std::max(0.0, squares));
    return split;
}

}  // namespace overturn
