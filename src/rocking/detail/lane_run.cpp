#include "rocking/detail/lane_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rocking/detail/stick.hpp"

namespace overturn::rocking {
namespace {

bool stepped(RockingFields<1> const& before, RockingFields<1> const& after) {
    return after.at(RockingField::steps, 0) != before.at(RockingField::steps, 0);
}
bool had_impact(RockingFields<1> const& before, RockingFields<1> const& after) {
    return after.at(RockingField::impacts, 0) != before.at(RockingField::impacts, 0);
}

void show_step(RockingRun& run, RockingFields<1> const& before, LaneStep const& step) {
    auto const& state = run.state;
    auto const& corner = run.corner();
    auto const index = static_cast<std::size_t>(before.at(RockingField::index, 0));
    double const side = before.at(RockingField::side, 0);
    Sample sample;
    sample.load(run.setup.shaking, run.setup.block.gravity_mps2, index);
    sample.tau_s = before.at(RockingField::tau, 0);
    auto const f = sample.forcing(side);
    double const s = step.sine[0];
    double const c = step.cosine[0];
    double const omega = before.at(RockingField::omega, 0);
    double const acceleration = -corner.inertia_ratio * pull(f.vertical.start, f.horizontal.start, s, c);  // r phi''
    double const spin = corner.r * omega * omega;                                                          // r phi'^2
    auto const forces = contact_forces(s, c, acceleration, spin, 1, f.horizontal.start, f.vertical.start);
    auto const [friction, normal] = run.to_ground(forces.friction, forces.normal, side);
    run.log.show({sample.now(), side * before.at(RockingField::phi, 0), side * omega, side * friction, normal,
                  state.slip_m, state.slip_velocity_mps});
}

void show_impact(RockingRun& run, RockingFields<1> const& after) {
    auto const& state = run.state;
    double const time =
        after.at(RockingField::index, 0) * run.setup.shaking.time_step_s + after.at(RockingField::tau, 0);
    double const rebound = after.at(RockingField::side, 0) * after.at(RockingField::omega, 0);
    run.log.show({time, 0, rebound / run.corner().restitution, 0, 0, state.slip_m, state.slip_velocity_mps});
    run.log.show({time, 0, rebound, 0, 0, state.slip_m, state.slip_velocity_mps});
}

// What a step means to an observer and to the balance of energy.
void account_for(RockingRun& run, RockingFields<1> const& before, RockingFields<1> const& after, LaneStep const& step) {
    bool const impact = had_impact(before, after);
    if (run.log.observed()) {
        show_step(run, before, step);
        if (impact) {
            show_impact(run, after);
        }
    }
    if (run.setup.slipping()) {
        auto const& corner = run.corner();
        auto& energy = run.log.outcome().energy;
        Forcing const forcing{{step.horizontal[0], step.horizontal[1]}, {step.vertical[0], step.vertical[1]}};
        energy.input += run.setup.block.gravity_mps2 * corner.radius_m
                        * shaking_work(step.rates, step.sine, step.cosine, forcing, LaneStep::order, step.share);
        if (impact) {
            double const rebound = corner.radius_m * after.at(RockingField::omega, 0);
            double const e = corner.restitution;
            // Kinetic energy I_O omega^2 / 2 about the corner, over the mass: before the impact less after it.
            energy.impact_loss += 0.5 / corner.inertia_ratio * rebound * rebound * (1 / (e * e) - 1);
        }
    }
}

// Step by step, where the steps themselves are asked for.
void step_lane_observed(RockingRun& run) {
    RockingFields<1> lane;
    load_lane(run, lane, 0);
    LaneStep taken;
    for (bool on = true; on;) {
        auto const before = lane;
        on = step_lane_once(lane, run.setup.has_vertical(), taken);
        if (stepped(before, lane)) {
            account_for(run, before, lane, taken);
        }
    }
    store_lane(run, lane, 0);
}

}  // namespace

template <int Lanes> void load_lane(RockingRun const& run, RockingFields<Lanes>& lanes, int lane) {
    auto const set = [&](RockingField field, double value) { lanes.at(field, lane) = value; };
    auto const& setup = run.setup;
    auto const& state = run.state;
    auto const& corner = run.corner();
    auto const& out = run.log.outcome();
    double const psi = corner.alpha_rad - state.phi;
    bool const grounded = state.phi == 0;
    set(RockingField::phi, state.phi);
    set(RockingField::omega, state.omega);
    set(RockingField::sine, run.trig.current ? run.trig.sine : grounded ? corner.sine_alpha : std::sin(psi));
    set(RockingField::cosine, run.trig.current ? run.trig.cosine : grounded ? corner.cosine_alpha : std::cos(psi));
    set(RockingField::side, state.side);
    set(RockingField::index, static_cast<double>(run.progress.sample));
    set(RockingField::tau, run.sample.tau_s);
    set(RockingField::start, state.start_root == StartRoot::simple ? 1 : 0);
    set(RockingField::peak, run.log.peak());
    set(RockingField::peak_time, out.time_of_peak_s);
    set(RockingField::peak_side, out.peak_side);
    set(RockingField::energy, run.log.energy());
    set(RockingField::demand, out.friction_demand);
    set(RockingField::normal, out.min_contact_force_ratio);
    set(RockingField::steps, static_cast<double>(out.steps));
    set(RockingField::impacts, static_cast<double>(out.impacts));
    set(RockingField::impact_spin, out.impact_spin_radps);

    auto const& shaking = setup.shaking;
    double const e = corner.restitution;
    double const p = corner.p_radps;
    set(RockingField::p, p);
    set(RockingField::inverse_p, 1 / p);
    set(RockingField::r, corner.r);
    set(RockingField::inertia_ratio, corner.inertia_ratio);
    set(RockingField::restitution, e);
    set(RockingField::sine_alpha, corner.sine_alpha);
    set(RockingField::cosine_alpha, corner.cosine_alpha);
    set(RockingField::uplift_ratio, corner.uplift_ratio);
    set(RockingField::friction_limit, setup.limited() ? std::min(unlimited, setup.block.friction_static) : unlimited);
    // An impact over a corner unlike this one needs care: it changes what is set here.
    set(RockingField::impact_demand, setup.lopsided ? std::numeric_limits<double>::infinity() : corner.impact_demand);
    set(RockingField::incline_sine, state.side * setup.incline.sine);
    set(RockingField::incline_cosine, setup.incline.cosine);
    set(RockingField::settle_speed, setup.accuracy.settle * p);
    set(RockingField::settle_rate, longest_bouncing(p, corner.cosine_alpha, e));
    set(RockingField::tolerance, setup.accuracy.step_tolerance * corner.alpha_rad);
    set(RockingField::scale, shaking.scale / setup.block.gravity_mps2);
    set(RockingField::time_step, shaking.time_step_s);
    set(RockingField::sampling_rate, 1 / shaking.time_step_s);
    set(RockingField::last, static_cast<double>(shaking.horizontal_mps2.size() - 1));
    lanes.at(RockingWave::horizontal, lane) = shaking.horizontal_mps2.data();
    lanes.at(RockingWave::vertical, lane) = shaking.vertical_mps2.data();
}

template <int Lanes> void store_lane(RockingRun& run, RockingFields<Lanes> const& lanes, int lane) {
    auto const get = [&](RockingField field) { return lanes.at(field, lane); };
    auto const& shaking = run.setup.shaking;
    auto& state = run.state;
    auto& log = run.log;
    auto& out = log.outcome();
    auto& index = run.progress.sample;
    state.phi = get(RockingField::phi);
    state.omega = get(RockingField::omega);
    run.trig = {true, get(RockingField::sine), get(RockingField::cosine)};
    run.stand_on(get(RockingField::side));
    index = static_cast<std::size_t>(get(RockingField::index));
    state.start_root = get(RockingField::start) > 0 ? StartRoot::simple : StartRoot::none;
    if (get(RockingField::peak) > log.peak()) {
        log.raise_peak(get(RockingField::peak), get(RockingField::peak_time), get(RockingField::peak_side));
    }
    // log.energy() is a quotient: an energy that the lane left as it was may not come back raised by its rounding.
    if (get(RockingField::energy) > log.energy()) {
        log.raise_energy(get(RockingField::energy));
    }
    out.friction_demand = get(RockingField::demand);
    out.min_contact_force_ratio = get(RockingField::normal);
    out.steps = static_cast<std::int64_t>(get(RockingField::steps));
    out.impacts = static_cast<std::int64_t>(get(RockingField::impacts));
    out.impact_spin_radps = get(RockingField::impact_spin);
    if (index + 1 < shaking.horizontal_mps2.size()) {
        run.sample.load(shaking, run.setup.block.gravity_mps2, index);
        run.sample.tau_s = get(RockingField::tau);
        run.needs_scalar_step = run.sample.tau_s < run.sample.length_s;
    } else {
        run.sample.tau_s = run.sample.length_s;  // the wave is over
        index -= 1;
        run.needs_scalar_step = false;
    }
    run.progress.steps_here = 0;
}

template void load_lane(RockingRun const& run, RockingFields<1>& lanes, int lane);
template void load_lane(RockingRun const& run, RockingFields<most_lanes>& lanes, int lane);
template void store_lane(RockingRun& run, RockingFields<1> const& lanes, int lane);
template void store_lane(RockingRun& run, RockingFields<most_lanes> const& lanes, int lane);

void step_in_lane(RockingRun& run) {
    if (run.setup.slipping() || run.log.observed()) {
        step_lane_observed(run);
        return;
    }
    RockingFields<1> lane;
    load_lane(run, lane, 0);
    step_lanes(lane, run.setup.has_vertical());
    store_lane(run, lane, 0);
}

bool step_unless_slip(RockingRun& run) {
    if (!run.setup.limited()) {
        return false;
    }
    RockingFields<1> lane;
    load_lane(run, lane, 0);
    auto const before = lane;
    lane.at(RockingField::friction_limit, 0) = unlimited;
    LaneStep taken;
    (void)step_lane_once(lane, run.setup.has_vertical(), taken);
    if (!stepped(before, lane)
        || (had_impact(before, lane) && !(lane.at(RockingField::impact_demand, 0) <= run.setup.block.friction_static))
        || gives_out_within(run, taken.share * taken.length_s)) {
        return false;
    }
    account_for(run, before, lane, taken);
    store_lane(run, lane, 0);
    run.needs_scalar_step = false;
    return true;
}

}  // namespace overturn::rocking
