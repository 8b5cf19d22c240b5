#include "rocking/detail/stick.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/detail/corner_step.hpp"
#include "rocking/detail/stick_series.hpp"

namespace overturn::rocking {
namespace {

void slip_forwards(RockingRun& run) { start_slip(run, 1); }
void slip_backwards(RockingRun& run) { start_slip(run, -1); }

template <class Order>
RotationSeries<Order> series_from_here(RockingRun const& run, Order order, Forcing const& forcing) {
    auto const& state = run.state;
    return stick_series(order, run.setup.accuracy.restoring, run.corner().alpha_rad, run.corner().p_radps, state.phi,
                        state.omega, forcing, state.start_root == StartRoot::twofold);
}

template <class Order>
ContactForces<double> forces_here(RockingRun const& run, RotationSeries<Order> const& series, Forcing const& forcing) {
    auto const forces =
        contact_forces(series.sine[0], series.cosine[0], 2 * series.phi[2], run.state.omega * run.state.omega,
                       run.corner().r, forcing.horizontal.start, forcing.vertical.start);
    return run.to_ground(forces.friction, forces.normal, run.state.side);
}

bool slips_at_once(RockingRun const& run, ContactForces<double> const& forces) {
    return run.setup.limited() && std::abs(forces.friction) > run.setup.hold_friction * forces.normal
           && forces.normal > 0;
}

// A bound of what F and N may change by within a step, from their derivatives. With |s|, |c| <= 1 and
//   pull <= |A| + |Gv| =: q, r |phi''| = r p^2 pull < q,
// and by the equation of motion's own derivative r |phi'''| <= |A'| + |Gv'| + |phi'| q:
//   |F'|, |N'| <= r (|phi'''| + 3 |phi' phi''| + |phi'|^3) + |A'| + |Gv'|
//              <= 2 (|A'| + |Gv'|) + |phi'| (4 q + r phi'^2).
double force_change_bound(RockingRun const& run, Forcing const& forcing, double h) {
    double const p = run.corner().p_radps;
    double const slopes = std::abs(forcing.horizontal.slope) + std::abs(forcing.vertical.slope);
    double const q = std::abs(forcing.horizontal.start) + std::abs(forcing.vertical.start) + h * slopes;
    double const rate = std::abs(run.state.omega) + h * p * p * q;
    return run.setup.incline.spread() * h * (2 * slopes + rate * (4 * q + run.corner().r * rate * rate));
}

// Where within the step friction or contact gives out. The forces' series are worked out only near a limit.
template <class Order>
Ending limits_of_contact(RockingRun const& run, RotationSeries<Order> const& series, Forcing const& forcing,
                         ContactForces<double> const& forces, double h) {
    Ending ending{h};
    double const mu = run.setup.hold_friction;
    double const change = force_change_bound(run, forcing, h);
    bool const contact_near = forces.normal - change <= 0;
    bool const slip_near = run.setup.limited() && std::abs(forces.friction) + change >= mu * (forces.normal - change);
    if (!contact_near && !slip_near) {
        return ending;
    }
    if (forces.normal <= 0) {
        return {0, &lose_contact};
    }
    auto const [friction, normal] =
        run.setup.incline.turned(contact_series(series, forcing, run.corner().r), run.state.side);
    auto const fall = [&](PowerSeries<Order> const& what) {
        return first_fall_through_zero(what.c, ending.at, StartRoot::none);
    };
    ending.earlier(fall(normal), &lose_contact);  // N falls through zero
    if (run.setup.limited()) {                    // mu_s N - |F| falls through zero
        ending.earlier(fall(mu * normal - friction), &slip_forwards);
        ending.earlier(fall(mu * normal + friction), &slip_backwards);
    }
    return ending;
}

// Energy changes by the power of the shaking, -phi' times its share of the pull. So inside a step it is highest where
// the block turns (phi' = 0) or where that share is zero.
template <class Order>
void raise_energy_inside(RockingRun& run, RotationSeries<Order> const& series, Forcing const& forcing, double end) {
    auto& log = run.log;
    auto const& corner = run.corner();
    log.raise_energy(run.energy());
    auto const velocity = series.velocity();
    auto const shaking_pull = [&](double t) {
        return pull(forcing.vertical.at(t) - 1, forcing.horizontal.at(t), evaluate(series.sine, t),
                    evaluate(series.cosine, t));
    };
    auto const energy = [&](double t) {
        return rocking_energy(evaluate(velocity, t) / corner.p_radps, corner.potential.at(evaluate(series.phi, t)));
    };
    auto const turns = roots_in(velocity, 0.0, end);
    for (double const t : turns.all()) {
        log.raise_energy(energy(t));
    }
    double const here = shaking_pull(0);
    double const there = shaking_pull(end);
    if (here * there < 0) {
        double const slope = (here - there) / end;
        double const near = here / slope;  // almost a line: one more step of regula falsi is enough
        log.raise_energy(energy(std::clamp(near + shaking_pull(near) / slope, 0.0, end)));
    }
}

template <class Order> void take_stuck_step(RockingRun& run, Order order) {
    auto& log = run.log;
    auto const& setup = run.setup;
    auto const forcing = run.sample.forcing(run.state.side);
    auto const series = series_from_here(run, order, forcing);
    ++log.outcome().steps;
    auto const forces = forces_here(run, series, forcing);
    if (slips_at_once(run, forces)) {
        start_slip(run, forces.friction);
        return;
    }
    if (run.state.start_root == StartRoot::twofold) {
        log.uplifted(run.sample.now());
    }
    log.watch_forces(forces);
    run.show(run.state.side * forces.friction, forces.normal);
    double const h = step_length(run, series);
    if (log.done()) {
        return;
    }
    // The linear block's contact forces mean nothing.
    auto ending = setup.nonlinear() ? limits_of_contact(run, series, forcing, forces, h) : Ending{h};
    if (double const impact = first_fall_through_zero(series.phi, ending.at, run.state.start_root); impact >= 0) {
        ending = {impact, &land_and_apply_impact};
    }
    find_overturning(series, ending);
    raise_energy_inside(run, series, forcing, ending.at);
    if (setup.slipping()) {
        log.outcome().energy.input +=
            setup.block.gravity_mps2 * run.corner().radius_m
            * shaking_work(series.velocity(), series.sine, series.cosine, forcing, order, ending.at);
    }
    move(run, series, ending);
    ending.apply(run);
}

}  // namespace

void step_stuck(RockingRun& run) {
    auto const& accuracy = run.setup.accuracy;
    if (accuracy.taylor_order == CampaignOrder::most && run.setup.nonlinear()) {
        take_stuck_step(run, CampaignOrder{});
    } else {
        take_stuck_step(run, AnyOrder{accuracy.taylor_order});
    }
}

bool gives_out_within(RockingRun const& run, double length_s) {
    auto const forcing = run.sample.forcing(run.state.side);
    auto const series = series_from_here(run, CampaignOrder{}, forcing);
    auto const forces = forces_here(run, series, forcing);
    return slips_at_once(run, forces) || limits_of_contact(run, series, forcing, forces, length_s).reset != nullptr;
}

}  // namespace overturn::rocking
