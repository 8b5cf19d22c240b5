#include "rocking/detail/resets.hpp"

#include <cmath>
#include <limits>

namespace overturn::rocking {

void lift(RockingRun& run, double acceleration) {
    run.state.mode = Mode::rock;
    run.stand_on(acceleration > 0 ? -1.0 : 1.0);
    run.state.phi = 0;
    run.state.omega = 0;
    run.state.start_root = StartRoot::twofold;
}

void start_sliding(RockingRun& run, double acceleration) {
    if (!run.setup.slipping()) {
        run.log.end_at_slip();
        return;
    }
    run.state.mode = Mode::slide;
    run.state.slip_sign = acceleration > 0 ? -1.0 : 1.0;
    run.state.slip_velocity_mps = 0;
    run.state.slipped = true;
    run.log.raise_demand(run.setup.block.friction_static);
}

void start_slip(RockingRun& run, double friction) {
    if (!run.setup.slipping()) {
        run.log.end_at_slip();
        return;
    }
    auto& state = run.state;
    auto const& block = run.setup.block;
    state.slip_sign = -state.side * std::copysign(1.0, friction);
    state.slip_velocity_mps = 0;
    state.slipped = true;
    run.log.raise_demand(block.friction_static);
    // A base that has not left the ground yet slides flat if kinetic friction is too small to tip it, mu_k <= b / h.
    bool const flat = state.start_root == StartRoot::twofold && block.friction_kinetic <= run.corner().base_ratio;
    state.mode = flat ? Mode::slide : Mode::slip_rock;
}

void lose_contact_at_rest(RockingRun& run) {
    run.log.outcome().contact_lost_s = run.sample.now();
    run.log.lower_contact(0);
    run.log.end(Verdict::contact_lost);
}

void lose_contact(RockingRun& run) {
    auto const& state = run.state;
    if (state.mode == Mode::rock) {  // without slip, whatever N is, F is not zero: F / N has no bound
        run.log.raise_demand(std::numeric_limits<double>::infinity());
    }
    if (!(state.phi >= run.corner().alpha_rad && state.omega > 0)) {
        lose_contact_at_rest(run);
        return;
    }
    double const now = run.sample.now();
    double const flight_s = (overturned_rad - state.phi) / state.omega;
    run.log.outcome().contact_lost_s = now;
    run.log.lower_contact(0);
    run.show_flight(flight_s);
    run.log.overturn(now + flight_s, state.omega);
}

}  // namespace overturn::rocking
