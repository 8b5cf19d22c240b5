/// Slip under Coulomb friction: of the whole base, and of the corner that the block rocks on.
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// Full base contact: x'' = -a - mu_k sigma gv, a cubic in time, exact. Friction below tan(alpha) cannot tip it.
void step_sliding(RockingRun& run);

/// On a corner.
void step_slipping(RockingRun& run);

}  // namespace overturn::rocking
