/// Stopping where friction gives out, and going on from there. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// A step, and where the trial stood before it if friction gives out in it.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::step_with_checkpoint() {
    if constexpr (Friction == Slip::detected) {
        checkpoint_ = {true,   log_.outcome(), log_.energy_at_weaker(), mode_,      start_root_, side_, phi_,
                       omega_, index_,         sample_.tau_s,           steps_here_};
        step();
        checkpoint_.at_hand = log_.outcome().slip_onset;
    } else {
        step();
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
RockingOutcome Integrator<Order, Restoring, Vertical, Friction>::run_from(Checkpoint const& checkpoint) {
    uses_lanes_ = lanes_offered && accuracy_.substeps == 1;
    log_.resume(checkpoint.so_far, checkpoint.energy);
    mode_ = checkpoint.mode;
    start_root_ = checkpoint.start_root;
    stand_on(checkpoint.side);
    phi_ = checkpoint.phi;
    omega_ = checkpoint.omega;
    index_ = checkpoint.index;
    steps_here_ = checkpoint.steps_here;
    sample_.load(shaking_, block_.gravity_mps2, index_);
    sample_.tau_s = checkpoint.tau_s;
    log_.outcome().energy.input = mechanical_energy();
    step();
    while (advance()) {
        step_in_lane();
    }
    return finish();
}

}  // namespace overturn::rocking
