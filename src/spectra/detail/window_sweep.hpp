/// V_WES^2 by sweeping the oscillators of every frequency over the wave: the plain definition, for both readings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spectra/window_energy.hpp"

namespace overturn {

/// sum_i weight_i |F_i|^2 at every sample [m2/s2], F_i the oscillator's answer to the last `window` samples as
/// `reading` understands it. Window sums are built from sums inside blocks of one window, never from differences of
/// running totals. \pre window >= 1, time_step_s > 0, at least one sample
[[nodiscard]] std::vector<double> swept_window_squares(std::span<double const> acceleration_mps2, double time_step_s,
                                                       std::size_t window, BandRule const& rule, WindowReading reading);

}  // namespace overturn
