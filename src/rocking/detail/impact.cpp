#include "rocking/detail/impact.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/detail/resets.hpp"

namespace overturn::rocking {
namespace {

// Time that the bouncing still takes, by the forcing as it is now.
double bouncing_s(RockingRun const& run, double a, double gv) {
    auto const deceleration = [&](Corner const& at, double side) {
        double const cosine =
            run.setup.nonlinear() ? std::cos(at.alpha_rad) : 1.0;  // the linear block's sin psi is psi
        return deceleration_at_ground(at.p_radps, cosine, at.uplift_ratio, gv, side * a);
    };
    double const side = run.state.side;
    auto const& corner = run.corner();
    auto const& other = run.setup.at_side(-side);
    return bouncing_time(run.state.omega, deceleration(corner, side), deceleration(other, -side), corner.restitution,
                         other.restitution);
}

// Whether the small half cycles on both corners need no more friction than there is.
bool bouncing_sticks(RockingRun const& run, double a, double gv) {
    if (!run.setup.limited()) {
        return true;
    }
    auto const sticks_on = [&](double side) {
        auto const& at = run.setup.at_side(side);
        double const acceleration = -at.p_radps * at.p_radps * (at.sine_alpha * gv + side * a * at.cosine_alpha);
        // contact_forces at no rate, its products taken in another order: the last bit may not move a verdict
        auto const [friction, normal] = run.to_ground(side * a + at.r * at.cosine_alpha * acceleration,
                                                      gv + at.r * at.sine_alpha * acceleration, side);
        return std::abs(friction) <= run.setup.block.friction_static * normal;
    };
    return sticks_on(1.0) && sticks_on(-1.0);
}

// Guard: the bouncing ends within this sample, and the base then rests; or it is too slow to matter.
// Reset: at rest, and if known, at the instant at which the bouncing ends.
void settle(RockingRun& run, double a, double gv) {
    auto& sample = run.sample;
    auto const& corner = run.corner();
    double const end = sample.tau_s + bouncing_s(run, a, gv);
    double const a_end = sample.horizontal(end);
    if (end <= sample.length_s && std::abs(a_end) <= sample.vertical(end) * run.setup.tipped_by(a_end).uplift_ratio
        && bouncing_sticks(run, a, gv)) {
        sample.tau_s = end;
    } else if (run.state.omega > rest_speed_share * run.setup.accuracy.settle * corner.p_radps) {
        return;
    }
    auto& loss = run.log.outcome().energy.impact_loss;
    if (run.setup.slipping()) {
        loss += run.mechanical_energy();
    }
    run.state.mode = Mode::rest;
    run.state.omega = 0;
    if (run.setup.slipping()) {
        loss -= run.mechanical_energy();  // what slip down a slope has won stays
    }
}

// The bouncing of a base that slips ends in finite time too, but the slip may outlast it.
// Guard: the rebound is slower than rest_speed_share settle p; and there is none, or the slip is as slow, or friction
// does not tip a base that slides this way.
// Reset: all that is left of the bouncing at once, by the momentum of the centre of gravity. Along the ground its
// v + h theta' becomes the base's slip. Upwards it loses b omega, so that over the bouncing the ground bears m b omega
// less than the weight's impulse, and friction brakes by mu_k b omega less (`saved`). What is left of the slip decides:
// none is rest (or a lift, if the shaking does not hold the block), else the base slides or tips towards its slip.
void settle_slipping(RockingRun& run, double a, double hold) {
    auto& state = run.state;
    auto const& corner = run.corner();
    auto const& block = run.setup.block;
    double const slow = rest_speed_share * run.setup.accuracy.settle * corner.p_radps;
    bool const sticks = std::abs(state.slip_velocity_mps) <= slow * corner.radius_m;
    bool const tips = block.friction_kinetic > run.setup.at_side(state.slip_sign).base_ratio;
    if (state.omega > slow || (tips && !sticks && state.omega > 0)) {
        return;
    }
    auto& energy = run.log.outcome().energy;
    energy.impact_loss += run.mechanical_energy();
    double const saved = block.friction_kinetic * corner.radius_m * corner.law.sine_alpha * state.omega;
    double const slip = state.slip_velocity_mps + corner.radius_m * corner.law.cosine_alpha * state.side * state.omega
                        + state.slip_sign * saved;
    double const work = saved * std::abs(state.slip_velocity_mps);
    state.omega = 0;
    if (sticks || state.slip_sign * slip <= 0) {
        state.slip_velocity_mps = 0;
        state.mode = Mode::rest;
        if (std::abs(a) > hold) {
            lift(run, a);
        }
    } else if (tips) {  // a sliding base tips towards its slip
        run.stand_on(state.slip_sign);
        state.start_root = StartRoot::twofold;
    } else {
        state.slip_velocity_mps = slip;
        state.mode = Mode::slide;
        energy.friction_work -= work;
        energy.impact_loss += work;
    }
    energy.impact_loss -= run.mechanical_energy();
}

}  // namespace

void apply_impact(RockingRun& run) {
    auto& state = run.state;
    auto const& corner = run.corner();
    auto& out = run.log.outcome();
    ++out.impacts;
    double const speed = std::max(0.0, -state.omega);
    out.impact_spin_radps = std::max(out.impact_spin_radps, speed);
    // rocking_energy on the ground, but for its quotient, which is taken last: results' last bits keep it.
    run.log.raise_energy(0.5 * speed * speed / (corner.p_radps * corner.p_radps));
    state.phi = 0;
    run.show(0, 0);
    double rebound = corner.restitution * speed;
    if (run.setup.limited()) {
        double const radius = corner.radius_m;
        double const slip_rate = state.slip_velocity_mps / radius;
        auto const after = after_impact(corner.law, -state.side * speed, slip_rate);
        if (run.setup.slipping()) {
            double const before = radius * radius * corner.law.energy(-state.side * speed, slip_rate);
            rebound = std::abs(after.rotation_rate);
            state.slip_velocity_mps = after.slip_rate * radius;
            out.energy.impact_loss +=
                before - radius * radius * corner.law.energy_after(after.rotation_rate, after.slip_rate);
        } else if (after.slip_rate != 0) {
            run.log.end_at_slip();
            return;
        }
    }
    if (state.slip_velocity_mps == 0) {
        run.log.raise_demand(state.mode == Mode::rock ? corner.impact_demand : 0);
        state.mode = Mode::rock;
    } else {
        state.mode = Mode::slip_rock;
        state.slip_sign = state.slip_velocity_mps < 0 ? -1.0 : 1.0;
        state.slipped = true;
    }
    run.stand_on(-state.side);
    state.omega = rebound;
    state.start_root = StartRoot::simple;
    run.show(0, 0);
    double const a = run.sample.horizontal(run.sample.tau_s);
    double const gv = run.sample.vertical(run.sample.tau_s);
    double const hold = gv * run.setup.tipped_by(a).uplift_ratio;
    if (state.mode == Mode::slip_rock) {
        settle_slipping(run, a, hold);
        return;
    }
    if (std::abs(a) > hold) {  // driven: it rocks on, however slow
        if (state.omega == 0) {
            lift(run, a);
        }
        return;
    }
    if (state.omega <= run.setup.accuracy.settle * run.corner().p_radps) {
        settle(run, a, gv);
    }
}

namespace {

ContactForces<double> stuck_forces(RockingRun const& run, double s, double c, double omega) {
    auto const& corner = run.corner();
    double const side = run.state.side;
    double const a = side * run.sample.horizontal(run.sample.tau_s);
    double const gv = run.sample.vertical(run.sample.tau_s);
    double const spin = corner.r * omega * omega;
    double const grip = corner.inertia_ratio * pull(gv, a, s, c);
    // As contact_forces_in_motion, but for the sum's order, which results' last bits keep.
    return run.to_ground(contact_forces_in_motion(s, c, spin, a, gv, grip).friction, gv - s * grip - c * spin, side);
}

}  // namespace

ContactForces<double> landing_forces(RockingRun const& run, double omega) {
    return stuck_forces(run, run.corner().sine_alpha, run.corner().cosine_alpha, omega);
}

void land_and_apply_impact(RockingRun& run) {
    if (run.setup.nonlinear()) {
        run.log.watch_forces(landing_forces(run, run.state.omega));
    }
    apply_impact(run);
}

void overturn_now(RockingRun& run) {
    if (run.setup.nonlinear() && run.state.mode == Mode::rock) {  // psi = alpha - pi/2
        run.log.watch_forces(stuck_forces(run, -run.corner().cosine_alpha, run.corner().sine_alpha, run.state.omega));
    }
    auto const& state = run.state;
    run.log.show({run.sample.now(), state.side * overturned_rad, state.side * state.omega, 0, 0,  // as at an impact
                  state.slip_m, state.slip_velocity_mps});
    run.log.overturn(run.sample.now(), run.state.omega);
}

}  // namespace overturn::rocking
