/// V_WES^2 as a quadratic form of the samples in the window: one kernel over time differences replaces the oscillators.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spectra/band_rule.hpp"

namespace overturn {

/// sum_i weight_i |int over the last `window` samples of a exp(-i w_i t) dt|^2 at every sample [m2/s2], the window cut
/// at the first sample. Equal to the sweep over the oscillators (window_sweep.hpp) to rounding of the strongest part
/// within ten windows, at a cost that hardly depends on the number of frequencies. Products of samples are weighted by
/// K(d) = sum_i weight_i |hat_i|^2 cos(w_i d dt) and summed over each sample's window by fast convolution; the window
/// then slides, one sample in and one out, in twice the working precision, and is summed anew every eighth window. \pre
/// window >= 1 and time_step_s > 0
[[nodiscard]] std::vector<double> window_squares(std::span<double const> acceleration_mps2, double time_step_s,
                                                 std::size_t window, BandRule const& rule);

}  // namespace overturn
