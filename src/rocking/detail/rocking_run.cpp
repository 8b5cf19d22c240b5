#include "rocking/detail/rocking_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/run_out.hpp"
#include "rocking/detail/impact.hpp"
#include "rocking/detail/lane_run.hpp"
#include "rocking/detail/rest.hpp"
#include "rocking/detail/slip.hpp"
#include "rocking/detail/stick.hpp"

namespace overturn::rocking {

namespace {

// Of mu_s. Forces over m g are sums of a few terms of order 1, so their rounding is some 1e-15: a hundred times that.
constexpr double friction_slack = 1e-13;

}  // namespace

bool steps_in_lanes(RockingAccuracy const& accuracy) {
    return accuracy.restoring == Restoring::nonlinear && accuracy.taylor_order == campaign_order
           && accuracy.substeps == 1;
}

RockingSetup::RockingSetup(RockingBlock const& of, Excitation const& by, RockingAccuracy const& with, Slip friction)
    : block(of),
      shaking(by),
      accuracy(with),
      slip(friction),
      lopsided(of.lopsided.has_value()),
      incline(lopsided ? Incline{std::sin(of.lopsided->slope_rad), std::cos(of.lopsided->slope_rad)} : Incline{}),
      corners(corners_of(of, with.restoring, friction != Slip::ignored)),
      top(Potential(with.restoring, of.alpha_rad).top()),
      hold_friction(of.friction_static * (1 + friction_slack)),
      uses_lanes(steps_in_lanes(with) && std::ranges::all_of(corners, [](Corner const& corner) {
                     return corner.inertia_ratio <= most_lane_inertia_ratio;
                 })) {}

double RockingRun::mechanical_energy() const {
    double const psi = corner().base_angle_rad - state.phi;
    double const spin = corner().radius_m * state.side * state.omega;
    double const across = state.slip_velocity_mps + std::cos(psi) * spin;
    double const up = std::sin(psi) * spin;
    double const g = setup.block.gravity_mps2;
    double const downhill = setup.lopsided ? g * setup.incline.sine * state.slip_m : 0;  // what slip has won of height
    return kinetic_energy(across, up, spin, corner().law.kappa)
           + g * corner().radius_m * corner().potential.at(state.phi) - downhill;
}

namespace {

void step(RockingRun& run) {
    constexpr int max_steps_per_sample = 1000000;  // a trial must end
    if (++run.progress.steps_here > max_steps_per_sample) {
        run.log.fail(FailureReason::no_convergence);
        return;
    }
    switch (run.state.mode) {
        case Mode::rest:
            step_at_rest(run);
            break;
        case Mode::slide:
            step_sliding(run);
            break;
        case Mode::rock:
            step_stuck(run);
            break;
        case Mode::slip_rock:
            step_slipping(run);
            break;
    }
}

// A step, and where the trial stood before it if friction gives out in it.
void step_with_checkpoint(RockingRun& run) {
    if (run.setup.slip != Slip::detected) {
        step(run);
        return;
    }
    run.checkpoint = {true, run.log.outcome(), run.log.energy_at_weaker(), run.state, run.progress, run.sample.tau_s};
    step(run);
    run.checkpoint.reached = run.log.outcome().slip_onset;
}

// Whether no later peak can be higher, as impacts only take energy: e^2 of it at most is left after each.
bool decided(RockingRun const& run) {
    auto const& corner = run.corner();
    double const energy = run.energy();
    if (run.state.phi >= corner.alpha_rad || energy * corner.weight >= run.setup.top) {
        return false;
    }
    double const e = corner.restitution;
    constexpr double slack = 1e-12;  // of the peak: beyond what rounding makes of an equal one
    bool const rising = run.state.omega > 0;
    if (!run.setup.lopsided) {
        return corner.potential.turning_point(rising ? energy : e * e * energy) <= run.log.peak() * (1 + slack);
    }
    // The half cycle in hand, the next one over the other corner, and the first of the later ones here.
    auto const reached = [&](Corner const& at, double left) {
        return at.reach * at.potential.turning_point(left * corner.weight / at.weight);
    };
    auto const& other = run.setup.at_side(-run.state.side);
    double const later = std::max(reached(other, e * e * energy),
                                  reached(corner, rising ? energy : e * e * energy * std::pow(other.restitution, 2)));
    return later <= run.log.outcome().peak_reach_rad * (1 + slack);
}

// What is still to come of a block that energy has decided: it lands, and then more slowly. So the next landing has the
// fastest impact, the least contact force and the most friction.
// \return false where it would slip or leave the ground then, so that it has to be followed
bool take_last_landing(RockingRun& run) {
    auto const& setup = run.setup;
    double const spin = run.corner().p_radps * std::sqrt(2 * std::max(0.0, run.energy()));
    auto& out = run.log.outcome();
    if (setup.nonlinear()) {
        auto const forces = landing_forces(run, spin);
        bool const holds = std::abs(forces.friction) <= setup.hold_friction * forces.normal
                           && run.corner().impact_demand <= setup.block.friction_static;
        if (!(forces.normal > 0) || (setup.limited() && !holds)) {
            return false;
        }
        run.log.watch_forces(forces);
        run.log.raise_demand(run.corner().impact_demand);
    }
    out.impact_spin_radps = std::max(out.impact_spin_radps, spin);
    return true;
}

// No shaking any more: step on only until energy decides, and until no later peak can be higher. A block that has
// slipped may slip on: it is followed until it rests.
void run_out(RockingRun& run, double end_s) {
    auto& sample = run.sample;
    double const wave_step_s = run.setup.shaking.time_step_s;
    double const p = run.corner().p_radps;
    // Of 1 / p: how often, without a wave, energy is looked at. The series' tolerance sees to the step's accuracy.
    constexpr double calm_step = 0.01;
    double const length = wave_step_s > 0 ? wave_step_s : calm_step / p;
    // A block on its corner leaves it as exp(p t): after 37 / p the last bit has grown to one, so what still stands
    // after this is an exact balance and lasts.
    double const balance_s = 100 / p;
    run.log.raise_energy(run.energy());
    for (std::int64_t i = 0; !run.log.done() && run.state.mode != Mode::rest; ++i) {
        sample.calm(end_s + static_cast<double>(i) * length, length);
        if (!run.state.slipped && decided(run) && take_last_landing(run)) {
            break;
        }
        double const after_s = sample.now() - end_s;
        if (run.state.slipped ? i % run_out_samples == 0 && after_s > longest_after_s : after_s > balance_s) {
            break;
        }
        run.progress.steps_here = 0;
        while (!run.log.done() && sample.tau_s < sample.length_s) {
            step(run);
        }
    }
}

// \return false once the wave, and what follows it, is over
bool next_sample(RockingRun& run) {
    auto const& shaking = run.setup.shaking;
    std::size_t const n = shaking.horizontal_mps2.size();
    auto& at = run.progress;
    at.sample += run.sample.length_s > 0 ? 1 : 0;
    if (run.state.mode == Mode::rest && !run.log.observed()) {
        skip_rest(run);
    }
    if (at.sample + 1 < n) {
        run.sample.load(shaking, run.setup.block.gravity_mps2, at.sample);
        at.steps_here = 0;
        return true;
    }
    if (run.state.mode != Mode::rest) {
        run_out(run, static_cast<double>(n == 0 ? 0 : n - 1) * shaking.time_step_s);
    }
    return false;
}

RockingOutcome run_on(RockingRun& run) {
    while (advance(run)) {
        step_in_lane(run);
    }
    return finish(run);
}

}  // namespace

RockingOutcome run_from_start(RockingRun& run, RockingStart const& start) {
    begin(run, start);
    return run_on(run);
}

RockingOutcome run_from_checkpoint(RockingRun& run, Checkpoint const& checkpoint) {
    run.log.resume(checkpoint.so_far, checkpoint.energy);
    run.state = checkpoint.state;
    run.stand_on(run.state.side);
    run.progress = checkpoint.progress;
    run.sample.load(run.setup.shaking, run.setup.block.gravity_mps2, run.progress.sample);
    run.sample.tau_s = checkpoint.tau_s;
    run.log.outcome().energy.input = run.mechanical_energy();
    step(run);
    return run_on(run);
}

void begin(RockingRun& run, RockingStart const& start) {
    if (start.rotation_rad == 0 && start.velocity_radps == 0) {
        return;
    }
    auto& state = run.state;
    run.stand_on((start.rotation_rad != 0 ? start.rotation_rad : start.velocity_radps) < 0 ? -1.0 : 1.0);
    state.phi = state.side * start.rotation_rad;
    state.omega = state.side * start.velocity_radps;
    state.start_root = state.phi == 0 ? StartRoot::simple : StartRoot::none;
    state.mode = Mode::rock;
    run.log.uplifted(0);
    run.log.raise_peak(state.phi, 0);
    run.log.outcome().energy.input = run.mechanical_energy();  // what the block was given
    if (state.phi >= overturned_rad) {
        run.log.overturn(0, state.omega);
    }
}

bool advance(RockingRun& run) {
    while (!run.log.done()) {
        if (!(run.sample.tau_s < run.sample.length_s) && !next_sample(run)) {
            break;
        }
        if (run.setup.uses_lanes && !run.needs_scalar_step && run.state.mode == Mode::rock
            && run.state.start_root != StartRoot::twofold) {
            return true;
        }
        if (run.needs_scalar_step && step_unless_slip(run)) {
            continue;
        }
        run.needs_scalar_step = false;
        run.trig.current = false;
        step_with_checkpoint(run);
    }
    return false;
}

RockingOutcome const& finish(RockingRun& run) {
    auto const& state = run.state;
    auto& out = run.log.outcome();
    if (out.verdict == Verdict::at_rest) {
        out.verdict = !std::isnan(out.first_uplift_s) ? Verdict::rocked
                      : state.slipped                 ? Verdict::slid
                                                      : Verdict::at_rest;
    }
    out.residual_slip_m = state.slip_m;
    out.landing_slip_mps = state.side * state.slip_velocity_mps;
    out.energy.mechanical = run.mechanical_energy();
    if (!std::isfinite(out.peak_rotation_rad + out.peak_energy_ratio + state.phi + state.omega + state.slip_m
                       + state.slip_velocity_mps)) {
        out.verdict = Verdict::failed;
        out.failure = FailureReason::no_convergence;
    }
    return out;
}

}  // namespace overturn::rocking
