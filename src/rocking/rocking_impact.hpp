/// Base impacts and the bouncing that settles. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/rocking_integrator.hpp"

namespace overturn::rocking {

// Reset: phi = 0, omega -> e omega on the other corner; the slip velocity by the friction-limited impulse.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::strike() {
    auto& out = log_.outcome();
    ++out.impacts;
    double const speed = std::max(0.0, -omega_);
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
    if (mode_ == Mode::slip_rock) {
        bool const tips = block_.friction_kinetic > uplift_ratio_;
        constexpr double invisible = 1e-3;
        if (!tips && omega_ <= invisible * accuracy_.settle * block_.p_radps) {
            out.energy.impact_loss += mechanical_energy();
            omega_ = 0;
            out.energy.impact_loss -= mechanical_energy();
            mode_ = Mode::slide;
        }
        return;
    }
    double const hold = gv * uplift_ratio_;
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

// Impacts accumulate at a finite time: with the forcing as it is now the swings last 2 omega / decel, each e times
// the one before, over alternating corners. If the sum ends within this sample the block is at rest from then on.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::settle(double a, double hold) {
    double const e = block_.restitution;
    double const scale = block_.p_radps * block_.p_radps * std::cos(block_.alpha_rad);
    double const here = scale * (hold + side_ * a);
    double const there = scale * (hold - side_ * a);
    double const duration = 2 * omega_ * (1 / here + e / there) / (1 - e * e);
    double const end = sample_.tau_s + duration;
    constexpr double invisible = 1e-3;  // below settle: at rest whatever the forcing does next
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
