/// Sixteen oscillators at a time over all lines of a wave's spectrum: what each band of lines adds to them.
#pragma once

#include <complex>
#include <cstddef>
#include <span>

#include "simd/lane_values.hpp"

namespace overturn {

/// In single precision, which is far more than a step of first order needs. Frequencies are counted in lines.
struct LineOscillators {
    simd::LaneValues<float> frequency, twice_damped;  ///< w, 2 zeta w
    simd::LaneValues<float> turn_cos, turn_sin;       ///< of the lines' spacing times the oscillator's instant
    simd::LaneValues<float> start_cos, start_sin;     ///< of the first line's frequency times the instant
};

/// Per band, Re(H L exp(i w t)) of its lines at each oscillator's own instant.
/// \param sums 16 of the first band, 16 of the second, ...
void sum_lines(std::span<std::complex<double> const> lines, std::span<std::size_t const> band_end,
               std::size_t first_line, LineOscillators const& oscillators, std::span<float> sums);

}  // namespace overturn
