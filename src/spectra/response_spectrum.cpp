#include "spectra/response_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

using LaneValues = std::array<double, wide::lanes>;

// Coefficients and results of 16 oscillators that share a number of steps per sample.
struct Lanes {
    LaneValues yy, yv, ya0, ya1, vy, vv, va0, va1, cv, cy;
    LaneValues y2, v2, a2;  // largest squares
};

template <bool all> struct Sweep {
    std::span<double const> acceleration;
    int steps;
    Lanes* lanes;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R yy, yv, ya0, ya1, vy, vv, va0, va1, cv, cy, y, v, y2, v2, a2;
        R::load(yy, lanes->yy.data());
        R::load(yv, lanes->yv.data());
        R::load(ya0, lanes->ya0.data());
        R::load(ya1, lanes->ya1.data());
        R::load(vy, lanes->vy.data());
        R::load(vv, lanes->vv.data());
        R::load(va0, lanes->va0.data());
        R::load(va1, lanes->va1.data());
        R::load(cv, lanes->cv.data());
        R::load(cy, lanes->cy.data());
        for (auto* state : {&y, &v, &y2, &v2, &a2}) {
            R::clear(*state);
        }
        double const part = 1.0 / steps;
        for (std::size_t n = 1; n < acceleration.size(); ++n) {
            double const rise = acceleration[n] - acceleration[n - 1];
            double a0 = acceleration[n - 1];
            for (int s = 1; s <= steps; ++s) {
                double const a1 = s == steps ? acceleration[n] : acceleration[n - 1] + rise * (s * part);
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const next = yy.at[r] * y.at[r] + yv.at[r] * v.at[r] + (ya0.at[r] * a0 + ya1.at[r] * a1);
                    v.at[r] = vy.at[r] * y.at[r] + vv.at[r] * v.at[r] + (va0.at[r] * a0 + va1.at[r] * a1);
                    y.at[r] = next;
                    auto const yy2 = next * next;
                    y2.at[r] = yy2 > y2.at[r] ? yy2 : y2.at[r];
                    if constexpr (all) {
                        auto const vv2 = v.at[r] * v.at[r];
                        auto const absolute = cv.at[r] * v.at[r] + cy.at[r] * next;
                        auto const aa2 = absolute * absolute;
                        v2.at[r] = vv2 > v2.at[r] ? vv2 : v2.at[r];
                        a2.at[r] = aa2 > a2.at[r] ? aa2 : a2.at[r];
                    }
                }
                a0 = a1;
            }
        }
        R::store(lanes->y2.data(), y2);
        R::store(lanes->v2.data(), v2);
        R::store(lanes->a2.data(), a2);
    }
};

void set_lane(Lanes& lanes, std::size_t lane, double w, double damping, double step_s) {
    OscillatorStep const c(w, damping, step_s);
    lanes.yy.at(lane) = c.yy;
    lanes.yv.at(lane) = c.yv;
    lanes.ya0.at(lane) = c.ya0;
    lanes.ya1.at(lane) = c.ya1;
    lanes.vy.at(lane) = c.vy;
    lanes.vv.at(lane) = c.vv;
    lanes.va0.at(lane) = c.va0;
    lanes.va1.at(lane) = c.va1;
    lanes.cv.at(lane) = 2 * damping * w;
    lanes.cy.at(lane) = w * w;
}

// Visits the periods in groups of at most 16 that take equally many steps per sample; idle lanes repeat the first.
template <bool all, class Take>
void sweep(std::span<double const> acceleration, double time_step_s, std::span<double const> periods_s, double damping,
           PeakRule const& rule, Take&& take) {
    std::vector<int> steps;
    for (double const period : periods_s) {
        validate(period > 0 && std::isfinite(period), "period {} s (must be positive and finite). Mend it", period);
        steps.push_back(steps_per_sample(period, time_step_s, rule));
    }
    std::vector<std::size_t> order(periods_s.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });
    for (std::size_t begin = 0; begin < order.size();) {
        int const shared = steps[order[begin]];
        std::size_t end = begin;
        while (end < order.size() && end - begin < wide::lanes && steps[order[end]] == shared) {
            ++end;
        }
        Lanes lanes{};
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            double const period = periods_s[order[begin + lane < end ? begin + lane : begin]];
            set_lane(lanes, lane, 2 * pi / period, damping, time_step_s / shared);
        }
        wide::dispatch(Sweep<all>{acceleration, shared, &lanes});
        for (std::size_t lane = 0; begin + lane < end; ++lane) {
            take(order[begin + lane], lanes, lane);
        }
        begin = end;
    }
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
    sweep<true>(acceleration_mps2, time_step_s, periods_s, damping, rule,
                [&](std::size_t i, Lanes const& lanes, std::size_t lane) {
                    double const w = 2 * pi / periods_s[i];
                    spectrum.sd_m[i] = std::sqrt(lanes.y2.at(lane));
                    spectrum.sv_mps[i] = std::sqrt(lanes.v2.at(lane));
                    spectrum.sa_mps2[i] = std::sqrt(lanes.a2.at(lane));
                    spectrum.psv_mps[i] = w * spectrum.sd_m[i];
                    spectrum.psa_mps2[i] = w * spectrum.psv_mps[i];
                });
    return spectrum;
}

std::vector<double> displacement_spectrum(std::span<double const> acceleration_mps2, double time_step_s,
                                          std::span<double const> periods_s, double damping, PeakRule const& rule) {
    std::vector<double> sd(periods_s.size(), 0.0);
    sweep<false>(acceleration_mps2, time_step_s, periods_s, damping, rule,
                 [&](std::size_t i, Lanes const& lanes, std::size_t lane) { sd[i] = std::sqrt(lanes.y2.at(lane)); });
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
