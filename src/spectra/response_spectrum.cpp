#include "spectra/response_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/detail/free_vibration.hpp"
#include "spectra/detail/response_sweep.hpp"
#include "spectra/oscillator.hpp"

namespace overturn {
namespace {

// One step, and what is left of the acceleration's part in it: at its start.
struct Oscillator {
    double w, damping;
    OscillatorStep step;
    double za = step.yy * step.ya1 + step.yv * step.va1 + step.ya0;
    double ua = step.vy * step.ya1 + step.vv * step.va1 + step.va0;

    // Are they units to count in? A step of less than a sixth of the period makes -0.5 to -1 of what follows.
    [[nodiscard]] bool forced(double step_s) const {
        constexpr double least = 0.05;
        return std::abs(za) > least * step_s * step_s && std::abs(ua) > least * step_s;
    }
};

void set_lane(ResponseLanes& lanes, std::size_t lane, Oscillator const& o, bool plain) {
    double const unit_z = plain ? 1 : o.za;
    double const unit_u = plain ? 1 : o.ua;
    lanes.unit_z.at(lane) = unit_z;
    lanes.unit_u.at(lane) = unit_u;
    lanes.zz.at(lane) = o.step.yy;
    lanes.zu.at(lane) = o.step.yv * unit_u / unit_z;
    lanes.za.at(lane) = o.za;
    lanes.ya.at(lane) = o.step.ya1 / unit_z;
    lanes.uz.at(lane) = o.step.vy * unit_z / unit_u;
    lanes.uu.at(lane) = o.step.vv;
    lanes.ua.at(lane) = o.ua;
    lanes.va.at(lane) = o.step.va1 / unit_u;
    lanes.cv.at(lane) = 2 * o.damping * o.w * unit_u;
    lanes.cy.at(lane) = o.w * o.w * unit_z;
}

struct SweptGroup {
    std::size_t begin, end;  // of the periods in their order
    ResponseForm form;
    ResponseLanes lanes;
};

// Visits the periods in groups of at most 16 that take equally many steps per sample; idle lanes repeat the first.
template <class Take>
void sweep(std::span<double const> acceleration, double time_step_s, std::span<double const> periods_s, double damping,
           PeakRule const& rule, SweptPeaks peaks, Take&& take) {
    std::vector<int> steps;
    for (double const period : periods_s) {
        validate(period > 0 && std::isfinite(period), "period {} s (must be positive and finite). Mend it", period);
        steps.push_back(steps_per_sample(period, time_step_s, rule));
    }
    std::vector<std::size_t> order(periods_s.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });
    std::vector<SweptGroup> groups;
    for (std::size_t begin = 0; begin < order.size();) {
        int const shared = steps[order[begin]];
        std::size_t end = begin;
        while (end < order.size() && end - begin < simd::sweep_lanes && steps[order[end]] == shared) {
            ++end;
        }
        double const step_s = time_step_s / shared;
        std::vector<Oscillator> oscillators;
        for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
            double const w = 2 * pi / periods_s[order[begin + lane < end ? begin + lane : begin]];
            oscillators.push_back({w, damping, OscillatorStep(w, damping, step_s)});
        }
        bool const plain =
            !std::ranges::all_of(oscillators, [&](Oscillator const& each) { return each.forced(step_s); });
        groups.push_back({begin, end, {shared, peaks, plain ? ForcingTerm::factor : ForcingTerm::unit}, {}});
        for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
            set_lane(groups.back().lanes, lane, oscillators[lane], plain);
        }
        begin = end;
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        auto& group = groups[g];
        if (g + 1 < groups.size() && groups[g + 1].form == group.form) {
            sweep_response(acceleration, group.form, group.lanes, groups[++g].lanes);
        } else {
            sweep_response(acceleration, group.form, group.lanes);
        }
    }
    for (auto const& group : groups) {
        for (std::size_t lane = 0; group.begin + lane < group.end; ++lane) {
            take(order[group.begin + lane], group.lanes, lane);
        }
    }
}

FreePeaks free_peaks_of(ResponseLanes const& lanes, std::size_t lane, double w, double damping) {
    return free_peaks(w, damping, lanes.unit_z.at(lane) * lanes.end_z.at(lane),
                      lanes.unit_u.at(lane) * lanes.end_u.at(lane));
}

}  // namespace

int steps_per_sample(double period_s, double time_step_s, PeakRule const& rule) {
    constexpr double most = 32;
    constexpr double slack = 1e-9;  // a period of exactly ten steps is not cut for a rounding error
    return static_cast<int>(
        std::clamp(std::ceil(rule.points_per_period * time_step_s / period_s * (1 - slack)), 1.0, most));
}

ResponseSpectrum response_spectrum(std::span<double const> acceleration_mps2, double time_step_s,
                                   std::span<double const> periods_s, double damping, PeakRule const& rule) {
    auto const n = periods_s.size();
    std::vector<double> const none(n, 0.0);
    ResponseSpectrum spectrum{damping, {periods_s.begin(), periods_s.end()}, none, none, none, none, none};
    bool const vibrates = rule.after_end == AfterEnd::vibrates;
    auto const at_rest = vibrates ? come_to_rest(acceleration_mps2) : std::vector<double>{};
    sweep(vibrates ? at_rest : acceleration_mps2, time_step_s, periods_s, damping, rule, SweptPeaks::all,
          [&](std::size_t i, ResponseLanes const& lanes, std::size_t lane) {
              double const w = 2 * pi / periods_s[i];
              auto const behind = vibrates ? free_peaks_of(lanes, lane, w, damping) : FreePeaks{};
              spectrum.sd_m[i] =
                  std::max(std::abs(lanes.unit_z.at(lane)) * std::sqrt(lanes.y2.at(lane)), behind.displacement_m);
              spectrum.sv_mps[i] =
                  std::max(std::abs(lanes.unit_u.at(lane)) * std::sqrt(lanes.v2.at(lane)), behind.velocity_mps);
              spectrum.sa_mps2[i] = std::max(std::sqrt(lanes.a2.at(lane)), behind.acceleration_mps2);
              spectrum.psv_mps[i] = w * spectrum.sd_m[i];
              spectrum.psa_mps2[i] = w * spectrum.psv_mps[i];
          });
    return spectrum;
}

std::vector<double> displacement_spectrum(std::span<double const> acceleration_mps2, double time_step_s,
                                          std::span<double const> periods_s, double damping, PeakRule const& rule) {
    std::vector<double> sd(periods_s.size(), 0.0);
    bool const vibrates = rule.after_end == AfterEnd::vibrates;
    auto const at_rest = vibrates ? come_to_rest(acceleration_mps2) : std::vector<double>{};
    sweep(vibrates ? at_rest : acceleration_mps2, time_step_s, periods_s, damping, rule, SweptPeaks::displacement,
          [&](std::size_t i, ResponseLanes const& lanes, std::size_t lane) {
              auto const behind = vibrates ? free_peaks_of(lanes, lane, 2 * pi / periods_s[i], damping) : FreePeaks{};
              sd[i] = std::max(std::abs(lanes.unit_z.at(lane)) * std::sqrt(lanes.y2.at(lane)), behind.displacement_m);
          });
    return sd;
}

std::vector<double> log_periods(double from_s, double to_s, std::size_t count) {
    validate(from_s > 0 && to_s > from_s && std::isfinite(to_s) && count >= 2,
             "{} periods from {} s to {} s (needs 0 < from < to and at least two). Mend the range", count, from_s,
             to_s);
    std::vector<double> periods(count);
    double const ratio = std::log(to_s / from_s);
    for (std::size_t i = 0; i < count; ++i) {
        periods[i] = from_s * std::exp(ratio * static_cast<double>(i) / static_cast<double>(count - 1));
    }
    periods.back() = to_s;
    return periods;
}

std::vector<double> log_periods_per_decade(double from_s, double to_s, double per_decade) {
    validate(per_decade > 0, "{} periods a decade (must be above 0). Use 100", per_decade);
    double const decades = std::log10(to_s / from_s);
    auto const gaps = std::isfinite(decades) ? std::max(1.0, std::ceil(decades * per_decade - 1e-9)) : 1.0;
    return log_periods(from_s, to_s, static_cast<std::size_t>(gaps) + 1);
}

}  // namespace overturn
