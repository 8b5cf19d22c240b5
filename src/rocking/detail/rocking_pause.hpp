/// Stopping where friction gives out, and going on from there. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// A step, and where the trial stood before it if friction gives out in it.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::step_watched() {
    if constexpr (Friction == Slip::watched) {
        pause_ = {true,   log_.outcome(), log_.energy_at_weaker(), mode_,      start_root_, side_, phi_,
                  omega_, index_,         sample_.tau_s,           steps_here_};
        step();
        pause_.at_hand = log_.outcome().slip_called;
    } else {
        step();
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
RockingOutcome Integrator<Order, Restoring, Vertical, Friction>::run_from(Pause const& pause) {
    steps_together_ = swings && accuracy_.substeps == 1;
    log_.resume(pause.so_far, pause.energy);
    mode_ = pause.mode;
    start_root_ = pause.start_root;
    stand_on(pause.side);
    phi_ = pause.phi;
    omega_ = pause.omega;
    index_ = pause.index;
    steps_here_ = pause.steps_here;
    sample_.load(shaking_, block_.gravity_mps2, index_);
    sample_.tau_s = pause.tau_s;
    log_.outcome().energy.input = mechanical_energy();
    step();
    while (advance()) {
        swing();
    }
    return finish();
}

}  // namespace overturn::rocking
