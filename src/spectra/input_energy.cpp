#include "spectra/input_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/fourier.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

using LaneValues = std::array<double, wide::lanes>;

struct Lanes {
    LaneValues yy, yv, ya0, ya1, vy, vv, va0, va1, my, mv, ma0, ma1;
    LaneValues energy;
};

struct EnergySweep {
    std::span<double const> acceleration;
    Lanes* lanes;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R yy, yv, ya0, ya1, vy, vv, va0, va1, my, mv, ma0, ma1, y, v, energy;
        R::load(yy, lanes->yy.data());
        R::load(yv, lanes->yv.data());
        R::load(ya0, lanes->ya0.data());
        R::load(ya1, lanes->ya1.data());
        R::load(vy, lanes->vy.data());
        R::load(vv, lanes->vv.data());
        R::load(va0, lanes->va0.data());
        R::load(va1, lanes->va1.data());
        R::load(my, lanes->my.data());
        R::load(mv, lanes->mv.data());
        R::load(ma0, lanes->ma0.data());
        R::load(ma1, lanes->ma1.data());
        R::clear(y);
        R::clear(v);
        R::clear(energy);
        for (std::size_t n = 1; n < acceleration.size(); ++n) {
            double const a0 = acceleration[n - 1];
            double const a1 = acceleration[n];
#pragma GCC unroll 8
            for (int r = 0; r < R::count; ++r) {
                auto const step = [&](R const& of_y, R const& of_v, R const& of_a0, R const& of_a1)
                    __attribute__((always_inline)) {
                    auto const forced = wide::fma(of_a1.at[r], a1, of_a0.at[r] * a0);
                    return wide::fma(y.at[r], of_y.at[r], wide::fma(v.at[r], of_v.at[r], forced));
                };
                auto const next = step(yy, yv, ya0, ya1);
                auto const mean = step(my, mv, ma0, ma1);
                v.at[r] = step(vy, vv, va0, va1);
                // int a y' over the step, by parts: a0 (y1 - y0) + (a1 - a0) (y1 - mean y).
                energy.at[r] = energy.at[r] - (a0 * (next - y.at[r]) + (a1 - a0) * (next - mean));
                y.at[r] = next;
            }
        }
        R::store(lanes->energy.data(), energy);
    }
};

void set_lane(Lanes& lanes, std::size_t lane, OscillatorStep const& c) {
    lanes.yy.at(lane) = c.yy;
    lanes.yv.at(lane) = c.yv;
    lanes.ya0.at(lane) = c.ya0;
    lanes.ya1.at(lane) = c.ya1;
    lanes.vy.at(lane) = c.vy;
    lanes.vv.at(lane) = c.vv;
    lanes.va0.at(lane) = c.va0;
    lanes.va1.at(lane) = c.va1;
    lanes.my.at(lane) = c.my;
    lanes.mv.at(lane) = c.mv;
    lanes.ma0.at(lane) = c.ma0;
    lanes.ma1.at(lane) = c.ma1;
}

void check_periods(std::span<double const> periods_s) {
    for (double const period : periods_s) {
        validate(period > 0 && std::isfinite(period), "period {} s (must be positive and finite). Mend it", period);
    }
}

}  // namespace

std::vector<double> input_energy_velocities(std::span<double const> acceleration_mps2, double time_step_s,
                                            std::span<double const> periods_s, double damping) {
    check_periods(periods_s);
    std::vector<double> velocities(periods_s.size(), 0.0);
    for (std::size_t begin = 0; begin < periods_s.size(); begin += wide::lanes) {
        Lanes lanes{};
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            double const period = periods_s[std::min(begin + lane, periods_s.size() - 1)];
            set_lane(lanes, lane, OscillatorStep(2 * pi / period, damping, time_step_s));
        }
        wide::dispatch(EnergySweep{acceleration_mps2, &lanes});
        for (std::size_t lane = 0; lane < wide::lanes && begin + lane < periods_s.size(); ++lane) {
            velocities[begin + lane] = std::sqrt(2 * std::max(0.0, lanes.energy.at(lane)));
        }
    }
    return velocities;
}

std::vector<double> undamped_energy_velocities(std::span<double const> acceleration_mps2, double time_step_s,
                                               std::span<double const> periods_s) {
    check_periods(periods_s);
    std::vector<double> frequencies;
    for (double const period : periods_s) {
        frequencies.push_back(2 * pi / period);
    }
    std::vector<double> velocities;
    for (auto const& amplitude : fourier_amplitudes(acceleration_mps2, time_step_s, frequencies)) {
        velocities.push_back(std::abs(amplitude));
    }
    return velocities;
}

}  // namespace overturn
