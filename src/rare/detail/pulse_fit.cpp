#include "rare/detail/pulse_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "rare/detail/pulse_groups.hpp"
#include "spectra/transform.hpp"

namespace overturn::rare {
namespace {

std::vector<double> capped_weights(std::span<FailedWave const> waves) {
    constexpr double quantile = 0.9;
    constexpr double most = 3;
    std::vector<double> sorted;
    for (auto const& wave : waves) {
        sorted.push_back(wave.weight);
    }
    auto weights = sorted;
    auto const at = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
    double const cap = most * sorted[at];
    for (double& weight : weights) {
        weight = std::min(weight, cap);
    }
    return weights;
}

// 1 from the failure back, 0 before the pulse began; half cosines between.
std::vector<double> lag_window(PulseFrame const& frame, FitOptions const& options) {
    auto const grid = Mixture::grid_of(frame);
    double const period = 2 * pi / frame.spacing_radps;
    double const edge = options.edge * frame.body_period_s;
    auto const rise = [&](double inside_s) {
        return inside_s <= 0 ? 0.0 : inside_s >= edge ? 1.0 : 0.5 * (1 - std::cos(pi * inside_s / edge));
    };
    std::vector<double> window(grid);
    for (std::size_t j = 0; j < grid; ++j) {
        double const time = period * static_cast<double>(j) / static_cast<double>(grid);
        double const lag = time > 0.5 * period ? time - period : time;
        window[j] = rise(lag + options.before * frame.body_period_s) * rise(options.after * frame.body_period_s - lag);
    }
    return window;
}

// The wave moved so that it fails at time 0 to the positive side, and only what lies within the window.
Lines aligned(PulseFrame const& frame, FailedWave const& wave, std::span<double const> window) {
    auto const synthesis = real_synthesis(window.size());
    std::fill(synthesis.in.begin(), synthesis.in.end(), 0.0);
    for (std::size_t k = 1; k <= frame.lines; ++k) {
        double const angle = frame.spacing_radps * static_cast<double>(k) * wave.moment.time_s;
        synthesis.in[k] = 0.5 * wave.moment.sign * wave.lines[k - 1] * std::polar(1.0, angle);
    }
    synthesis.run();
    auto const analysis = real_analysis(window.size());
    for (std::size_t j = 0; j < window.size(); ++j) {
        analysis.in[j] = window[j] * synthesis.out[j];
    }
    analysis.run();
    Lines lines(frame.lines);
    for (std::size_t k = 1; k <= frame.lines; ++k) {
        lines[k - 1] = analysis.out[k] * (2.0 / static_cast<double>(window.size()));
    }
    return lines;
}

// Where the group's waves failed, smoothed, and a tenth spread evenly.
std::vector<double> arrivals(PulseFrame const& frame, std::span<FailedWave const> waves,
                             std::span<double const> weights, FitOptions const& options) {
    auto const grid = Mixture::grid_of(frame);
    double const period = 2 * pi / frame.spacing_radps;
    double const width = options.arrival_kernel * frame.body_period_s;
    std::vector<double> fitted(grid, 0.0);
    std::vector<double> even(grid, 0.0);
    for (std::size_t j = 0; j < grid; ++j) {
        double const time = period * static_cast<double>(j) / static_cast<double>(grid);
        even[j] = time >= options.earliest * frame.duration_s && time <= options.latest * frame.duration_s ? 1 : 0;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            double const off = (time - waves[i].moment.time_s) / width;
            fitted[j] += weights[i] > 0 ? weights[i] * std::exp(-0.5 * off * off) : 0;
        }
    }
    double fitted_sum = 0;
    double even_sum = 0;
    for (std::size_t j = 0; j < grid; ++j) {
        fitted_sum += fitted[j];
        even_sum += even[j];
    }
    double const even_share = fitted_sum > 0 ? 0.1 : 1.0;
    for (std::size_t j = 0; j < grid; ++j) {
        fitted[j] = even_share * even[j] / even_sum + (fitted_sum > 0 ? (1 - even_share) * fitted[j] / fitted_sum : 0);
    }
    return fitted;
}

}  // namespace

Mixture fit_pulses(PulseFrame const& frame, std::span<FailedWave const> waves, FitOptions const& options) {
    OVERTURN_EXPECT(!waves.empty());
    auto const weights = capped_weights(waves);
    auto const window = lag_window(frame, options);
    std::vector<Lines> lines;
    for (auto const& wave : waves) {
        lines.push_back(aligned(frame, wave, window));
    }
    auto groups = grouped(lines, weights, options.pulses);
    double total = 0;
    for (double const weight : weights) {
        total += weight;
    }
    constexpr double kept = 0.95;  // no pulse is given up altogether
    std::vector<Pulse> pulses;
    for (std::size_t c = 0; c < options.pulses; ++c) {
        std::vector<double> of_group(weights.size(), 0.0);
        double sum = 0;
        for (std::size_t i = 0; i < of_group.size(); ++i) {
            of_group[i] = groups.of[i] == c ? weights[i] : 0;
            sum += of_group[i];
        }
        pulses.push_back({.lines = std::move(groups.means[c]),
                          .share = kept * sum / total + (1 - kept) / static_cast<double>(options.pulses),
                          .arrival = arrivals(frame, waves, of_group, options)});
    }
    return {frame, std::move(pulses)};
}

}  // namespace overturn::rare
