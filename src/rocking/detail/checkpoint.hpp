/// Trials that stop where friction gives out, and go on from there with slip.
#pragma once

#include "rocking/detail/state.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

/// State of a trial before the step in which friction was exceeded. Up to there slip changes no bit.
struct Checkpoint {
    bool reached = false;  ///< else friction did not give out, or only after the wave
    RockingOutcome so_far;
    double energy = 0;  ///< its peak, over m g R of the weaker corner
    State state;
    Progress progress;
    double tau_s = 0;  ///< since the sample
};

}  // namespace overturn::rocking

namespace overturn {

/// Many trials as simulate_rocking with Slip::detected, and where those stood that called for slip: checkpoints[i].
void simulate_until_slip(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy,
                         std::span<RockingOutcome> outcomes, std::span<rocking::Checkpoint> checkpoints);

/// The rest of a trial with slip: bit-equal to Slip::simulated from the start, but for its energies, which count from
/// the checkpoint on. \pre checkpoint.reached, and the trial is the one that stopped there
[[nodiscard]] RockingOutcome resume_sliding(RockingTrial const& trial, RockingAccuracy const& accuracy,
                                            rocking::Checkpoint const& checkpoint);

}  // namespace overturn
