/// One trial of planar rocking while it runs: what it is made of, where it stands, what it remembers. What it does in
/// each mode stands in files of their own: rest, stick, slip, impact, lane_run; which of them is next, in
/// rocking_run.cpp.
#pragma once

#include <array>

#include "rocking/detail/checkpoint.hpp"
#include "rocking/detail/corner.hpp"
#include "rocking/detail/incline.hpp"
#include "rocking/detail/lane_step.hpp"
#include "rocking/detail/sample.hpp"
#include "rocking/detail/state.hpp"
#include "rocking/detail/trial_log.hpp"

namespace overturn::rocking {

/// Whether this accuracy is the one that step_lanes is compiled for: order and steps of campaigns, no linearisation.
[[nodiscard]] bool steps_in_lanes(RockingAccuracy const& accuracy);

/// Constants of a trial.
struct RockingSetup {
    RockingSetup(RockingBlock const& of, Excitation const& by, RockingAccuracy const& with, Slip friction);

    RockingBlock block;
    Excitation shaking;
    RockingAccuracy accuracy;
    Slip slip;
    bool lopsided;  ///< its corners differ
    Incline incline;
    std::array<Corner, 2> corners;
    double top;  ///< energy that tips the weaker corner over, over its m g R
    /// Limit of sticking, a little above mu_s: friction that is just enough holds in spite of rounding.
    double hold_friction;
    /// Its steps without slip are left to step_lanes: the accuracy is theirs, and so are the inertia ratios.
    bool uses_lanes;

    [[nodiscard]] bool nonlinear() const { return accuracy.restoring == Restoring::nonlinear; }
    [[nodiscard]] bool has_vertical() const { return !shaking.vertical_mps2.empty(); }
    [[nodiscard]] bool slipping() const { return slip == Slip::simulated; }
    /// Friction has a limit that is looked at.
    [[nodiscard]] bool limited() const { return slip != Slip::ignored; }
    [[nodiscard]] Corner const& at_side(double side) const { return corners[side < 0 ? 1 : 0]; }
    /// The corner that an acceleration tips towards.
    [[nodiscard]] Corner const& tipped_by(double a) const { return at_side(a > 0 ? -1.0 : 1.0); }
};

struct RockingRun {
    RockingRun(RockingBlock const& block, Excitation const& shaking, RockingAccuracy const& accuracy, Slip slip,
               RockingObserver* observer)
        : setup(block, shaking, accuracy, slip), log(setup.top, observer) {
        stand_on(state.side);
    }

    RockingSetup setup;
    State state;
    Progress progress;
    Sample sample;
    TrialLog log;
    Checkpoint checkpoint;  ///< state before friction was exceeded, of a trial that is over

    /// sin and cos of psi as the last step in a lane left them.
    struct Trigonometry {
        bool current = false;  ///< they still hold
        double sine = 0, cosine = 0;
    } trig;
    bool needs_scalar_step = false;  ///< the next step is one that step_lanes refused

    [[nodiscard]] Corner const& corner() const { return setup.at_side(state.side); }
    void stand_on(double side) {
        state.side = side;
        log.stand_on(side, corner().reach, corner().weight);
    }
    /// Forces along the horizon and the vertical as forces along the ground and across it, over m g.
    [[nodiscard]] ContactForces<double> to_ground(double friction, double normal, double side) const {
        return setup.incline.turned(ContactForces<double>{friction, normal}, side);
    }
    /// Forcing along and across the ground, mirrored to a side.
    [[nodiscard]] Forcing ground_forcing(double side) const { return setup.incline.turned(sample.forcing(side), side); }
    /// Shaking in this forcing.
    [[nodiscard]] Forcing shaking_of(Forcing const& forcing, double side) const {
        return setup.lopsided ? setup.incline.shaking_of(forcing, side) : forcing;
    }
    /// Energy of rocking above rest over m g R.
    [[nodiscard]] double energy() const {
        return rocking_energy(state.omega / corner().p_radps, corner().potential.at(state.phi));
    }
    /// All mechanical energy above rest, per mass [J/kg].
    [[nodiscard]] double mechanical_energy() const;
    /// Off the ground, free of torque, until it lies.
    void show_flight(double flight_s) {
        constexpr int instants = 16;
        for (int i = 1; log.observed() && i <= instants; ++i) {
            double const later = flight_s * i / instants;
            log.show({sample.now() + later, state.side * (state.phi + state.omega * later), state.side * state.omega, 0,
                      0, state.slip_m, state.slip_velocity_mps});
        }
    }
    void show(double friction, double normal) {
        if (log.observed()) {
            log.show({sample.now(), state.side * state.phi, state.side * state.omega, friction, normal, state.slip_m,
                      state.slip_velocity_mps});
        }
    }
};

/// From the start to the end.
[[nodiscard]] RockingOutcome run_from_start(RockingRun& run, RockingStart const& start);
/// Goes on where another one stopped.
[[nodiscard]] RockingOutcome run_from_checkpoint(RockingRun& run, Checkpoint const& checkpoint);

// The same in pieces, for trials whose steps are taken side by side.
void begin(RockingRun& run, RockingStart const& start);
/// Until the block rocks without slip: then everything up to the next instant that needs care can be left to
/// step_lanes. \return false once the trial is over
[[nodiscard]] bool advance(RockingRun& run);
[[nodiscard]] RockingOutcome const& finish(RockingRun& run);

}  // namespace overturn::rocking
