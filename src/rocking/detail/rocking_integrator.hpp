/// The time loop of planar rocking: modes, steps, events and resets. Included by planar_rocking.cpp only.
#pragma once

#include "model/chunk_extremes.hpp"
#include "rocking/detail/checkpoint.hpp"
#include "rocking/detail/impact.hpp"
#include "rocking/detail/incline.hpp"
#include "rocking/detail/lane_step.hpp"
#include "rocking/detail/rocking_events.hpp"
#include "rocking/detail/sample.hpp"
#include "rocking/detail/slip_series.hpp"
#include "rocking/detail/trial_log.hpp"
#include "rocking/detail/work.hpp"

namespace overturn::rocking {

template <int Order, class Restoring, bool Vertical, Slip Friction> class Integrator {
  public:
    Integrator(RockingBlock const& block, Excitation const& shaking, RockingAccuracy const& accuracy,
               RockingObserver* observer);
    RockingOutcome run(RockingStart const& start);

    // The same in pieces, for lanes that are stepped together (rocking_swing.hpp).
    void begin(RockingStart const& start);
    /// Until the block rocks without slip: then everything up to the next instant that needs care can be left to
    /// step_lanes. \return false once the trial is over
    bool advance();
    template <int Lanes> void load_lane(RockingFields<Lanes>& lanes, int lane) const;
    template <int Lanes> void store_lane(RockingFields<Lanes> const& lanes, int lane);
    RockingOutcome const& finish();

    /// Where friction gave out, of a trial that is over.
    [[nodiscard]] Checkpoint const& checkpoint() const { return checkpoint_; }
    /// Goes on where another one stopped at slip.
    RockingOutcome run_from(Checkpoint const& checkpoint);

  private:
    static constexpr bool nonlinear = std::is_same_v<Restoring, NonlinearRestoring>;
    static constexpr bool lanes_offered = nonlinear && Order == LaneStep::order;  ///< what step_lanes is made for
    static constexpr bool slipping = Friction == Slip::simulated;
    static constexpr bool limited = Friction != Slip::ignored;  ///< friction has a limit that is looked at
    /// Bouncing slower than this fraction of accuracy.settle is rest, whatever the forcing does next.
    static constexpr double rest_speed_share = 1e-3;

    /// What ends a step before its length is up.
    enum class Event { none, impact, overturned, slip_starts, slip_stops, contact_lost };
    struct Ending {
        double at;
        Event event;
        double friction = 0;  ///< its sign, mirrored, where slip starts
        /// `t` in [0, at) becomes the earlier ending.
        void earlier(double t, Event e, double f = 0) {
            if (t >= 0 && t < at) {
                *this = {t, e, f};
            }
        }
    };

    /// What the corner in hand, or the only kind there is, lends to the equations.
    struct Corner {
        double alpha_rad, base_angle_rad, p_radps, restitution, inertia_ratio;
        double sine_alpha, cosine_alpha;
        double uplift_ratio;  ///< tan(alpha)
        double hold_ratio;    ///< |a| / gv up to which neither tips towards it nor slides
        double base_ratio;    ///< b / h: friction below it slides and never tips
        double r, radius_m;
        ImpactLaw law;
        double side = 0, reach = 1, weight = 1;  ///< TrialLog::stand_on
    };
    [[nodiscard]] static Corner corner_of(RockingBlock const& block, RockingCorner const& corner, double side);
    [[nodiscard]] static Corner corner_of(RockingBlock const& block);
    [[nodiscard]] Corner const& at_side(double side) const { return lopsided_ ? corners_[side < 0 ? 1 : 0] : corner_; }
    /// The corner that an acceleration tips towards.
    [[nodiscard]] Corner const& tipped_by(double a) const { return at_side(a > 0 ? -1.0 : 1.0); }
    void stand_on(double side) {
        side_ = side;
        if (lopsided_) {
            corner_ = corners_[side < 0 ? 1 : 0];
            log_.stand_on(corner_.side, corner_.reach, corner_.weight);
        }
    }

    // time loop (this file, below; step_with_checkpoint and run_from: rocking_checkpoint.hpp)
    void skip_rest();
    void skip_lopsided_rest();
    [[nodiscard]] bool next_sample();
    void step();
    void step_with_checkpoint();
    // once the wave is over (rocking_end.hpp, with finish)
    void run_out(double end_s);
    [[nodiscard]] bool decided() const;
    // in a lane (rocking_swing.hpp)
    void step_in_lane();
    void step_lane_observed();
    bool step_unless_slip();
    void account_for(RockingFields<1> const& before, RockingFields<1> const& after, LaneStep const& series);
    void show_lane_step(RockingFields<1> const& before, LaneStep const& series);
    void show_impact(RockingFields<1> const& after);
    // full base contact (rocking_rest.hpp)
    void rest();
    void leave_rest(double tau, double acceleration);
    void lift(double acceleration);
    void slide();
    // on a corner (rocking_step.hpp)
    void rock();
    void slip_rock();
    [[nodiscard]] double step_length(Series<Order> const& series);
    struct ContactForces {
        double friction, normal;  ///< over m g, mirrored
    };
    [[nodiscard]] ContactForces turned(double friction, double normal, double side) const {
        if (!lopsided_) {
            return {friction, normal};
        }
        auto const [along, across] = incline_.turned(friction, normal, side);
        return {along, across};
    }
    /// Forcing along and across the ground, mirrored to a side.
    [[nodiscard]] Forcing forcing_of_ground(double side) const {
        auto const forcing = sample_.forcing(side);
        return lopsided_ ? incline_.turned(forcing, side) : forcing;
    }
    [[nodiscard]] Forcing shaking_of(Forcing const& forcing, double side) const {
        return lopsided_ ? incline_.shaking_of(forcing, side) : forcing;
    }
    [[nodiscard]] ContactForces contact_now(Series<Order> const& series, Forcing const& forcing) const;
    [[nodiscard]] bool slips_at_once(ContactForces const& forces) const {
        return limited && std::abs(forces.friction) > hold_friction_ * forces.normal && forces.normal > 0;
    }
    [[nodiscard]] Ending limits_of_contact(Series<Order> const& series, Forcing const& forcing,
                                           ContactForces const& forces, double h) const;
    void watch_landing();
    void find_overturning(Series<Order> const& series, Ending& ending) const;
    void move(Series<Order> const& series, Ending const& ending);
    void start_slip(double friction);
    void lose_contact(bool at_rest);
    void raise_energy_inside(Series<Order> const& series, Forcing const& forcing, double end);
    // at phi = 0 (rocking_impact.hpp)
    void apply_impact();
    void settle(double a, double gv);
    void settle_slipping(double a, double hold);
    [[nodiscard]] double bouncing_s(double a, double gv) const;
    [[nodiscard]] double impact_demand() const;
    [[nodiscard]] bool tail_sticks(double a, double gv) const;

    /// Energy of rocking above rest over m g R.
    [[nodiscard]] double rocking_energy() const {
        double const rate = omega_ / corner_.p_radps;
        return 0.5 * rate * rate + Restoring::potential(corner_.alpha_rad, phi_);
    }
    /// All mechanical energy above rest, per mass [J/kg].
    [[nodiscard]] double mechanical_energy() const {
        double const psi = corner_.base_angle_rad - phi_;
        double const spin = corner_.radius_m * side_ * omega_;
        double const across = v_mps_ + std::cos(psi) * spin;
        double const up = std::sin(psi) * spin;
        return 0.5 * (across * across + up * up + corner_.law.kappa * spin * spin)
               + block_.gravity_mps2 * corner_.radius_m * Restoring::potential(corner_.alpha_rad, phi_) - downhill();
    }
    /// What slip has won of height, times g.
    [[nodiscard]] double downhill() const { return lopsided_ ? block_.gravity_mps2 * incline_.sine * x_m_ : 0; }
    void show(double friction, double normal) {
        if (log_.observed()) {
            log_.show({sample_.now(), side_ * phi_, side_ * omega_, friction, normal, x_m_, v_mps_});
        }
    }

    RockingBlock block_;
    Excitation shaking_;
    RockingAccuracy accuracy_;
    bool lopsided_;  ///< its corners differ
    Incline incline_;
    Corner corner_;
    std::array<Corner, 2> corners_{};  ///< where they differ: at +x and at -x
    double top_;
    double
        hold_friction_;  ///< what sticking is held against: friction that is just enough holds, whatever rounding says
    TrialLog log_;
    Sample<Vertical> sample_;

    Mode mode_ = Mode::rest;
    double side_ = 1;   ///< the corner: +1 or -1
    double phi_ = 0;    ///< side * theta >= 0
    double omega_ = 0;  ///< phi'
    double x_m_ = 0, v_mps_ = 0;
    double sigma_ = 0;  ///< sign of the slip
    bool slipped_ = false;
    StartRoot start_root_ = StartRoot::none;

    std::size_t index_ = 0;           ///< of the sample
    int steps_here_ = 0;              ///< within it
    double sine_ = 0, cosine_ = 0;    ///< of psi, as the last step in a lane left them
    bool trig_is_current_ = false;    ///< they still hold
    bool needs_scalar_step_ = false;  ///< the next step is one that step_lanes refused
    bool uses_lanes_ = false;
    Checkpoint checkpoint_;
};

template <int Order, class Restoring, bool Vertical, Slip Friction>
RockingOutcome Integrator<Order, Restoring, Vertical, Friction>::run(RockingStart const& start) {
    begin(start);
    while (advance()) {
        step_in_lane();
    }
    return finish();
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::begin(RockingStart const& start) {
    uses_lanes_ = lanes_offered && accuracy_.substeps == 1;
    if (start.rotation_rad == 0 && start.velocity_radps == 0) {
        return;
    }
    stand_on((start.rotation_rad != 0 ? start.rotation_rad : start.velocity_radps) < 0 ? -1.0 : 1.0);
    phi_ = side_ * start.rotation_rad;
    omega_ = side_ * start.velocity_radps;
    start_root_ = phi_ == 0 ? StartRoot::simple : StartRoot::none;
    mode_ = Mode::rock;
    log_.uplifted(0);
    log_.raise_peak(phi_, 0);
    log_.outcome().energy.input = mechanical_energy();  // what the block was given
    if (phi_ >= 0.5 * pi) {
        log_.overturn(0);
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::advance() {
    while (!log_.done()) {
        if (!(sample_.tau_s < sample_.length_s) && !next_sample()) {
            break;
        }
        if (uses_lanes_ && !needs_scalar_step_ && mode_ == Mode::rock && start_root_ != StartRoot::twofold) {
            return true;
        }
        if (needs_scalar_step_ && step_unless_slip()) {
            continue;
        }
        needs_scalar_step_ = false;
        trig_is_current_ = false;
        step_with_checkpoint();
    }
    return false;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::next_sample() {
    std::size_t const n = shaking_.horizontal_mps2.size();
    index_ += sample_.length_s > 0 ? 1 : 0;
    if (mode_ == Mode::rest && !log_.observed()) {
        skip_rest();
    }
    if (index_ + 1 < n) {
        sample_.load(shaking_, block_.gravity_mps2, index_);
        steps_here_ = 0;
        return true;
    }
    if (mode_ != Mode::rest) {
        run_out(static_cast<double>(n == 0 ? 0 : n - 1) * shaking_.time_step_s);
    }
    return false;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::step() {
    constexpr int max_steps_per_sample = 1000000;  // a trial must end
    if (++steps_here_ > max_steps_per_sample) {
        log_.fail(FailureReason::no_convergence);
        return;
    }
    switch (mode_) {
        case Mode::rest:
            rest();
            break;
        case Mode::slide:
            slide();
            break;
        case Mode::rock:
            rock();
            break;
        case Mode::slip_rock:
            slip_rock();
            break;
    }
}

}  // namespace overturn::rocking

#include "rocking/detail/rocking_checkpoint.hpp"
#include "rocking/detail/rocking_corner.hpp"
#include "rocking/detail/rocking_end.hpp"
#include "rocking/detail/rocking_impact.hpp"
#include "rocking/detail/rocking_rest.hpp"
#include "rocking/detail/rocking_step.hpp"
#include "rocking/detail/rocking_swing.hpp"
