#include "spectra/input_energy.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/detail/energy_sweep.hpp"
#include "spectra/detail/fourier.hpp"
#include "spectra/oscillator.hpp"

namespace overturn {
namespace {

void set_lane(EnergyLanes& lanes, std::size_t lane, OscillatorStep const& c) {
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
    for (std::size_t begin = 0; begin < periods_s.size(); begin += simd::sweep_lanes) {
        EnergyLanes lanes{};
        for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
            double const period = periods_s[std::min(begin + lane, periods_s.size() - 1)];
            set_lane(lanes, lane, OscillatorStep(2 * pi / period, damping, time_step_s));
        }
        sweep_energy(acceleration_mps2, lanes);
        for (std::size_t lane = 0; lane < simd::sweep_lanes && begin + lane < periods_s.size(); ++lane) {
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
