#include "rocking/detail/slip.hpp"

#include <algorithm>
#include <array>

#include "rocking/detail/corner_step.hpp"
#include "rocking/detail/slip_series.hpp"

namespace overturn::rocking {
namespace {

void stop_sliding(RockingRun& run) {
    run.state.slip_velocity_mps = 0;
    run.state.mode = Mode::rest;
}

// Back to rocking without slip; if sticking asks for too much friction, the next step finds that first
// (slips_at_once) and the corner slips again.
void stop_slipping(RockingRun& run) {
    run.state.slip_velocity_mps = 0;
    run.state.mode = Mode::rock;
}

template <class Order> void take_slipping_step(RockingRun& run, Order order) {
    auto& log = run.log;
    auto& state = run.state;
    auto const& block = run.setup.block;
    auto const& corner = run.corner();
    auto const forcing = run.ground_forcing(state.side);
    auto const shaking = run.shaking_of(forcing, state.side);
    double const g = block.gravity_mps2;
    double const forwards = state.side * state.slip_sign;
    auto slip = slip_series(order, corner.base_angle_rad, corner.r, corner.law.kappa, block.friction_kinetic * forwards,
                            state.phi, state.omega, forcing, state.start_root == StartRoot::twofold);
    auto const& series = slip.rotation;
    ++log.outcome().steps;
    if (state.start_root == StartRoot::twofold) {
        log.uplifted(run.sample.now());
    }
    if (state.slip_velocity_mps == 0 && forwards * slip.acceleration[0] < 0) {
        slip.acceleration[0] = 0;  // slip starts where this is zero or drives it, whatever rounding says
    }
    log.lower_contact(slip.normal[0]);
    run.show(-block.friction_kinetic * state.slip_sign * slip.normal[0], slip.normal[0]);
    double const h = step_length(run, series);
    if (log.done()) {
        return;
    }
    // Speed along the slip, and its integral.
    std::array<double, Order::most> speed{};
    speed[0] = state.slip_sign * state.slip_velocity_mps;
    for (int k = 1; k < order; ++k) {
        speed[k] = forwards * g * slip.acceleration[k - 1] / k;
    }
    auto const speed_root = state.slip_velocity_mps == 0 ? StartRoot::simple : StartRoot::none;
    Ending ending{h};
    ending.earlier(slip.normal[0] > 0 ? first_fall_through_zero(slip.normal, h, StartRoot::none) : 0.0, &lose_contact);
    ending.earlier(first_fall_through_zero(speed, ending.at, speed_root), &stop_slipping);
    ending.earlier(first_fall_through_zero(series.phi, ending.at, state.start_root), &apply_impact);
    find_overturning(series, ending);

    auto& energy = log.outcome().energy;
    std::array<double, Order::most> const push{forwards * shaking.horizontal.start,
                                               forwards * shaking.horizontal.slope};
    std::array<double, Order::most> normal{};
    std::copy(slip.normal.begin(), slip.normal.end(), normal.begin());
    energy.input +=
        g * corner.radius_m * shaking_work(series.velocity(), series.sine, series.cosine, shaking, order, ending.at)
        - g * product_integral(speed, push, order, ending.at);
    energy.friction_work += g * block.friction_kinetic * product_integral(speed, normal, order, ending.at);
    log.raise_energy(run.energy());
    state.slip_m += state.slip_sign * integral(speed, ending.at);
    state.slip_velocity_mps = state.slip_sign * evaluate(speed, ending.at);
    log.raise_slip(state.slip_m);
    log.lower_contact(evaluate(slip.normal, ending.at));
    move(run, series, ending);
    ending.apply(run);
}

}  // namespace

void step_slipping(RockingRun& run) {
    if (run.setup.accuracy.taylor_order == CampaignOrder::most) {
        take_slipping_step(run, CampaignOrder{});
    } else {
        take_slipping_step(run, AnyOrder{run.setup.accuracy.taylor_order});
    }
}

void step_sliding(RockingRun& run) {
    auto& state = run.state;
    auto& log = run.log;
    double const g = run.setup.block.gravity_mps2;
    double const drag = run.setup.block.friction_kinetic * state.slip_sign;
    auto const forcing = run.ground_forcing(1);
    auto const shaking = run.shaking_of(forcing, 1);
    double const gv = forcing.vertical.start;
    log.lower_contact(gv);
    run.show(-drag * gv, gv);
    if (!(gv > 0)) {
        lose_contact_at_rest(run);
        return;
    }
    ++log.outcome().steps;
    double drive = -forcing.horizontal.start - drag * gv;
    if (state.slip_velocity_mps == 0 && state.slip_sign * drive < 0) {
        drive = 0;  // sliding starts where this is zero or drives it, whatever rounding says
    }
    std::array<double, 3> const velocity{state.slip_velocity_mps, g * drive,
                                         -0.5 * g * (forcing.horizontal.slope + drag * forcing.vertical.slope)};
    auto forwards = velocity;
    for (double& c : forwards) {
        c *= state.slip_sign;
    }
    auto const root = state.slip_velocity_mps == 0 ? StartRoot::simple : StartRoot::none;
    Ending ending{run.sample.left()};
    if (double const stop = first_fall_through_zero(forwards, ending.at, root); stop >= 0) {
        ending = {stop, &stop_sliding};
    }
    std::array<double, 2> const weight{gv, forcing.vertical.slope};
    if (evaluate(weight, ending.at) <= 0) {
        ending = {root_between(weight, 0.0, ending.at), &lose_contact_at_rest};
    }
    std::array<double, 3> const normal{gv, forcing.vertical.slope, 0};
    std::array<double, 3> const push{-shaking.horizontal.start, -shaking.horizontal.slope, 0};
    auto& energy = log.outcome().energy;
    std::array<double, 4> power{};
    std::array<double, 4> loss{};
    for (int k = 0; k < 4; ++k) {
        for (int j = std::max(0, k - 2); j <= std::min(k, 2); ++j) {
            power[k] += g * velocity[j] * push[k - j];
            loss[k] += g * drag * velocity[j] * normal[k - j];
        }
    }
    energy.input += integral(power, ending.at);
    energy.friction_work += integral(loss, ending.at);
    state.slip_m += integral(velocity, ending.at);
    log.raise_slip(state.slip_m);
    run.sample.advance(ending.at, ending.reset != nullptr);
    state.slip_velocity_mps = evaluate(velocity, ending.at);
    ending.apply(run);
}

}  // namespace overturn::rocking
