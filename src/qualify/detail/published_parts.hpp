/// The published results by what they are of.
#pragma once

#include "qualify/check.hpp"

namespace overturn::qualify {

/// With these a remark begins where the source itself gives no number.
/// @{
inline constexpr char const* derived = "derived again, the paper was not at hand";
inline constexpr char const* solved_again = "solved again";
/// @}

/// Pulses that overturn a block.
[[nodiscard]] Checks published_pulses();
/// Fragility curves fitted to printed data.
[[nodiscard]] Checks published_fits();
/// Impulses, bounds and impacts of the block in a plane.
[[nodiscard]] Checks published_impulses();
/// Printed numbers that are wrong, and why. \param least_half_sine over alpha g, at omega/p 4, of the linearised block
[[nodiscard]] Checks published_apart(double least_half_sine);
/// A round base: rolling, and no direction.
[[nodiscard]] Checks published_round_bases();

}  // namespace overturn::qualify
