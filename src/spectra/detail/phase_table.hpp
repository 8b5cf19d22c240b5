/// The phases that direct sums take their terms from. Included by direct_sums.cpp only.
#pragma once

#include <array>
#include <cstddef>

#include "simd/lane_values.hpp"

namespace overturn {

struct PhaseTable {
    static constexpr std::size_t block = 128;  ///< its phases of 16 frequencies fill 32 kB

    std::array<double, simd::sweep_lanes * block>
        cosine;  ///< of x j, j inside a block: 16 x of j = 0, 16 of j = 1, ...
    std::array<double, simd::sweep_lanes * block> sine;
    simd::LaneValues<> turn_cosine, turn_sine;  ///< over a whole block
    simd::LaneValues<> real, imaginary;         ///< of the sums
};

}  // namespace overturn
