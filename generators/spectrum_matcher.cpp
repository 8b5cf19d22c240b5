#include "generators/spectrum_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "generators/ensemble_calibration.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr double periods_per_decade = 100;  // what SRP 3.7.1 judges at
constexpr double shortest_period_s = 0.02;

SpectrumMatcherInput checked(SpectrumMatcherInput input) {
    double const least = 2 * std::max(shortest_period_s, 2 * input.time_step_s);
    validate(input.longest_s > least, "longest period {} s (above {} s for this time step). Raise it", input.longest_s,
             least);
    return input;
}

// Every second period below `dense_from_s` (their peaks are 10 % wide, the gaps 4.7 %), every one above, both ends.
std::vector<std::size_t> swept_periods(std::span<double const> periods_s, double dense_from_s) {
    std::vector<std::size_t> swept;
    for (std::size_t i = 0; i < periods_s.size(); ++i) {
        if (periods_s[i] >= dense_from_s || i % 2 == 0 || i + 1 == periods_s.size()) {
            swept.push_back(i);
        }
    }
    return swept;
}

// Sums of squares over a window around each sample.
std::vector<double> smoothed_power(std::span<double const> series, std::size_t half_window) {
    std::vector<double> sums(series.size() + 1, 0.0);
    for (std::size_t i = 0; i < series.size(); ++i) {
        sums[i + 1] = sums[i] + series[i] * series[i];
    }
    std::vector<double> power(series.size());
    for (std::size_t i = 0; i < series.size(); ++i) {
        std::size_t const first = i < half_window ? 0 : i - half_window;
        power[i] = sums[std::min(series.size(), i + half_window + 1)] - sums[first];
    }
    return power;
}

// Multiplies `envelope` so that a wave like `acceleration` has its power where `wanted` puts it.
void sharpen(std::vector<double>& envelope, std::span<double const> acceleration, std::span<double const> wanted) {
    constexpr double window = 0.10;
    constexpr double most = 1.5;
    auto const half = static_cast<std::size_t>(window / 2 * static_cast<double>(wanted.size()));
    auto const have = smoothed_power(acceleration, half);
    auto const want = smoothed_power(wanted, half);
    double all_have = 0, all_want = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        all_have += acceleration[i] * acceleration[i];
        all_want += wanted[i] * wanted[i];
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (have[i] > 0) {
            envelope[i] *= std::clamp(std::sqrt(want[i] / all_want * all_have / have[i]), 1 / most, most);
        }
    }
}

}  // namespace

SpectrumMatcher::SpectrumMatcher(SpectrumMatcherInput input)
    : input_(checked(std::move(input))),
      noise_({.target = input_.target,
              .longest_s = input_.longest_s,
              .time_step_s = input_.time_step_s,
              .samples = input_.samples,
              .envelope = input_.envelope,
              .amplitudes = input_.amplitudes,
              .refined = input_.calibrated}) {
    double const dt = input_.time_step_s;
    double const shortest = std::max(shortest_period_s, 2 * dt);
    periods_s_ = log_periods_per_decade(shortest, input_.longest_s, periods_per_decade);
    for (double const period : periods_s_) {
        target_mps_.push_back(input_.target.psv_mps(period));
    }
    constexpr double dense_from_steps = 64;
    swept_ = swept_periods(periods_s_, dense_from_steps * dt);
    std::vector<double> swept_s;
    swept_s.reserve(swept_.size());
    for (auto const i : swept_) {
        swept_s.push_back(periods_s_[i]);
    }
    sweep_.emplace(swept_s, input_.target.damping(), dt);
    gains_.emplace(swept_s, input_.target.damping(), noise_.spacing_radps(), noise_.first(), noise_.count());
    if (input_.calibrated) {
        median_ = calibrate(noise_, input_.target,
                            log_periods_per_decade(shortest, input_.longest_s, periods_per_decade / 2));
    }
}

std::vector<double> SpectrumMatcher::ratios(std::span<double const> acceleration_mps2) const {
    double const damping = input_.target.damping();
    bool const energy = input_.target.is_energy();
    auto values = energy ? input_energy_velocities(acceleration_mps2, input_.time_step_s, periods_s_, damping)
                         : displacement_spectrum(acceleration_mps2, input_.time_step_s, periods_s_, damping);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] *= (energy ? 1 : 2 * pi / periods_s_[i]) / target_mps_[i];
    }
    return values;
}

std::vector<double> SpectrumMatcher::swept_ratios(std::span<PeakSwing const> swings) const {
    std::vector<double> values(periods_s_.size());
    for (std::size_t s = 0; s < swept_.size(); ++s) {
        auto const i = swept_[s];
        values[i] = std::abs(swings[s].displacement_m) * 2 * pi / (periods_s_[i] * target_mps_[i]);
        if (s > 0 && swept_[s - 1] + 2 == i) {
            values[i - 1] = (values[i - 2] + values[i]) / 2;
        }
    }
    return values;
}

double SpectrumMatcher::shortfall(std::span<double const> ratios) const {
    auto const all = match_figures(periods_s_, ratios, 0, input_.longest_s);
    auto const& rule = input_.rule;
    double const misfit = std::max(all.mean_misfit, worst_decade_misfit(periods_s_, ratios)) / input_.tolerance;
    if (!rule.asks()) {
        return misfit;
    }
    double const si = spectral_intensity_ratio(periods_s_, ratios, input_.target);
    return std::max({misfit, (1 - all.lowest_ratio) / (1 - rule.lowest_ratio),
                     (all.highest_ratio - 1) / (rule.highest_ratio - 1), all.longest_below / rule.most_adjacent_below,
                     all.cov / rule.largest_cov, std::abs(all.mean_ratio - 1) / rule.largest_mean_error,
                     rule.lowest_intensity_ratio > 0 ? 1 + rule.lowest_intensity_ratio - si : 0.0});
}

void SpectrumMatcher::scale_lines(Lines& lines, std::span<double const> ratios) const {
    constexpr double most = 4;  // one iteration changes no line by more
    std::vector<double> divisors(ratios.begin(), ratios.end());
    for (double& value : divisors) {
        value = std::clamp(value / input_.rule.aim, 1 / most, most);
    }
    divide_lines(lines, noise_.spacing_radps(), periods_s_, divisors);
}

SpectrumMatcher::Component SpectrumMatcher::judged(std::vector<double> acceleration_mps2, int iterations) const {
    constexpr double long_from_s = 1;
    constexpr double long_to_s = 10;
    Component component;
    component.ratios = ratios(acceleration_mps2);
    component.acceleration_mps2 = std::move(acceleration_mps2);
    auto& match = component.match;
    match.iterations = iterations;
    match.all = match_figures(periods_s_, component.ratios, 0, input_.longest_s);
    match.long_period = match_figures(periods_s_, component.ratios, long_from_s, long_to_s);
    match.worst_decade = worst_decade_misfit(periods_s_, component.ratios);
    match.intensity_ratio = spectral_intensity_ratio(periods_s_, component.ratios, input_.target);
    match.matched = input_.iterations > 0 && shortfall(component.ratios) <= 1;
    return component;
}

// What to answer at a swept period: its own ratio, or that of a period left out beside it which breaks the rule.
double SpectrumMatcher::heard(std::span<double const> ratios, std::size_t s) const {
    auto const breaks = [&](std::size_t i) {
        auto const& rule = input_.rule;
        return rule.asks() && (ratios[i] < rule.lowest_ratio || ratios[i] > rule.highest_ratio);
    };
    auto const i = swept_[s];
    if (s > 0 && swept_[s - 1] + 2 == i && breaks(i - 1)) {
        return ratios[i - 1];
    }
    if (s + 1 < swept_.size() && swept_[s + 1] == i + 2 && breaks(i + 1)) {
        return ratios[i + 1];
    }
    return ratios[i];
}

void SpectrumMatcher::step_lines(Lines& lines, std::span<PeakSwing const> swings, std::span<double const> ratios,
                                 std::span<double const> envelope, LineGains::Trust trust) const {
    std::vector<double> wanted(swept_.size());
    std::vector<double> strength(swept_.size());
    for (std::size_t s = 0; s < swept_.size(); ++s) {
        wanted[s] = input_.rule.aim / heard(ratios, s);
        auto const sample = static_cast<std::size_t>(swings[s].time_s / input_.time_step_s);
        strength[s] = envelope[std::min(sample, envelope.size() - 1)];
    }
    gains_->apply(lines, swings, strength, wanted, trust);
}

SpectrumMatcher::Component SpectrumMatcher::matched(Lines lines, Steps const& steps) const {
    constexpr double promising = 1.05;  // the sweep errs a little: let the exact spectrum decide near the border
    std::optional<Component> best;
    double best_shortfall = 0;
    auto envelope = noise_.envelope();
    for (int iteration = 0;; ++iteration) {
        auto const acceleration = noise_.synthesise(lines, envelope);
        bool const last = iteration == input_.iterations;
        auto const swings = input_.target.is_energy() ? std::vector<PeakSwing>{} : sweep_->swings(acceleration);
        auto seen = swings.empty() ? ratios(acceleration) : swept_ratios(swings);
        bool const shaping = iteration == 1 && steps.envelope == EnvelopeStep::sharpen_once;
        if ((!shaping && shortfall(seen) <= promising) || last) {
            auto component = judged(acceleration, iteration);
            double const now = shortfall(component.ratios);
            seen = component.ratios;  // what the sweep does not see would never be mended
            if (!best || now < best_shortfall) {
                best = std::move(component);
                best_shortfall = now;
            }
        }
        if (last || (best && best->match.matched)) {
            best->match.iterations = iteration;
            return *std::move(best);
        }
        if (shaping) {
            sharpen(envelope, acceleration, noise_.envelope());
        }
        if (iteration < steps.plain || swings.empty()) {
            scale_lines(lines, seen);
        } else {
            constexpr int patience = 10;  // nearly every wave is there after half of them
            step_lines(lines, swings, seen, envelope,
                       iteration < steps.plain + patience ? LineGains::Trust::little : LineGains::Trust::much);
        }
    }
}

SpectrumMatcher::Component SpectrumMatcher::make(std::uint64_t seed, std::uint64_t wave,
                                                 std::uint64_t component) const {
    RandomStream phases(seed, wave, Purpose::wave_phase, component);
    RandomStream amplitudes(seed, wave, Purpose::wave_amplitude, component);
    auto lines = noise_.draw(phases, amplitudes);
    auto made = input_.iterations == 0 ? judged(noise_.synthesise(lines, noise_.envelope()), 0)
                                       : matched(std::move(lines), {1, EnvelopeStep::sharpen_once});
    std::tie(made.match.psd_lowest_ratio, made.match.psd_lowest_hz) = noise_.lowest_power(made.acceleration_mps2);
    return made;
}

SpectrumMatcher::Component SpectrumMatcher::match_motion(std::span<double const> acceleration_mps2) const {
    constexpr int plain = 4;  // a record may be far from the target
    auto made = matched(noise_.analyse(acceleration_mps2), {plain, EnvelopeStep::leave});
    std::tie(made.match.psd_lowest_ratio, made.match.psd_lowest_hz) = noise_.lowest_power(made.acceleration_mps2);
    return made;
}

}  // namespace overturn
