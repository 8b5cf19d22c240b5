/// The base impact of a block on one corner, and the bouncing that settles.
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// Reset of an impact: phi = 0, omega -> e omega on the other corner; the slip velocity by the friction-limited
/// impulse. Where the shaking does not hold the block in motion, bounces that have become slow settle.
void apply_impact(RockingRun& run);

/// The same of a corner that did not slip: it looks at the contact forces just before, where the corner carries least
/// as the block turns fastest.
void land_and_apply_impact(RockingRun& run);

}  // namespace overturn::rocking
