/// Rocking on one corner without slip, where lanes do not step it: steps that may hold an event other than a clear
/// impact, substeps, other orders, the linearised block, blocks without inertia of their own.
#pragma once

#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

void step_stuck(RockingRun& run);

/// Whether friction or contact gives out within the next `length_s`, of a block that step_lanes can step.
[[nodiscard]] bool gives_out_within(RockingRun const& run, double length_s);

}  // namespace overturn::rocking
