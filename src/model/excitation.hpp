/// Excitation of a body: one ground motion at one level.
#pragma once

#include <limits>
#include <span>

#include "model/chunk_extremes.hpp"

namespace overturn {

/// Views only: linear between samples, zero after the last one. Components that are there agree in length.
struct Excitation {
    std::span<double const> horizontal_mps2;    ///< in the rocking plane [m/s2]
    std::span<double const> transverse_mps2{};  ///< the other horizontal one; empty where the effect is off [m/s2]
    std::span<double const> vertical_mps2{};    ///< upwards positive; empty where the effect is off [m/s2]
    double time_step_s = 0;
    double scale = 1;  ///< multiplies every component
    /// Largest |horizontal| if it is known: rest is then seen by one comparison [m/s2]
    double peak_mps2 = std::numeric_limits<double>::infinity();
    ChunkExtremes const* chunks = nullptr;  ///< of horizontal and vertical, if at hand: rest is then passed by chunks
};

}  // namespace overturn
