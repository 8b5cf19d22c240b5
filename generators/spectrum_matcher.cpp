#include "generators/spectrum_matcher.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_randist.h>

#include "core/random_stream.hpp"
#include "generators/baseline.hpp"
#include "generators/spectral_density.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr double periods_per_decade = 75;
constexpr double shortest_period_s = 0.02;
constexpr double cutoff = 1.5;  // no line beyond this many times the longest period: displacement stays bounded

double strong_seconds(std::vector<double> const& envelope, double time_step_s) {
    double sum = 0;
    for (double const value : envelope) {
        sum += value * value;
    }
    return sum * time_step_s;
}

// 1 up to the longest period, 0 from `cutoff` times it, a half cosine in log period between.
double long_period_fade(double period_s, double longest_s) {
    double const beyond = std::log(period_s / longest_s) / std::log(cutoff);
    return beyond <= 0 ? 1.0 : beyond >= 1 ? 0.0 : 0.5 * (1 + std::cos(pi * beyond));
}

}  // namespace

MatchFigures match_figures(std::span<double const> periods_s, std::span<double const> ratios, double from_s,
                           double to_s) {
    MatchFigures figures;
    double count = 0, sum = 0, squares = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        if (periods_s[i] < from_s || periods_s[i] > to_s) {
            continue;
        }
        double const misfit = std::abs(ratios[i] - 1);
        count += 1;
        sum += ratios[i];
        squares += ratios[i] * ratios[i];
        figures.mean_misfit += misfit;
        figures.below_fraction += ratios[i] < 1 ? 1 : 0;
        if (misfit > figures.max_misfit) {
            figures.max_misfit = misfit;
            figures.max_misfit_period_s = periods_s[i];
        }
    }
    if (count > 0) {
        figures.mean_misfit /= count;
        figures.below_fraction /= count;
        figures.mean_ratio = sum / count;
        double const variance = std::max(0.0, squares / count - figures.mean_ratio * figures.mean_ratio);
        figures.cov = figures.mean_ratio > 0 ? std::sqrt(variance) / figures.mean_ratio : 0.0;
    }
    return figures;
}

SpectrumMatcher::SpectrumMatcher(SpectrumMatcherInput input)
    : input_(std::move(input)), fft_(RealFft::good_length(input_.samples)) {
    double const dt = input_.time_step_s;
    double const shortest = std::max(shortest_period_s, 2 * dt);
    validate(input_.longest_s > 2 * shortest, "longest period {} s (above {} s for this time step). Raise it",
             input_.longest_s, 2 * shortest);
    envelope_ = input_.envelope.samples(dt, input_.samples);
    periods_s_ = log_periods_per_decade(shortest, input_.longest_s, periods_per_decade);
    for (double const period : periods_s_) {
        target_mps_.push_back(input_.target.psv_mps(period));
    }
    double const spacing = 2 * pi / (dt * static_cast<double>(fft_.length()));
    std::vector<double> frequencies;
    for (std::size_t k = 1; k < fft_.length() / 2; ++k) {
        frequencies.push_back(spacing * static_cast<double>(k));
    }
    auto const density = density_of(input_.target, frequencies, strong_seconds(envelope_, dt));
    line_amplitude_.push_back(0);
    line_place_.push_back(0);
    double const gap = std::log(periods_s_.back() / periods_s_.front()) / static_cast<double>(periods_s_.size() - 1);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        double const period = 2 * pi / frequencies[i];
        line_amplitude_.push_back(std::sqrt(2 * density[i] * spacing) * long_period_fade(period, input_.longest_s));
        line_place_.push_back(
            std::clamp(std::log(period / periods_s_.front()) / gap, 0.0, static_cast<double>(periods_s_.size() - 1)));
    }
}

SpectrumMatcher::Lines SpectrumMatcher::draw(std::uint64_t seed, std::uint64_t wave, std::uint64_t component) const {
    RandomStream phases(seed, wave, Purpose::wave_phase, component);
    RandomStream amplitudes(seed, wave, Purpose::wave_amplitude, component);
    Lines lines(line_amplitude_.size());
    for (std::size_t k = 1; k < lines.size(); ++k) {
        double const scatter =
            input_.amplitudes == LineAmplitudes::gaussian ? gsl_ran_rayleigh(amplitudes.gsl(), std::sqrt(0.5)) : 1.0;
        lines[k] = std::polar(scatter * line_amplitude_[k], gsl_ran_flat(phases.gsl(), 0, 2 * pi));
    }
    return lines;
}

std::vector<double> SpectrumMatcher::synthesise(Lines const& lines) const {
    std::vector<double> series(fft_.length());
    fft_.synthesise(lines, series);
    series.resize(input_.samples);
    for (std::size_t i = 0; i < series.size(); ++i) {
        series[i] *= envelope_[i];
    }
    correct_baseline(series);
    return series;
}

std::vector<double> SpectrumMatcher::ratios(std::span<double const> acceleration_mps2) const {
    double const damping = input_.target.damping();
    if (input_.target.is_energy()) {
        auto values = input_energy_velocities(acceleration_mps2, input_.time_step_s, periods_s_, damping);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] /= target_mps_[i];
        }
        return values;
    }
    auto values = displacement_spectrum(acceleration_mps2, input_.time_step_s, periods_s_, damping);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] *= 2 * pi / (periods_s_[i] * target_mps_[i]);
    }
    return values;
}

void SpectrumMatcher::adjust(Lines& lines, std::span<double const> ratios) const {
    constexpr double most = 4;  // one iteration changes no line by more
    for (std::size_t k = 1; k < lines.size(); ++k) {
        auto const left = std::min(static_cast<std::size_t>(line_place_[k]), ratios.size() - 2);
        double const share = line_place_[k] - static_cast<double>(left);
        double const ratio = (1 - share) * ratios[left] + share * ratios[left + 1];
        lines[k] /= std::clamp(ratio, 1 / most, most);
    }
}

SpectrumMatcher::Component SpectrumMatcher::make(std::uint64_t seed, std::uint64_t wave,
                                                 std::uint64_t component) const {
    constexpr double long_from_s = 1;
    constexpr double long_to_s = 10;
    auto lines = draw(seed, wave, component);
    Component best;
    double best_misfit = 0;
    for (int iteration = 0; iteration <= input_.iterations; ++iteration) {
        auto acceleration = synthesise(lines);
        auto const now = ratios(acceleration);
        auto const all = match_figures(periods_s_, now, 0, input_.longest_s);
        auto const slow = match_figures(periods_s_, now, long_from_s, long_to_s);
        double const misfit = std::max(all.mean_misfit, slow.mean_misfit);
        if (iteration == 0 || misfit < best_misfit) {
            best_misfit = misfit;
            best.acceleration_mps2 = std::move(acceleration);
            best.match.all = all;
            best.match.long_period = slow;
        }
        best.match.iterations = iteration;
        if (misfit <= input_.tolerance || iteration == input_.iterations) {
            break;
        }
        adjust(lines, now);
    }
    best.match.matched = input_.iterations > 0 && best_misfit <= input_.tolerance;
    return best;
}

}  // namespace overturn
