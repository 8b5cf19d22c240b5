/// The target of one wave, where targets vary.
#pragma once

#include <array>
#include <cstdint>

#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Periods at which a drawn target's epsilon is reported [s], in the time that the target is stated in.
inline constexpr std::array epsilon_periods_s{0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 10.0};

/// Deviations at these, in standard deviations.
using Epsilons = std::array<double, epsilon_periods_s.size()>;

/// The target drawn for a wave.
struct DrawnTarget {
    std::uint64_t number = 0;  ///< waves of one number share a target
    std::uint64_t event = 0;   ///< targets of one event share its part
    Epsilons epsilon{};        ///< of ln Sa above the median
    /// The event's part and the target's part, where both are stated, each in its own standard deviations: sigma
    /// epsilon = between epsilon_between + within epsilon_within. Else 0: no condition is stated beside them.
    Epsilons epsilon_between{}, epsilon_within{};
    SpectrumShape shape;  ///< drawn over median
};

}  // namespace overturn
