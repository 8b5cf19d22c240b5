#include "stats/detail/wave_shape_tests.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>

#include "stats/detail/simulated_chance.hpp"
#include "stats/isotonic.hpp"

namespace overturn {
namespace {

constexpr std::size_t most_points = 64;
constexpr int enough = 100;

std::vector<double> rising_of(std::span<FragilityPoint const> points) {
    std::vector<double> rising;
    for (auto const& pool : isotonic_estimate(points)) {
        rising.insert(rising.end(), pool.points, pool.probability());
    }
    return rising;
}

// Squared distance from the rising estimate, by trials.
double fall_of(std::span<FragilityPoint const> points) {
    auto const rising = rising_of(points);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double const off = points[i].probability() - rising[i];
        sum += points[i].trials * off * off;
    }
    return sum;
}

// Neighbours put together: which points belong to which, and what the curve says of their scatter.
struct Pools {
    std::vector<std::size_t> of_point;
    std::vector<double> variance;  // of the sum of one trial's residuals, were they independent
};

Pools pools_of(std::span<FragilityPoint const> points, ProbitLine const& line, double waves) {
    constexpr double least = 5;  // Cochran (1954)
    Pools pools;
    double expected = 0;
    double standing = 0;
    double variance = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double const p = gsl_cdf_ugaussian_P(line.at(points[i].log_intensity));
        // A wave counts once however many of its trials lie here.
        double const share = std::min(1.0, waves / points[i].trials);
        expected += p * points[i].trials * share;
        standing += (1 - p) * points[i].trials * share;
        variance += points[i].trials * p * (1 - p);
        auto const many = static_cast<double>(i + 1 - first);
        pools.of_point.push_back(pools.variance.size());
        if (expected / many >= least && standing / many >= least) {
            pools.variance.push_back(variance);
            expected = standing = variance = 0;
            first = i + 1;
        }
    }
    if (first < points.size() && !pools.variance.empty()) {  // the rest belongs to the last
        for (std::size_t i = first; i < points.size(); ++i) {
            pools.of_point[i] = pools.variance.size() - 1;
        }
        pools.variance.back() += variance;
    }
    return pools;
}

std::vector<double> residuals_of(std::span<FragilityPoint const> points, ProbitLine const& line) {
    std::vector<double> residuals;
    for (auto const& point : points) {
        residuals.push_back(point.probability() - gsl_cdf_ugaussian_P(line.at(point.log_intensity)));
    }
    return residuals;
}

// Pearson's sum of residuals, point by point multiplied by trials.
double pearson_of(std::span<double const> residuals, std::span<FragilityPoint const> points, Pools const& pools) {
    std::vector<double> sums(pools.variance.size(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        sums[pools.of_point[i]] += points[i].trials * residuals[i];
    }
    double pearson = 0;
    for (std::size_t g = 0; g < sums.size(); ++g) {
        pearson += sums[g] * sums[g] / pools.variance[g];
    }
    return pearson;
}

}  // namespace

WaveShapeTests::WaveShapeTests(std::span<SingleTrial const> trials, std::optional<ProbitLine> const& line,
                               BootstrapKey const& key)
    : cells_(trials, most_points), points_(cells_.points()), key_(key) {
    if (line && state_of(points_) == FragilityState::fitted) {
        line_ = fit_probit(points_);
    }
}

std::vector<FragilityPoint> WaveShapeTests::draw(WaveResamples& resamples, int number) const {
    auto drawn = resamples.points(number);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        drawn[i] = drawn[i].trials > 0 ? drawn[i] : points_[i];
    }
    return drawn;
}

double WaveShapeTests::monotone_chance() const {
    auto const rising = rising_of(points_);
    auto const waves = static_cast<double>(cells_.waves());
    double const wider = std::sqrt(waves / std::max(1.0, waves - 1));
    WaveResamples resamples(cells_, key_, Purpose::shape_test);
    return chance_of_draws(fall_of(points_), key_, enough, [&](int number) {
        auto moved = draw(resamples, number);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            double const p = rising[i] + wider * (moved[i].probability() - points_[i].probability());
            moved[i].trials = points_[i].trials;
            moved[i].overturned = p * points_[i].trials;
        }
        return std::optional(fall_of(moved));
    });
}

double WaveShapeTests::misfit_chance() const {
    constexpr std::size_t fewest = 3;  // two are spent on the curve
    auto const waves = static_cast<double>(cells_.waves());
    if (!line_ || !(line_->slope > 0)) {
        return 1;
    }
    auto const pools = pools_of(points_, *line_, waves);
    if (pools.variance.size() < fewest) {
        return 1;
    }
    auto const found = residuals_of(points_, *line_);
    double const wider = std::sqrt(waves / std::max(1.0, waves - 1));
    WaveResamples resamples(cells_, key_, Purpose::shape_test);
    return chance_of_draws(pearson_of(found, points_, pools), key_, enough, [&](int number) -> std::optional<double> {
        auto const drawn = draw(resamples, number);
        auto const line = state_of(drawn) == FragilityState::fitted ? fit_probit(drawn, *line_) : std::nullopt;
        if (!line || !(line->slope > 0)) {
            return std::nullopt;
        }
        auto off = residuals_of(drawn, *line);
        for (std::size_t i = 0; i < off.size(); ++i) {
            off[i] = wider * (off[i] - found[i]);
        }
        return pearson_of(off, points_, pools);
    });
}

}  // namespace overturn
