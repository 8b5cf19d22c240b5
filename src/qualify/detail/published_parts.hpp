/// The published results by what they are of.
#pragma once

#include "qualify/check.hpp"

namespace overturn::qualify {

/// Fragility curves fitted to printed data.
[[nodiscard]] Checks published_fits();
/// Impulses, bounds and impacts of the block in a plane.
[[nodiscard]] Checks published_impulses();
/// A round base: rolling, and no direction.
[[nodiscard]] Checks published_round_bases();

}  // namespace overturn::qualify
