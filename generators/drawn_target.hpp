/// What a wave's own target is, where targets vary.
#pragma once

#include <array>
#include <cstdint>

#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Periods at which a drawn target's epsilon is told [s], in the time that the target is stated in.
inline constexpr std::array epsilon_periods_s{0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

/// What was drawn for a wave.
struct DrawnTarget {
    std::uint64_t number = 0;  ///< waves of one number share a target
    std::uint64_t event = 0;   ///< targets of one event share its part
    /// Standard deviations by which ln Sa lies above the median, at epsilon_periods_s.
    std::array<double, epsilon_periods_s.size()> epsilon{};
    SpectrumShape shape;  ///< drawn over median
};

}  // namespace overturn
