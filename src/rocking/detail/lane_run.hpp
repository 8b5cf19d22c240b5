/// A trial's steps without slip in vector lanes: into a lane, out of it, and alone.
#pragma once

#include "rocking/detail/lane_step.hpp"
#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// Friction without a limit, as a number that may be multiplied.
inline constexpr double unlimited = 1e300;

template <int Lanes> void load_lane(RockingRun const& run, RockingFields<Lanes>& lanes, int lane);
template <int Lanes> void store_lane(RockingRun& run, RockingFields<Lanes> const& lanes, int lane);

/// On to the next instant that needs care, alone.
void step_in_lane(RockingRun& run);

/// Near the limit of friction step_lanes stops. If the corner does not slip in the next step after all, takes that step
/// in the lane, as if there were no limit: a limit that is never reached may change no bit. \return false if no step
/// was taken
[[nodiscard]] bool step_unless_slip(RockingRun& run);

}  // namespace overturn::rocking
