#include "stats/detail/probit_regression.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include <gsl/gsl_rng.h>

#include "core/random_stream.hpp"
#include "stats/probit.hpp"

namespace overturn {
namespace {

using Eigen::Index;

FragilityPoint outcome(ProbitDesign const& design, Index row) {
    FragilityPoint point;
    point.trials = 1;
    point.overturned = design.overturned[row] ? 1 : 0;
    return point;
}

double log_likelihood_at(ProbitDesign const& design, Eigen::VectorXd const& z) {
    double sum = 0;
    for (Index i = 0; i < z.size(); ++i) {
        sum += log_likelihood(outcome(design, i), z[i]);
    }
    return sum;
}

// First derivative of every row's log-likelihood by z, and its negative second one: s (s + z) whichever way it ended.
struct Derivatives {
    Eigen::VectorXd first, weight;
};

Derivatives derivatives_at(ProbitDesign const& design, Eigen::VectorXd const& z) {
    Derivatives at{Eigen::VectorXd(z.size()), Eigen::VectorXd(z.size())};
    for (Index i = 0; i < z.size(); ++i) {
        at.first[i] = score(outcome(design, i), z[i]);
        at.weight[i] = at.first[i] * (at.first[i] + z[i]);
    }
    return at;
}

std::vector<WaveScore> by_waves(ProbitDesign const& design, Derivatives const& at) {
    auto const& x = design.columns;
    std::map<std::int64_t, WaveScore> waves;
    for (Index i = 0; i < x.rows(); ++i) {
        auto& wave = waves
                         .try_emplace(design.waves[i], WaveScore{Eigen::VectorXd::Zero(x.cols()),
                                                                 Eigen::MatrixXd::Zero(x.cols(), x.cols())})
                         .first->second;
        wave.gradient += at.first[i] * x.row(i).transpose();
        wave.information += at.weight[i] * x.row(i).transpose() * x.row(i);
    }
    std::vector<WaveScore> list;
    list.reserve(waves.size());
    for (auto& [number, wave] : waves) {
        list.push_back(std::move(wave));
    }
    return list;
}

// Covariance where only waves are independent (Liang & Zeger 1986).
Eigen::MatrixXd sandwich(std::vector<WaveScore> const& waves, Eigen::MatrixXd const& inverse) {
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(inverse.rows(), inverse.cols());
    for (auto const& wave : waves) {
        scatter += wave.gradient * wave.gradient.transpose();
    }
    auto const count = static_cast<double>(waves.size());
    return inverse * scatter * inverse * (count > 1 ? count / (count - 1) : 1);
}

}  // namespace

std::optional<ProbitRegression> regress(ProbitDesign const& design) {
    constexpr int most_steps = 60;
    constexpr double enough = 1e-10;
    auto const& x = design.columns;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    double likelihood = log_likelihood_at(design, x * b);
    for (int step = 0; step < most_steps; ++step) {
        auto const at = derivatives_at(design, x * b);
        Eigen::LDLT<Eigen::MatrixXd> const information(x.transpose() * at.weight.asDiagonal() * x);
        Eigen::VectorXd const whole = information.solve(x.transpose() * at.first);
        if (information.info() != Eigen::Success || !information.isPositive() || !whole.allFinite()) {
            return std::nullopt;
        }
        double share = 1;
        double next = log_likelihood_at(design, x * (b + whole));
        constexpr double smallest_share = 1e-6;
        constexpr double rounding = 1e-12;  // of the sum: near the top a good step may seem to go down
        while (!(next >= likelihood - rounding * std::abs(likelihood)) && share > smallest_share) {
            share /= 2;
            next = log_likelihood_at(design, x * (b + share * whole));
        }
        b += share * whole;
        likelihood = next;
        if (whole.lpNorm<Eigen::Infinity>() < enough * (1 + b.lpNorm<Eigen::Infinity>())) {
            auto waves = by_waves(design, at);
            auto covariance = sandwich(waves, information.solve(Eigen::MatrixXd::Identity(x.cols(), x.cols())));
            return ProbitRegression{b, std::move(covariance), likelihood, std::move(waves)};
        }
    }
    return std::nullopt;  // separated: the coefficients run away
}

std::optional<Eigen::VectorXd> ProbitRegression::reweighted(std::vector<double> const& times) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(coefficients.size());
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(coefficients.size(), coefficients.size());
    for (std::size_t w = 0; w < waves.size(); ++w) {
        if (times[w] > 0) {
            gradient += times[w] * waves[w].gradient;
            information += times[w] * waves[w].information;
        }
    }
    Eigen::LDLT<Eigen::MatrixXd> const solver(information);
    Eigen::VectorXd const step = solver.solve(gradient);
    if (solver.info() != Eigen::Success || !solver.isPositive() || !step.allFinite()) {
        return std::nullopt;
    }
    return Eigen::VectorXd(coefficients + step);
}

std::vector<double> times_drawn(BootstrapKey const& key, int r, std::size_t waves) {
    RandomStream stream(key.seed, r, Purpose::bootstrap, key.stream);
    std::vector<double> times(waves, 0.0);
    for (std::size_t draw = 0; draw < waves; ++draw) {
        times[gsl_rng_uniform_int(stream.gsl(), waves)] += 1;
    }
    return times;
}

}  // namespace overturn
