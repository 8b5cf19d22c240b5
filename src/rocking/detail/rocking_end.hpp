/// How a trial ends: what follows the shaking, and what it leaves. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// No shaking any more: step on only until energy decides, and until no later peak can be higher. A block that has
// slipped may slip on: it is followed until it rests.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::run_out(double end_s) {
    double const length = shaking_.time_step_s > 0 ? shaking_.time_step_s : 0.01 / corner_.p_radps;
    double const balance_s = 100 / corner_.p_radps;  // exp(37) lifts the last bit to one; only an exact balance lasts
    log_.raise_energy(rocking_energy());
    for (std::int64_t i = 0; !log_.done() && mode_ != Mode::rest; ++i) {
        sample_.calm(end_s + static_cast<double>(i) * length, length);
        if ((!slipped_ && decided()) || sample_.now() - end_s > balance_s) {
            break;
        }
        steps_here_ = 0;
        while (!log_.done() && sample_.tau_s < sample_.length_s) {
            step();
        }
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::decided() const {
    double const energy = rocking_energy();
    if (phi_ >= corner_.alpha_rad || energy * corner_.weight >= top_) {
        return false;
    }
    double const e = corner_.restitution;
    constexpr double slack = 1e-12;
    if (lopsided_) {  // the half cycle in hand, the next one over the other corner, and the first of the later ones
                      // here
        auto const reached = [&](Corner const& at, double left) {
            return at.reach * Restoring::turning_point(at.alpha_rad, left * corner_.weight / at.weight);
        };
        auto const& other = at_side(-side_);
        double const later =
            std::max(reached(other, e * e * energy),
                     reached(corner_, omega_ > 0 ? energy : e * e * energy * std::pow(other.restitution, 2)));
        return later <= log_.outcome().peak_reach_rad * (1 + slack);
    }
    double const turning = Restoring::turning_point(corner_.alpha_rad, omega_ > 0 ? energy : e * e * energy);
    return turning <= log_.peak() * (1 + slack);
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
RockingOutcome const& Integrator<Order, Restoring, Vertical, Friction>::finish() {
    auto& out = log_.outcome();
    if (out.verdict == Verdict::at_rest) {
        out.verdict = !std::isnan(out.first_uplift_s) ? Verdict::rocked : slipped_ ? Verdict::slid : Verdict::at_rest;
    }
    out.residual_slip_m = x_m_;
    out.energy.mechanical = mechanical_energy();
    if (!std::isfinite(out.peak_rotation_rad + out.peak_energy_ratio + phi_ + omega_ + x_m_ + v_mps_)) {
        out.verdict = Verdict::failed;
        out.failure = FailureReason::no_convergence;
    }
    return out;
}

}  // namespace overturn::rocking
