/// The base impact of a block on one corner, the bouncing that settles, and the fall that ends on its side.
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// Reset of an impact: phi = 0, omega -> e omega on the other corner; the slip velocity by the friction-limited
/// impulse. Where the shaking does not hold the block in motion, bounces that have become slow settle.
void apply_impact(RockingRun& run);

/// The same of a corner that did not slip: it looks at the contact forces just before, where the corner carries least
/// as the block turns fastest.
void land_and_apply_impact(RockingRun& run);

/// Contact forces just before a corner that does not slip lands at this angular velocity under the shaking of now.
/// \pre nonlinear restoring
[[nodiscard]] ContactForces<double> landing_forces(RockingRun const& run, double omega);

/// Reset of a tilt that has reached pi/2: the block lies, and the trial ends. A corner that did not slip carries least
/// and grips most here, where it turns fastest.
void overturn_now(RockingRun& run);

}  // namespace overturn::rocking
