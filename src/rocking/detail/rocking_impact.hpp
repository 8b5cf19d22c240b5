/// Base impacts and the bouncing that settles. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// Reset: phi = 0, omega -> e omega on the other corner; the slip velocity by the friction-limited impulse.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::apply_impact() {
    auto& out = log_.outcome();
    ++out.impacts;
    double const speed = std::max(0.0, -omega_);
    out.impact_spin_radps = std::max(out.impact_spin_radps, speed);
    log_.raise_energy(0.5 * speed * speed / (corner_.p_radps * corner_.p_radps));
    phi_ = 0;
    show(0, 0);
    double const e = corner_.restitution;
    double rebound = e * speed;
    if constexpr (limited) {
        double const before =
            corner_.radius_m * corner_.radius_m * corner_.law.energy(-side_ * speed, v_mps_ / corner_.radius_m);
        auto const after = after_impact(corner_.law, -side_ * speed, v_mps_ / corner_.radius_m);
        if constexpr (slipping) {
            rebound = std::abs(after.rotation_rate);
            v_mps_ = after.slip_rate * corner_.radius_m;
            out.energy.impact_loss +=
                before
                - corner_.radius_m * corner_.radius_m * corner_.law.energy_after(after.rotation_rate, after.slip_rate);
        } else if (after.slip_rate != 0) {
            log_.end_at_slip();
            return;
        }
    }
    if (v_mps_ == 0) {
        log_.raise_demand(mode_ == Mode::rock ? impact_demand() : 0);
        mode_ = Mode::rock;
    } else {
        mode_ = Mode::slip_rock;
        sigma_ = v_mps_ < 0 ? -1.0 : 1.0;
        slipped_ = true;
    }
    stand_on(-side_);
    omega_ = rebound;
    start_root_ = StartRoot::simple;
    show(0, 0);
    double const a = sample_.horizontal(sample_.tau_s);
    double const gv = sample_.vertical(sample_.tau_s);
    double const hold = gv * tipped_by(a).uplift_ratio;
    if (mode_ == Mode::slip_rock) {
        settle_slipping(a, hold);
        return;
    }
    if (std::abs(a) > hold) {  // driven: it rocks on, however slow
        if (omega_ == 0) {
            lift(a);
        }
        return;
    }
    if (omega_ <= accuracy_.settle * corner_.p_radps) {
        settle(a, gv);
    }
}

// |P_x| / P_z of an impact after which the corner sticks.
template <int Order, class Restoring, bool Vertical, Slip Friction>
double Integrator<Order, Restoring, Vertical, Friction>::impact_demand() const {
    double const e = corner_.restitution;
    return lopsided_ ? corner_.law.cosine_alpha * (1 - e) / corner_.law.impulse(e)
                     : (1 - e) / ((1 + e) * corner_.uplift_ratio);
}

// Bounces that slip accumulate as well, each a fraction of the one before; only the slip may outlast them. What they
// would still have done to it follows from momentum: the centre's h theta' goes over into the slip, and as the base
// carries b omega less than the weight's impulse, friction brakes it that much less.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::settle_slipping(double a, double hold) {
    double const slow = rest_speed_share * accuracy_.settle * corner_.p_radps;
    bool const sticks = std::abs(v_mps_) <= slow * corner_.radius_m;
    bool const tips = block_.friction_kinetic > at_side(sigma_).base_ratio;
    if (omega_ > slow || (tips && !sticks && omega_ > 0)) {
        return;
    }
    auto& energy = log_.outcome().energy;
    energy.impact_loss += mechanical_energy();
    double const saved = block_.friction_kinetic * corner_.radius_m * corner_.law.sine_alpha * omega_;
    double const slip = v_mps_ + corner_.radius_m * corner_.law.cosine_alpha * side_ * omega_ + sigma_ * saved;
    double const work = saved * std::abs(v_mps_);
    omega_ = 0;
    if (sticks || sigma_ * slip <= 0) {
        v_mps_ = 0;
        mode_ = Mode::rest;
        if (std::abs(a) > hold) {
            lift(a);
        }
    } else if (tips) {  // a sliding base tips towards its slip
        stand_on(sigma_);
        start_root_ = StartRoot::twofold;
    } else {
        v_mps_ = slip;
        mode_ = Mode::slide;
        energy.friction_work -= work;
        energy.impact_loss += work;
    }
    energy.impact_loss -= mechanical_energy();
}

// Impacts accumulate at a finite time: with the forcing as it is now the half cycles last 2 omega / decel, each e times
// the one before, over alternating corners. If the sum ends within this sample the block is at rest from then on.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::settle(double a, double gv) {
    double const end = sample_.tau_s + bouncing_s(a, gv);
    double const a_end = sample_.horizontal(end);
    double const hold = gv * corner_.uplift_ratio;
    if (end <= sample_.length_s && std::abs(a_end) <= sample_.vertical(end) * tipped_by(a_end).uplift_ratio
        && tail_sticks(a, lopsided_ ? gv : hold / corner_.uplift_ratio)) {
        sample_.tau_s = end;
    } else if (omega_ > rest_speed_share * accuracy_.settle * corner_.p_radps) {
        return;
    }
    if constexpr (slipping) {
        log_.outcome().energy.impact_loss += mechanical_energy();
    }
    mode_ = Mode::rest;
    omega_ = 0;
    if constexpr (slipping) {
        log_.outcome().energy.impact_loss -= mechanical_energy();  // what slip down a slope has won stays
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
double Integrator<Order, Restoring, Vertical, Friction>::bouncing_s(double a, double gv) const {
    auto const braking = [&](Corner const& at, double side) {
        double const cosine = nonlinear ? std::cos(at.alpha_rad) : 1.0;  // the linear block's sin psi is psi
        return at.p_radps * at.p_radps * cosine * (gv * at.uplift_ratio + side * a);
    };
    auto const& other = at_side(-side_);
    double const e = corner_.restitution;
    return 2 * omega_ * (1 / braking(corner_, side_) + e / braking(other, -side_)) / (1 - e * other.restitution);
}

// Whether the small half cycles on both corners need no more friction than there is.
template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::tail_sticks(double a, double gv) const {
    if constexpr (!limited) {
        return true;
    }
    auto const sticks_on = [&](double side) {
        auto const& at = at_side(side);
        double const acceleration = -at.p_radps * at.p_radps * (at.sine_alpha * gv + side * a * at.cosine_alpha);
        auto const [friction, normal] =
            turned(side * a + at.r * at.cosine_alpha * acceleration, gv + at.r * at.sine_alpha * acceleration, side);
        return std::abs(friction) <= block_.friction_static * normal;
    };
    return sticks_on(1.0) && sticks_on(-1.0);
}

}  // namespace overturn::rocking
