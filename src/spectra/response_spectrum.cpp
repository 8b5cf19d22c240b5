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

// Coefficients and results of 16 oscillators that share a number of steps per sample. What the acceleration at the end
// of a step adds is kept apart from the state, so that each step takes one forcing term; and the state is counted in
// what that term makes of a unit, so that it takes no product:
// y = unit_z (z + ya a), v = unit_u (u + va a), z1 = zz z0 + zu u0 + a0, u1 = uz z0 + uu u0 + a0.
struct Lanes {
    LaneValues zz, zu, za, ya, uz, uu, ua, va, cv, cy;
    LaneValues unit_z, unit_u;
    LaneValues y2, v2, a2;  // largest squares, of y over unit_z and v over unit_u
};

template <bool all> struct Sweep {
    std::span<double const> acceleration;
    int steps;
    bool plain;  // some lane's forcing term is too small to count in: units are 1, za and ua factors of a0
    Lanes* lanes;

    template <int bytes> OVERTURN_INLINE void run() const { plain ? go<bytes, true>() : go<bytes, false>(); }

    template <int bytes, bool factors> OVERTURN_INLINE void go() const {
        using R = wide::Registers<bytes>;
        R zz, zu, za, ya, uz, uu, ua, va, cv, cy, z, u, y2, v2, a2;
        R::load(zz, lanes->zz.data());
        R::load(zu, lanes->zu.data());
        R::load(za, lanes->za.data());
        R::load(ya, lanes->ya.data());
        R::load(uz, lanes->uz.data());
        R::load(uu, lanes->uu.data());
        R::load(ua, lanes->ua.data());
        R::load(va, lanes->va.data());
        R::load(cv, lanes->cv.data());
        R::load(cy, lanes->cy.data());
        for (auto* largest : {&y2, &v2, &a2}) {
            R::clear(*largest);
        }
        double const before = acceleration.empty() ? 0 : acceleration[0];
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            z.at[r] = ya.at[r] * -before;
            u.at[r] = va.at[r] * -before;
        }
        double const part = 1.0 / steps;
        for (std::size_t n = 1; n < acceleration.size(); ++n) {
            double const rise = acceleration[n] - acceleration[n - 1];
            double a0 = acceleration[n - 1];
            for (int s = 1; s <= steps; ++s) {
                double const a1 = s == steps ? acceleration[n] : acceleration[n - 1] + rise * (s * part);
                auto const filled = wide::filled<typename R::Vector>(a0);
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const z0 = factors ? za.at[r] * a0 : filled;
                    auto const u0 = factors ? ua.at[r] * a0 : filled;
                    auto const next = wide::fma(z.at[r], zz.at[r], wide::fma(u.at[r], zu.at[r], z0));
                    u.at[r] = wide::fma(z.at[r], uz.at[r], wide::fma(u.at[r], uu.at[r], u0));
                    z.at[r] = next;
                    auto const y = wide::fma(ya.at[r], a1, next);
                    y2.at[r] = wide::max(y * y, y2.at[r]);
                    if constexpr (all) {
                        auto const v = wide::fma(va.at[r], a1, u.at[r]);
                        auto const absolute = wide::fma(v, cv.at[r], cy.at[r] * y);
                        v2.at[r] = wide::max(v * v, v2.at[r]);
                        a2.at[r] = wide::max(absolute * absolute, a2.at[r]);
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

void set_lane(Lanes& lanes, std::size_t lane, Oscillator const& o, bool plain) {
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
        double const step_s = time_step_s / shared;
        std::vector<Oscillator> oscillators;
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            double const w = 2 * pi / periods_s[order[begin + lane < end ? begin + lane : begin]];
            oscillators.push_back({w, damping, OscillatorStep(w, damping, step_s)});
        }
        bool const plain =
            !std::ranges::all_of(oscillators, [&](Oscillator const& each) { return each.forced(step_s); });
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            set_lane(lanes, lane, oscillators[lane], plain);
        }
        wide::dispatch(Sweep<all>{acceleration, shared, plain, &lanes});
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
                    spectrum.sd_m[i] = std::abs(lanes.unit_z.at(lane)) * std::sqrt(lanes.y2.at(lane));
                    spectrum.sv_mps[i] = std::abs(lanes.unit_u.at(lane)) * std::sqrt(lanes.v2.at(lane));
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
                 [&](std::size_t i, Lanes const& lanes, std::size_t lane) {
                     sd[i] = std::abs(lanes.unit_z.at(lane)) * std::sqrt(lanes.y2.at(lane));
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
