/// Full base contact at rest: it lasts while |a| <= gv min(mu_s, tan alpha).
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// On to the first sample in which the block could move: most of most waves is passed here, whole chunks at a time.
void skip_rest(RockingRun& run);

/// Rest to the sample's end, or to the instant at which it ends.
void step_at_rest(RockingRun& run);

}  // namespace overturn::rocking
