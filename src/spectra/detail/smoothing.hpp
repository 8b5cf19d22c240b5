/// A signal smoothed by a kernel and thinned.
#pragma once

#include <cstddef>
#include <span>

namespace overturn {

/// smoothed[m] = sum_t kernel[t] signal[m stride + t], in an order of its own that is the same on every machine.
/// \param kernel a multiple of simd::sweep_lanes long
/// \param signal goes on for a kernel after the last one's start
/// \param smoothed an even number
void smooth(std::span<double const> kernel, std::span<double const> signal, std::size_t stride,
            std::span<double> smoothed);

}  // namespace overturn
