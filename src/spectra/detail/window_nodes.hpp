/// Sixteen frequencies at a time of the window energy: their share of V_WES^2 wherever a window may end.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "simd/lane_values.hpp"
#include "spectra/window_energy.hpp"

namespace overturn {

/// Constants of the sums over a window, by their frequencies, and their state from one block of a window's length to
/// the next. Vectors hold 16 lanes per place in a block.
struct WindowNodes {
    std::vector<double> cosine, sine;                ///< exp(-ixj) = cosine - i sine, j inside a block
    std::vector<double> head_re, head_im;            ///< the window's part in the block before, seen from this block
    std::vector<double> past_re, past_im;            ///< the integral from the start to each sample of the last block
    std::vector<double> squares;                     ///< weighted lanes of one block
    simd::LaneValues<> hat_re{}, hat_im{}, whole{};  ///< of HatWeights
    simd::LaneValues<> turn_re{}, turn_im{};         ///< over a block
    simd::LaneValues<> weight{};
    simd::LaneValues<> base_re{}, base_im{};  ///< the integral from the start to this block, seen from it
};

/// Adds the nodes' share of V_WES^2 to `total`, one per sample.
void add_window_squares(std::span<double const> samples, std::size_t window, WindowReading reading, WindowNodes& nodes,
                        std::span<double> total);

}  // namespace overturn
