/// Numbers for the lanes of a sweep that takes equally many on every machine.
#pragma once

#include <array>
#include <cstddef>

namespace overturn::simd {

/// Lanes that a sweep takes at once: two registers of AVX-512's doubles, four of AVX2's. Spectra are padded to a
/// multiple of it.
inline constexpr std::size_t sweep_lanes = 16;

template <class Number = double> using LaneValues = std::array<Number, sweep_lanes>;

}  // namespace overturn::simd
