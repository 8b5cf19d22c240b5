/// Sixteen damped oscillators at a time over a wave: what energy each takes in.
#pragma once

#include <span>

#include "simd/lane_values.hpp"

namespace overturn {

/// Coefficients of OscillatorStep and the result, per mass of the oscillator.
struct EnergyLanes {
    simd::LaneValues<> yy, yv, ya0, ya1;  ///< displacement at the end of a step
    simd::LaneValues<> vy, vv, va0, va1;  ///< velocity there
    simd::LaneValues<> my, mv, ma0, ma1;  ///< mean displacement over the step
    simd::LaneValues<> energy;            ///< taken in until the wave is over [J/kg]
};

/// From rest, `acceleration_mps2` a straight line between samples. Fills lanes.energy.
void sweep_energy(std::span<double const> acceleration_mps2, EnergyLanes& lanes);

}  // namespace overturn
