/// A zero-phase low-pass for what is to be read on a coarser time grid.
#pragma once

#include <span>
#include <vector>

namespace overturn {

/// Frequencies that a new grid can hold: kept up to 0.8 of its Nyquist frequency, removed from that frequency on.
struct LowPass {
    double pass_hz = 0;  ///< up to here 0.01 % are kept off at most [Hz]
    double stop_hz = 0;  ///< from here on 1/10000 is left [Hz]

    [[nodiscard]] static LowPass for_step(double time_step_s);
};

/// Values at multiples of `to_step_s` of a series, zero outside, under a symmetric kernel: a sinc in a Kaiser window of
/// 80 dB (Kaiser 1974), whose sum over the samples is one. \pre the new step is the longer one
[[nodiscard]] std::vector<double> low_passed(std::span<double const> values, double time_step_s, double to_step_s,
                                             std::size_t count);

}  // namespace overturn
