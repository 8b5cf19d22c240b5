/// Base impacts and the bouncing that settles. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// Reset: phi = 0, omega -> e omega on the other corner; the slip velocity by the friction-limited impulse.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::strike() {
    auto& out = log_.outcome();
    ++out.impacts;
    double const speed = std::max(0.0, -omega_);
    out.impact_spin_radps = std::max(out.impact_spin_radps, speed);
    log_.raise_energy(0.5 * speed * speed / (block_.p_radps * block_.p_radps));
    phi_ = 0;
    show(0, 0);
    double const e = block_.restitution;
    double rebound = e * speed;
    if constexpr (limited) {
        double const before = radius_m_ * radius_m_ * law_.energy(-side_ * speed, v_mps_ / radius_m_);
        auto const after = overturn::rocking::strike(law_, -side_ * speed, v_mps_ / radius_m_);
        if constexpr (slipping) {
            rebound = std::abs(after.rotation_rate);
            v_mps_ = after.slip_rate * radius_m_;
            out.energy.impact_loss +=
                before - radius_m_ * radius_m_ * law_.energy(after.rotation_rate, after.slip_rate);
        } else if (after.slip_rate != 0) {
            log_.call_slip();
            return;
        }
    }
    if (v_mps_ == 0) {
        log_.raise_demand(mode_ == Mode::rock ? (1 - e) / ((1 + e) * uplift_ratio_) : 0);
        mode_ = Mode::rock;
    } else {
        mode_ = Mode::slip_rock;
        sigma_ = v_mps_ < 0 ? -1.0 : 1.0;
        slipped_ = true;
    }
    side_ = -side_;
    omega_ = rebound;
    start_root_ = StartRoot::simple;
    show(0, 0);
    double const a = sample_.horizontal(sample_.tau_s);
    double const gv = sample_.vertical(sample_.tau_s);
    double const hold = gv * uplift_ratio_;
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
    if (omega_ <= accuracy_.settle * block_.p_radps) {
        settle(a, hold);
    }
}

// Bounces that slip accumulate as well, each a fraction of the one before; only the slip may outlast them. What they
// would still have done to it follows from momentum: the centre's h theta' goes over into the slip, and as the base
// carries b omega less than the weight's impulse, friction brakes it that much less.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::settle_slipping(double a, double hold) {
    double const slow = invisible * accuracy_.settle * block_.p_radps;
    bool const sticks = std::abs(v_mps_) <= slow * radius_m_;
    bool const tips = block_.friction_kinetic > uplift_ratio_;
    if (omega_ > slow || (tips && !sticks && omega_ > 0)) {
        return;
    }
    auto& energy = log_.outcome().energy;
    energy.impact_loss += mechanical_energy();
    double const saved = block_.friction_kinetic * radius_m_ * law_.sine_alpha * omega_;
    double const slip = v_mps_ + radius_m_ * law_.cosine_alpha * side_ * omega_ + sigma_ * saved;
    double const work = saved * std::abs(v_mps_);
    omega_ = 0;
    if (sticks || sigma_ * slip <= 0) {
        v_mps_ = 0;
        mode_ = Mode::rest;
        if (std::abs(a) > hold) {
            lift(a);
        }
    } else if (tips) {  // a sliding base tips towards its slip
        side_ = sigma_;
        start_root_ = StartRoot::twofold;
    } else {
        v_mps_ = slip;
        mode_ = Mode::slide;
        energy.friction_work -= work;
        energy.impact_loss += work;
    }
    energy.impact_loss -= mechanical_energy();
}

// Impacts accumulate at a finite time: with the forcing as it is now the swings last 2 omega / decel, each e times
// the one before, over alternating corners. If the sum ends within this sample the block is at rest from then on.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::settle(double a, double hold) {
    double const e = block_.restitution;
    double const cosine = nonlinear ? std::cos(block_.alpha_rad) : 1.0;  // the linear block's sin psi is psi
    double const scale = block_.p_radps * block_.p_radps * cosine;
    double const here = scale * (hold + side_ * a);
    double const there = scale * (hold - side_ * a);
    double const duration = 2 * omega_ * (1 / here + e / there) / (1 - e * e);
    double const end = sample_.tau_s + duration;
    if (end <= sample_.length_s && std::abs(sample_.horizontal(end)) <= sample_.vertical(end) * uplift_ratio_
        && tail_sticks(a, hold / uplift_ratio_)) {
        sample_.tau_s = end;
    } else if (omega_ > invisible * accuracy_.settle * block_.p_radps) {
        return;
    }
    if constexpr (slipping) {
        log_.outcome().energy.impact_loss += mechanical_energy();
    }
    mode_ = Mode::rest;
    omega_ = 0;
}

// Whether the small swings on both corners need no more friction than there is.
template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::tail_sticks(double a, double gv) const {
    if constexpr (!limited) {
        return true;
    }
    auto const sticks_on = [&](double side) {
        double const acceleration =
            -block_.p_radps * block_.p_radps * (law_.sine_alpha * gv + side * a * law_.cosine_alpha);
        double const friction = side * a + r_ * law_.cosine_alpha * acceleration;
        double const normal = gv + r_ * law_.sine_alpha * acceleration;
        return std::abs(friction) <= block_.friction_static * normal;
    };
    return sticks_on(1.0) && sticks_on(-1.0);
}

}  // namespace overturn::rocking
