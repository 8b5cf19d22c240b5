#include "stats/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "core/random_stream.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/wave_cells.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

Replicate refit(std::span<FragilityPoint const> points, ProbitLine const& begin) {
    switch (state_of(points)) {
        case FragilityState::none_overturned:
            return {infinite, unknown};
        case FragilityState::all_overturned:
            return {-infinite, unknown};
        case FragilityState::separated:
            return {separating_log_intensity(points), 0};
        case FragilityState::fitted:
            break;
        default:
            return {unknown, unknown};
    }
    auto const line = fit_probit(points, begin);
    return line && line->slope > 0 ? Replicate{line->log_median(), line->beta()} : Replicate{unknown, unknown};
}

template <class Value>
Interval middle(Replicate const& estimate, std::vector<Replicate> const& replicates, double confidence,
                Interval const& widest, Value const& value) {
    std::vector<double> values;
    values.reserve(replicates.size());
    for (auto const& replicate : replicates) {
        values.push_back(value(replicate));
    }
    return middle_about(value(estimate), values, confidence, widest);
}

}  // namespace

Bootstrap::Bootstrap(std::vector<Replicate> replicates, ProbitLine const& line, ProbitLine const& centre)
    : replicates_(std::move(replicates)), estimate_{line.log_median(), line.beta()} {
    for (auto& replicate : replicates_) {
        without_curve_ += replicate.beta > 0 && std::isfinite(replicate.log_median) ? 0 : 1;
        replicate.log_median += line.log_median() - centre.log_median();
        replicate.beta *= line.beta() / centre.beta();
    }
}

void Bootstrap::lower_medians(std::span<double const> by) {
    OVERTURN_EXPECT(by.size() == replicates_.size());
    for (std::size_t r = 0; r < by.size(); ++r) {
        replicates_[r].log_median -= by[r];
    }
}

Interval Bootstrap::beta(double confidence) const {
    return middle(estimate_, replicates_, confidence, {0, infinite}, [](Replicate const& r) { return r.beta; });
}

Interval Bootstrap::intensity(double probability, double confidence) const {
    double const q = gsl_cdf_ugaussian_Pinv(probability);
    auto const ends = middle(estimate_, replicates_, confidence, {-infinite, infinite}, [q](Replicate const& r) {
        return std::isinf(r.log_median) ? r.log_median : r.log_median + q * r.beta;
    });
    return {std::exp(ends.lower), std::exp(ends.upper)};
}

Interval Bootstrap::probability(double intensity, double confidence) const {
    double const at = std::log(intensity);
    return middle(estimate_, replicates_, confidence, {0, 1}, [at](Replicate const& r) {
        if (std::isinf(r.log_median)) {
            return r.log_median > 0 ? 0.0 : 1.0;
        }
        if (r.beta == 0) {
            return at >= r.log_median ? 1.0 : 0.0;
        }
        return gsl_cdf_ugaussian_P((at - r.log_median) / r.beta);
    });
}

double resampled_confidence(double confidence, std::int64_t waves) {
    if (waves >= waves_enough_to_resample) {
        return confidence;
    }
    if (waves < 2) {
        return 1;
    }
    auto const n = static_cast<double>(waves);
    double const t = gsl_cdf_tdist_Pinv((1 + confidence) / 2, n - 1);
    return 1 - 2 * gsl_cdf_ugaussian_Q(t * std::sqrt(n / (n - 1)));
}

Bootstrap bootstrap_waves(std::span<SingleTrial const> trials, ProbitLine const& line, BootstrapKey const& key) {
    constexpr std::size_t most_points = 64;
    WaveCells const cells(trials, most_points);
    auto const centre = fit_probit(cells.points(), line).value_or(line);
    std::vector<Replicate> replicates;
    replicates.reserve(key.replicates);
    WaveResamples resamples(cells, key, Purpose::bootstrap);
    for (int r = 0; r < key.replicates; ++r) {
        replicates.push_back(refit(resamples.points(r), centre));
    }
    return {std::move(replicates), line, centre};
}

Bootstrap bootstrap_trials(std::span<FragilityPoint const> points, ProbitLine const& line, BootstrapKey const& key) {
    // Single trials by the thousand are refitted in groups, the shift of which the centre takes back.
    constexpr std::size_t most_points = 256;
    bool const many = points.size() > most_points;
    auto const cells = many ? grouped(points, most_points) : std::vector<FragilityPoint>();
    if (many && state_of(cells) == FragilityState::fitted) {
        points = cells;
    }
    std::vector<FragilityPoint> drawn(points.begin(), points.end());
    auto const centre = many ? fit_probit(points, line).value_or(line) : line;
    std::vector<Replicate> replicates;
    replicates.reserve(key.replicates);
    for (int r = 0; r < key.replicates; ++r) {
        RandomStream stream(key.seed, r, Purpose::bootstrap, key.stream);
        for (std::size_t i = 0; i < points.size(); ++i) {
            drawn[i].overturned =
                gsl_ran_binomial(stream.gsl(), points[i].probability(), static_cast<unsigned>(points[i].trials));
        }
        replicates.push_back(refit(drawn, centre));
    }
    return {std::move(replicates), line, centre};
}

}  // namespace overturn
