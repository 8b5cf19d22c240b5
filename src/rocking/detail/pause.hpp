/// Trials that stop where friction gives out, and go on from there with slip.
#pragma once

#include "rocking/detail/rocking_events.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

/// rest: full base contact, at rest. slide: full contact, slipping. rock: on one corner, stuck. slip_rock: both.
enum class Mode { rest, slide, rock, slip_rock };

/// Where a trial stood before the step in which friction gave out. Up to there slip changes no bit.
struct Pause {
    bool at_hand = false;  ///< else friction did not give out, or only after the wave
    RockingOutcome so_far;
    double energy = 0;  ///< its peak, over m g R of the weaker corner
    Mode mode = Mode::rest;
    StartRoot start_root = StartRoot::none;
    double side = 1, phi = 0, omega = 0;
    std::size_t index = 0;  ///< of the sample
    double tau_s = 0;       ///< since then
    int steps_here = 0;     ///< within it
};

}  // namespace overturn::rocking

namespace overturn {

/// Many trials as simulate_rocking with Slip::watched, and where those stood that called for slip: pauses[i].
void watch_friction(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy,
                    std::span<RockingOutcome> outcomes, std::span<rocking::Pause> pauses);

/// The rest of a trial with slip: bit-equal to Slip::simulated from the start, but for its energies, which count from
/// the pause on. \pre pause.at_hand, and the trial is the one that paused
[[nodiscard]] RockingOutcome go_on_slipping(RockingTrial const& trial, RockingAccuracy const& accuracy,
                                            rocking::Pause const& pause);

}  // namespace overturn
