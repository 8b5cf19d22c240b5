/// The input energy spectrum: what a wave feeds into an oscillator, as an equivalent velocity (Akiyama 1985).
#pragma once

#include <span>
#include <vector>

namespace overturn {

/// V_E(T, zeta) = sqrt(2 E / m), E/m = -int a y' dt up to the last sample [m/s], the integral taken exactly for
/// acceleration that is linear between samples. An energy that rounding makes negative reads 0. Against the closed form
/// for no damping it errs by less than 1e-10 from w dt = 1e-4 to 60.
[[nodiscard]] std::vector<double> input_energy_velocities(std::span<double const> acceleration_mps2, double time_step_s,
                                                          std::span<double const> periods_s, double damping);

/// The same without damping: exactly |int a exp(-iwt) dt| [m/s], no oscillator run.
[[nodiscard]] std::vector<double> undamped_energy_velocities(std::span<double const> acceleration_mps2,
                                                             double time_step_s, std::span<double const> periods_s);

}  // namespace overturn
