/// The published results by what they are of.
#pragma once

#include "qualify/check.hpp"

namespace overturn::qualify {

/// Of what could not be consulted.
inline constexpr char const* derived = "derived again, the paper was not at hand";

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
