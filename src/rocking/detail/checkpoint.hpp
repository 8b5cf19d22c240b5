/// Trials that stop where friction gives out, and go on from there with slip.
#pragma once

#include "rocking/detail/rocking_events.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

/// rest: full base contact, at rest. slide: full contact, slipping. rock: on one corner, stuck. slip_rock: both.
enum class Mode { rest, slide, rock, slip_rock };

/// Where a trial stood before the step in which friction gave out. Up to there slip changes no bit.
struct Checkpoint {
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

/// Many trials as simulate_rocking with Slip::detected, and where those stood that called for slip: checkpoints[i].
void simulate_until_slip(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy,
                         std::span<RockingOutcome> outcomes, std::span<rocking::Checkpoint> checkpoints);

/// The rest of a trial with slip: bit-equal to Slip::simulated from the start, but for its energies, which count from
/// the checkpoint on. \pre checkpoint.at_hand, and the trial is the one that stopped there
[[nodiscard]] RockingOutcome resume_sliding(RockingTrial const& trial, RockingAccuracy const& accuracy,
                                            rocking::Checkpoint const& checkpoint);

}  // namespace overturn
