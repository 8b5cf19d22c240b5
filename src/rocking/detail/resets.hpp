/// State after an event: the reset of each mode, except that of an impact (impact.hpp). The guards that call them stand
/// where each mode takes its steps.
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// From full contact onto the corner that an acceleration tips towards, with phi = omega = 0.
void lift(RockingRun& run, double acceleration);

/// From rest to sliding against an acceleration that friction does not hold. With Slip::detected the trial ends.
void start_sliding(RockingRun& run, double acceleration);

/// On a corner: the ground cannot give the friction that no slip needs, so it slips. With Slip::detected the trial
/// ends. \param friction its sign, mirrored
void start_slip(RockingRun& run, double friction);

/// N <= 0 of the whole base: the model ends here.
void lose_contact_at_rest(RockingRun& run);

/// N <= 0 on a corner. On the way out beyond the critical angle the fall is certain, and without contact no torque
/// acts: the block turns on as it is. Elsewhere the model ends here.
void lose_contact(RockingRun& run);

}  // namespace overturn::rocking
