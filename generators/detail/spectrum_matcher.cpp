#include "generators/detail/spectrum_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "generators/detail/ensemble_calibration.hpp"
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

std::vector<std::size_t> every_second(std::vector<std::size_t> const& all) {
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % 2 == 0 || i + 1 == all.size()) {
            some.push_back(all[i]);
        }
    }
    return some;
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
void correct_envelope(std::vector<double>& envelope, std::span<double const> acceleration,
                      std::span<double const> wanted) {
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

// What peaks will be under another envelope, which changes slowly beside their memory.
void rescale_peaks(std::span<PeakDisplacement> peaks, std::span<double const> before, std::span<double const> after,
                   double time_step_s) {
    for (auto& peak : peaks) {
        auto const sample = std::min(static_cast<std::size_t>(peak.time_s / time_step_s), before.size() - 1);
        peak.displacement_m *= before[sample] > 0 ? after[sample] / before[sample] : 1.0;
    }
}

}  // namespace

SpectrumMatcher::SpectrumMatcher(SpectrumMatcherInput input)
    : input_(checked(std::move(input))),
      noise_({.target = input_.target,
              .longest_s = std::max(input_.longest_s, input_.kept_to_s),
              .time_step_s = input_.time_step_s,
              .samples = input_.samples,
              .envelope = input_.envelope,
              .amplitudes = input_.amplitudes,
              .refined = input_.calibrated}) {
    double const dt = input_.time_step_s;
    double const shortest = std::max(shortest_period_s, 2 * dt);
    judged_.period_s = log_periods_per_decade(shortest, input_.longest_s, periods_per_decade);
    for (double const period : judged_.period_s) {
        judged_.target_mps.push_back(input_.target.psv_mps(period));
    }
    double const damping = input_.target.damping();
    constexpr double dense_from_steps = 64;
    auto const swept = swept_periods(judged_.period_s, dense_from_steps * dt);
    probes_.emplace_back(judged_, every_second(swept), damping, noise_);
    probes_.emplace_back(judged_, swept, damping, noise_);
    for (std::size_t i = 0; i < judged_.period_s.size(); ++i) {
        if (!std::binary_search(swept.begin(), swept.end(), i)) {
            unprobed_places_.push_back(i);
        }
    }
    unprobed_.emplace(judged_.at(unprobed_places_), damping, dt);
    if (input_.calibrated) {
        calibration_ = std::make_unique<Calibration>();
    }
}

SpectrumMatcher::Calibrated const& SpectrumMatcher::calibrated(ShareRows const& share) const {
    std::call_once(calibration_->once, [&] {
        auto noise = noise_;
        auto const periods_s =
            log_periods_per_decade(judged_.period_s.front(), input_.longest_s, periods_per_decade / 2);
        auto const median = calibrate(noise, input_.target, periods_s, share);
        calibration_->made.emplace(Calibrated{std::move(noise), median});
    });
    return *calibration_->made;
}

void SpectrumMatcher::prepare(ShareRows const& share) const {
    if (calibration_) {
        (void)calibrated(share);
    }
}

NoiseLines const& SpectrumMatcher::noise() const { return calibration_ ? calibrated(rows_alone).noise : noise_; }

MatchFigures const* SpectrumMatcher::median() const { return calibration_ ? &calibrated(rows_alone).median : nullptr; }

// The energy spectrum over the target.
std::vector<double> SpectrumMatcher::energy_ratios(std::span<double const> acceleration_mps2) const {
    auto values =
        input_energy_velocities(acceleration_mps2, input_.time_step_s, judged_.period_s, input_.target.damping());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] /= judged_.target_mps[i];
    }
    return values;
}

// The response spectrum over the target. \param peaks of the closer probe, which need not be found again
std::vector<double> SpectrumMatcher::exact(std::span<double const> acceleration_mps2,
                                           std::span<PeakDisplacement const> peaks) const {
    auto values = probes_.back().ratios(peaks);
    auto const others = unprobed_->peaks(acceleration_mps2);
    for (std::size_t i = 0; i < unprobed_places_.size(); ++i) {
        values[unprobed_places_[i]] = judged_.ratio(unprobed_places_[i], others[i].displacement_m);
    }
    return values;
}

double SpectrumMatcher::shortfall(std::span<double const> ratios) const {
    auto const all = match_figures(judged_.period_s, ratios, 0, input_.longest_s);
    auto const& rule = input_.rule;
    double const misfit = std::max(all.mean_misfit, worst_decade_misfit(judged_.period_s, ratios)) / input_.tolerance;
    if (!rule.enabled()) {
        return misfit;
    }
    double const si = spectral_intensity_ratio(judged_.period_s, ratios, input_.target);
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
    divide_lines(lines, noise_.spacing_radps(), judged_.period_s, divisors);
}

SpectrumMatcher::Component SpectrumMatcher::judged(std::vector<double> acceleration_mps2, std::vector<double> ratios,
                                                   int iterations) const {
    constexpr double long_from_s = 1;
    constexpr double long_to_s = 10;
    Component component;
    component.ratios = std::move(ratios);
    component.acceleration_mps2 = std::move(acceleration_mps2);
    auto& match = component.match;
    match.iterations = iterations;
    match.all = match_figures(judged_.period_s, component.ratios, 0, input_.longest_s);
    match.long_period = match_figures(judged_.period_s, component.ratios, long_from_s, long_to_s);
    match.worst_decade = worst_decade_misfit(judged_.period_s, component.ratios);
    match.intensity_ratio = spectral_intensity_ratio(judged_.period_s, component.ratios, input_.target);
    match.matched = input_.iterations > 0 && shortfall(component.ratios) <= 1;
    return component;
}

SpectrumMatcher::Probed SpectrumMatcher::probed(std::vector<double> acceleration_mps2, bool rough) const {
    Probed wave{.acceleration_mps2 = std::move(acceleration_mps2)};
    wave.probe = &(rough ? probes_.front() : probes_.back());
    if (input_.target.is_energy()) {
        wave.ratios = energy_ratios(wave.acceleration_mps2);
    } else {
        wave.peaks = wave.probe->peaks(wave.acceleration_mps2);
        wave.ratios = wave.probe->ratios(wave.peaks);
    }
    wave.shortfall = shortfall(wave.ratios);
    return wave;
}

// What no probe sees would never be mended.
void SpectrumMatcher::read_exactly(Probed& wave) const {
    if (input_.target.is_energy()) {
        return;
    }
    if (wave.probe != &probes_.back()) {
        wave.probe = &probes_.back();
        wave.peaks = wave.probe->peaks(wave.acceleration_mps2);
    }
    wave.ratios = exact(wave.acceleration_mps2, wave.peaks);
    wave.shortfall = shortfall(wave.ratios);
}

void SpectrumMatcher::step(Lines& lines, Probed& wave, std::vector<double>& envelope, int iteration,
                           Steps const& steps) const {
    bool const energy = input_.target.is_energy();
    if (corrects_envelope(iteration, steps)) {
        auto const before = envelope;
        correct_envelope(envelope, wave.acceleration_mps2, noise_.envelope());
        rescale_peaks(wave.peaks, before, envelope, input_.time_step_s);
        wave.ratios = energy ? wave.ratios : wave.probe->ratios(wave.peaks);
    }
    if (iteration < steps.plain || energy) {
        scale_lines(lines, wave.ratios);
        return;
    }
    constexpr int cautious_iterations = 3;  // enough for a mean misfit of 5 %
    constexpr int usual_iterations = 4;     // what meets a rule with its phases as drawn mostly has by then
    if (input_.rule.enabled() && iteration >= steps.plain + usual_iterations) {
        wave.probe->step_slow(lines, wave.peaks, wave.ratios, envelope, input_.rule, noise_);
        return;
    }
    wave.probe->step(lines, wave.peaks, wave.ratios, envelope, input_.rule,
                     iteration < steps.plain + cautious_iterations ? LineGains::Trust::little : LineGains::Trust::much);
}

SpectrumMatcher::Component SpectrumMatcher::matched(Lines lines, Steps const& steps) const {
    constexpr double accept_margin = 1.05;  // probes leave periods out: near the border the exact spectrum decides
    std::optional<Component> best;
    double best_shortfall = 0;
    std::optional<Probed> nearest;  // of all, by the probes
    auto envelope = noise_.envelope();
    for (int iteration = 0;; ++iteration) {
        bool const last = iteration == input_.iterations;
        bool const rough = iteration <= std::max(steps.plain, 1) && input_.iterations > 0;
        auto wave = probed(noise_.synthesise(lines, envelope), rough);
        if (!nearest || wave.shortfall < nearest->shortfall) {
            nearest = wave;
        }
        if ((!corrects_envelope(iteration, steps) && wave.shortfall <= accept_margin) || last) {
            auto& chosen = last ? *nearest : wave;
            read_exactly(chosen);
            if (!best || chosen.shortfall < best_shortfall) {
                best = judged(chosen.acceleration_mps2, chosen.ratios, iteration);
                best_shortfall = chosen.shortfall;
            }
        }
        if (last || (best && best->match.matched)) {
            best->match.iterations = iteration;
            return *std::move(best);
        }
        step(lines, wave, envelope, iteration, steps);
    }
}

SpectrumMatcher::Component SpectrumMatcher::make(std::uint64_t seed, std::uint64_t wave, std::uint64_t component,
                                                 Judging judging) const {
    auto const& noise = this->noise();
    auto lines = noise.draw(LineStreams::of_wave(seed, wave, component));
    if (judging == Judging::least && !iterates()) {
        return {.acceleration_mps2 = noise.synthesise(lines, noise.envelope()), .match = {}, .ratios = {}};
    }
    auto made = matched(std::move(lines), {0, EnvelopeStep::correct_once});
    if (judging == Judging::least) {
        return made;
    }
    std::tie(made.match.psd_lowest_ratio, made.match.psd_lowest_hz) = noise.lowest_power(made.acceleration_mps2);
    return made;
}

std::vector<double> SpectrumMatcher::of_normals(std::span<double const> normals) const {
    auto lines = noise().from_normals(normals);
    if (!iterates()) {
        return noise_.synthesise(lines, noise_.envelope());
    }
    return matched(std::move(lines), {0, EnvelopeStep::correct_once}).acceleration_mps2;
}

SpectrumMatcher::Component SpectrumMatcher::match_motion(std::span<double const> acceleration_mps2) const {
    constexpr int plain = 4;  // a record may be far from the target
    auto made = matched(noise_.analyse(acceleration_mps2), {plain, EnvelopeStep::leave});
    std::tie(made.match.psd_lowest_ratio, made.match.psd_lowest_hz) = noise_.lowest_power(made.acceleration_mps2);
    return made;
}

}  // namespace overturn
