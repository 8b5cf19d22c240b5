/// The time loop of planar rocking: modes, steps, events and resets. Included by planar_rocking.cpp only.
#pragma once

#include "rocking/impact.hpp"
#include "rocking/rocking_events.hpp"
#include "rocking/sample.hpp"
#include "rocking/slip_series.hpp"
#include "rocking/trial_log.hpp"
#include "rocking/work.hpp"

namespace overturn::rocking {

/// rest: full base contact, at rest. slide: full contact, slipping. rock: on one corner, stuck. slip_rock: both.
enum class Mode { rest, slide, rock, slip_rock };

template <int Order, class Restoring, bool Vertical, Slip Friction> class Integrator {
  public:
    Integrator(RockingBlock const& block, Shaking const& shaking, RockingAccuracy const& accuracy,
               RockingObserver* observer);
    RockingOutcome run(RockingStart const& start);

  private:
    static constexpr bool nonlinear = std::is_same_v<Restoring, NonlinearRestoring>;
    static constexpr bool slipping = Friction == Slip::simulated;
    static constexpr bool limited = Friction != Slip::ignored;  ///< friction has a limit that is looked at
    /// Bouncing slower than this fraction of accuracy.settle is rest, whatever the forcing does next.
    static constexpr double invisible = 1e-3;

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

    // time loop (this file, below)
    void begin(RockingStart const& start);
    std::size_t skip_rest(std::size_t i);
    void advance_sample();
    void run_out(double end_s);
    [[nodiscard]] bool decided() const;
    void finish();
    // full base contact (rocking_rest.hpp)
    void rest();
    void leave_rest(double tau, double acceleration);
    void lift(double acceleration);
    void slide();
    // on a corner (rocking_step.hpp)
    void rock();
    void slip_rock();
    [[nodiscard]] double step_length(Series<Order> const& series);
    [[nodiscard]] Ending limits_of_contact(Series<Order> const& series, Forcing const& forcing, double friction,
                                           double normal, double h) const;
    void find_overturning(Series<Order> const& series, Ending& ending) const;
    void move(Series<Order> const& series, Ending const& ending);
    void start_slip(double friction);
    void lose_contact(bool at_rest);
    void raise_energy_inside(Series<Order> const& series, Forcing const& forcing, double end);
    // at phi = 0 (rocking_impact.hpp)
    void strike();
    void settle(double a, double hold);
    void settle_slipping(double a, double hold);
    [[nodiscard]] bool tail_sticks(double a, double gv) const;

    /// Energy of rocking above rest over m g R.
    [[nodiscard]] double rocking_energy() const {
        double const rate = omega_ / block_.p_radps;
        return 0.5 * rate * rate + Restoring::potential(block_.alpha_rad, phi_);
    }
    /// All mechanical energy above rest, per mass [J/kg].
    [[nodiscard]] double mechanical_energy() const {
        double const psi = block_.alpha_rad - phi_;
        double const spin = radius_m_ * side_ * omega_;
        double const across = v_mps_ + std::cos(psi) * spin;
        double const up = std::sin(psi) * spin;
        return 0.5 * (across * across + up * up + law_.kappa * spin * spin)
               + block_.gravity_mps2 * radius_m_ * Restoring::potential(block_.alpha_rad, phi_);
    }
    void show(double friction, double normal) {
        if (log_.observed()) {
            log_.show({sample_.now(), side_ * phi_, side_ * omega_, friction, normal, x_m_, v_mps_});
        }
    }

    RockingBlock block_;
    Shaking shaking_;
    RockingAccuracy accuracy_;
    double uplift_ratio_, hold_ratio_, top_, r_, radius_m_;
    ImpactLaw law_;
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
};

template <int Order, class Restoring, bool Vertical, Slip Friction>
Integrator<Order, Restoring, Vertical, Friction>::Integrator(RockingBlock const& block, Shaking const& shaking,
                                                             RockingAccuracy const& accuracy, RockingObserver* observer)
    : block_(block),
      shaking_(shaking),
      accuracy_(accuracy),
      uplift_ratio_(Restoring::uplift_ratio(block.alpha_rad)),
      hold_ratio_(limited ? std::min(block.friction_static, uplift_ratio_) : uplift_ratio_),
      top_(Restoring::top(block.alpha_rad)),
      r_(block.inertia_ratio / (block.p_radps * block.p_radps)),
      radius_m_(block.radius_m()),
      law_{std::sin(block.alpha_rad), std::cos(block.alpha_rad), 1 / block.inertia_ratio - 1,
           block.restitution,         block.friction_static,     block.friction_kinetic},
      log_(top_, observer) {}

template <int Order, class Restoring, bool Vertical, Slip Friction>
RockingOutcome Integrator<Order, Restoring, Vertical, Friction>::run(RockingStart const& start) {
    begin(start);
    std::size_t const n = shaking_.horizontal_mps2.size();
    for (std::size_t i = 0; i + 1 < n && !log_.done(); ++i) {
        if (mode_ == Mode::rest && !log_.observed()) {
            i = skip_rest(i);
            if (i + 1 >= n) {
                break;
            }
        }
        sample_.load(shaking_, block_.gravity_mps2, i);
        advance_sample();
    }
    if (!log_.done() && mode_ != Mode::rest) {
        run_out(static_cast<double>(n == 0 ? 0 : n - 1) * shaking_.time_step_s);
    }
    finish();
    return log_.outcome();
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::begin(RockingStart const& start) {
    if (start.rotation_rad == 0 && start.velocity_radps == 0) {
        return;
    }
    side_ = (start.rotation_rad != 0 ? start.rotation_rad : start.velocity_radps) < 0 ? -1.0 : 1.0;
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

// The first sample from i on in which the block could move: most of most waves is passed here.
template <int Order, class Restoring, bool Vertical, Slip Friction>
std::size_t Integrator<Order, Restoring, Vertical, Friction>::skip_rest(std::size_t i) {
    std::size_t const last = shaking_.horizontal_mps2.size() - 1;
    double const k = shaking_.scale / block_.gravity_mps2;
    double most = 0;
    double least = 1;
    auto const holds = [&](std::size_t sample) {
        double const a = std::abs(k * shaking_.horizontal_mps2[sample]);
        double gv = 1;
        if constexpr (Vertical) {
            gv = 1 + k * shaking_.vertical_mps2[sample];
        }
        if (a > gv * hold_ratio_ || !(gv > 0)) {
            return false;
        }
        most = std::max(most, Vertical ? a / gv : a);
        least = std::min(least, gv);
        return true;
    };
    if (holds(i)) {
        while (i < last && holds(i + 1)) {
            ++i;
        }
    }
    log_.raise_demand(most);
    log_.lower_contact(least);
    return i;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::advance_sample() {
    constexpr int hopeless = 1000000;  // steps within one sample: a trial must end
    for (int steps = 0; !log_.done() && sample_.tau_s < sample_.length_s; ++steps) {
        if (steps == hopeless) {
            log_.end(Verdict::failed);
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
}

// No shaking any more: step on only until energy decides, and until no later peak can be higher. A block that has
// slipped may slip on: it is followed until it rests.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::run_out(double end_s) {
    double const length = shaking_.time_step_s > 0 ? shaking_.time_step_s : 0.01 / block_.p_radps;
    double const balance_s = 100 / block_.p_radps;  // exp(37) lifts the last bit to one; only an exact balance lasts
    for (std::int64_t i = 0; !log_.done() && mode_ != Mode::rest; ++i) {
        sample_.calm(end_s + static_cast<double>(i) * length, length);
        if ((!slipped_ && decided()) || sample_.now() - end_s > balance_s) {
            break;
        }
        advance_sample();
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::decided() const {
    double const energy = rocking_energy();
    if (phi_ >= block_.alpha_rad || energy >= top_) {
        return false;
    }
    double const e = block_.restitution;
    double const turning = Restoring::turning_point(block_.alpha_rad, omega_ > 0 ? energy : e * e * energy);
    constexpr double slack = 1e-12;
    return turning <= log_.outcome().peak_rotation_rad * (1 + slack);
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::finish() {
    auto& out = log_.outcome();
    if (out.verdict == Verdict::at_rest) {
        out.verdict = out.first_uplift_s >= 0 ? Verdict::rocked : slipped_ ? Verdict::slid : Verdict::at_rest;
    }
    out.residual_slip_m = x_m_;
    out.energy.mechanical = mechanical_energy();
    if (!std::isfinite(out.peak_rotation_rad + out.peak_energy_ratio + phi_ + omega_ + x_m_ + v_mps_)) {
        out.verdict = Verdict::failed;
    }
}

}  // namespace overturn::rocking

#include "rocking/rocking_impact.hpp"
#include "rocking/rocking_rest.hpp"
#include "rocking/rocking_step.hpp"
