#include "generators/detail/spectrum_probe.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {

double JudgedPeriods::ratio(std::size_t i, double displacement_m) const {
    return std::abs(displacement_m) * 2 * pi / (period_s[i] * target_mps[i]);
}

std::vector<double> JudgedPeriods::at(std::span<std::size_t const> chosen) const {
    std::vector<double> found;
    found.reserve(chosen.size());
    for (auto const i : chosen) {
        found.push_back(period_s[i]);
    }
    return found;
}

SpectrumProbe::SpectrumProbe(JudgedPeriods judged, std::vector<std::size_t> chosen, double damping,
                             NoiseLines const& noise)
    : judged_(std::move(judged)),
      chosen_(std::move(chosen)),
      time_step_s_(noise.time_step_s()),
      sweep_(judged_.at(chosen_), damping, time_step_s_),
      gains_(judged_.at(chosen_), damping, noise.spacing_radps(), noise.first(), noise.count()),
      slow_(judged_.at(chosen_), damping, noise) {
    OVERTURN_EXPECT(!chosen_.empty() && chosen_.front() == 0 && chosen_.back() + 1 == judged_.period_s.size());
}

std::vector<double> SpectrumProbe::ratios(std::span<PeakDisplacement const> peaks) const {
    std::vector<double> values(judged_.period_s.size());
    values[0] = judged_.ratio(0, peaks[0].displacement_m);
    for (std::size_t c = 1; c < chosen_.size(); ++c) {
        std::size_t const left = chosen_[c - 1];
        std::size_t const right = chosen_[c];
        values[right] = judged_.ratio(right, peaks[c].displacement_m);
        double const rise = (values[right] - values[left]) / static_cast<double>(right - left);
        for (std::size_t i = left + 1; i < right; ++i) {
            values[i] = values[left] + rise * static_cast<double>(i - left);
        }
    }
    return values;
}

// A chosen period's own ratio; or, if it keeps the rule, that of the period left out beside it which breaks it most.
double SpectrumProbe::governing_ratio(std::span<double const> ratios, std::size_t c, AcceptanceRule const& rule) const {
    double const chosen = ratios[chosen_[c]];
    auto const breach = [&](double ratio) {
        return std::max((rule.lowest_ratio - ratio) / rule.lowest_ratio, ratio / rule.highest_ratio - 1);
    };
    if (!rule.enabled() || breach(chosen) > 0) {
        return chosen;
    }
    double answer = chosen;
    double worst = 0;
    std::size_t const from = c > 0 ? chosen_[c - 1] + 1 : chosen_[c];
    std::size_t const to = c + 1 < chosen_.size() ? chosen_[c + 1] : chosen_[c] + 1;
    for (std::size_t i = from; i < to; ++i) {
        if (breach(ratios[i]) > worst) {
            worst = breach(ratios[i]);
            answer = ratios[i];
        }
    }
    return answer;
}

std::vector<double> SpectrumProbe::wanted(std::span<double const> ratios, AcceptanceRule const& rule) const {
    std::vector<double> goals(chosen_.size());
    for (std::size_t c = 0; c < chosen_.size(); ++c) {
        goals[c] = rule.aim / governing_ratio(ratios, c, rule);
    }
    return goals;
}

std::vector<double> SpectrumProbe::strength(std::span<PeakDisplacement const> peaks,
                                            std::span<double const> envelope) const {
    std::vector<double> at_peak(chosen_.size());
    for (std::size_t c = 0; c < chosen_.size(); ++c) {
        auto const sample = static_cast<std::size_t>(peaks[c].time_s / time_step_s_);
        at_peak[c] = envelope[std::min(sample, envelope.size() - 1)];
    }
    return at_peak;
}

void SpectrumProbe::step(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
                         std::span<double const> envelope, AcceptanceRule const& rule, LineGains::Trust trust) const {
    gains_.apply(lines, peaks, strength(peaks, envelope), wanted(ratios, rule), trust);
}

void SpectrumProbe::step_slow(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
                              std::span<double const> envelope, AcceptanceRule const& rule,
                              NoiseLines const& noise) const {
    auto goals = wanted(ratios, rule);
    slow_.apply(lines, peaks, goals, envelope, noise);
    for (std::size_t c = 0; c < chosen_.size(); ++c) {
        goals[c] = judged_.period_s[chosen_[c]] < LongPeriodStep::from_s ? goals[c] : 1;
    }
    gains_.apply(lines, peaks, strength(peaks, envelope), goals, LineGains::Trust::much);
}

}  // namespace overturn
