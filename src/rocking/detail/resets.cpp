#include "rocking/detail/resets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace overturn::rocking {

namespace {

// Motion of the centre of gravity in flight, towards the fall and across the ground, down to where it lies.
struct Flight {
    double along_mps, up_mps, height_m, lies_at_m;
    bool down = false;  // it is as low as it can lie: it has touched before

    // Under a forcing over g that changes evenly from `from` to `to`.
    void fly(ContactForces<double> const& from, ContactForces<double> const& to, double gravity_mps2, double time_s) {
        along_mps -= gravity_mps2 * time_s * (from.friction + to.friction) / 2;
        double const height = height_m + time_s * (up_mps - gravity_mps2 * time_s * (2 * from.normal + to.normal) / 6);
        double const up = up_mps - gravity_mps2 * time_s * (from.normal + to.normal) / 2;
        if (down) {
            return;
        }
        down = height < lies_at_m;
        up_mps = down ? -fallen_mps(gravity_mps2 * std::max(from.normal, to.normal)) : up;
        height_m = std::max(height, lies_at_m);
    }
    // Its velocity where it lies, at the height that it has left under this gravity.
    [[nodiscard]] double fallen_mps(double gravity_mps2) const {
        return std::sqrt(std::max(up_mps * up_mps + 2 * gravity_mps2 * (height_m - lies_at_m), 0.0));
    }
};

// Free of the ground until it lies: its centre of gravity falls as the shaking lets it.
void land_after_flight(RockingRun& run, double flight_s) {
    auto const& state = run.state;
    auto const& corner = run.corner();
    auto const& shaking = run.setup.shaking;
    double const g = run.setup.block.gravity_mps2;
    double const angle = corner.base_angle_rad - state.phi;
    Flight flight{state.side * state.slip_velocity_mps + corner.radius_m * std::cos(angle) * state.omega,
                  corner.radius_m * std::sin(angle) * state.omega, corner.radius_m * std::cos(angle),
                  corner.radius_m * std::sin(corner.base_angle_rad)};
    auto sample = run.sample;
    auto const forces = [&](double tau_s) {
        return run.to_ground(state.side * sample.horizontal(tau_s), sample.vertical(tau_s), state.side);
    };
    std::size_t next = run.progress.sample + 1;
    for (double left_s = flight_s; left_s > 0;) {
        double const time_s = std::min(left_s, sample.left());
        flight.fly(forces(sample.tau_s), forces(sample.tau_s + time_s), g, time_s);
        left_s -= time_s;
        if (next + 1 < shaking.horizontal_mps2.size()) {
            sample.load(shaking, g, next++);
        } else {
            sample.calm(0, left_s);
        }
    }
    auto& out = run.log.outcome();
    out.flight_along_mps = flight.along_mps;
    out.flight_down_mps = flight.fallen_mps(g);
}

}  // namespace

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
    land_after_flight(run, flight_s);
    run.show_flight(flight_s);
    run.log.overturn(now + flight_s, state.omega);
}

}  // namespace overturn::rocking
