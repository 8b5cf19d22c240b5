/// Rocking without slip, as step_lanes steps it, alone or beside others. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

/// Friction without a limit, as a number that may be multiplied.
inline constexpr double unlimited = 1e300;

template <int Order, class Restoring, bool Vertical, Slip Friction>
template <int Lanes>
void Integrator<Order, Restoring, Vertical, Friction>::load_lane(RockingFields<Lanes>& lanes, int lane) const {
    auto const set = [&](RockingField field, double value) { lanes.at(field, lane) = value; };
    auto const& out = log_.outcome();
    double const psi = corner_.alpha_rad - phi_;
    set(RockingField::phi, phi_);
    set(RockingField::omega, omega_);
    set(RockingField::sine, trig_is_current_ ? sine_ : phi_ == 0 ? corner_.sine_alpha : std::sin(psi));
    set(RockingField::cosine, trig_is_current_ ? cosine_ : phi_ == 0 ? corner_.cosine_alpha : std::cos(psi));
    set(RockingField::side, side_);
    set(RockingField::index, static_cast<double>(index_));
    set(RockingField::tau, sample_.tau_s);
    set(RockingField::start, start_root_ == StartRoot::simple ? 1 : 0);
    set(RockingField::peak, log_.peak());
    set(RockingField::peak_time, out.time_of_peak_s);
    set(RockingField::energy, log_.energy());
    set(RockingField::demand, out.friction_demand);
    set(RockingField::normal, out.min_contact_force_ratio);
    set(RockingField::steps, static_cast<double>(out.steps));
    set(RockingField::impacts, static_cast<double>(out.impacts));
    set(RockingField::impact_spin, out.impact_spin_radps);

    double const e = corner_.restitution;
    double const p = corner_.p_radps;
    set(RockingField::p, p);
    set(RockingField::inverse_p, 1 / p);
    set(RockingField::r, corner_.r);
    set(RockingField::inertia_ratio, corner_.inertia_ratio);
    set(RockingField::restitution, e);
    set(RockingField::sine_alpha, corner_.sine_alpha);
    set(RockingField::cosine_alpha, corner_.cosine_alpha);
    set(RockingField::uplift_ratio, corner_.uplift_ratio);
    set(RockingField::friction_limit, limited ? std::min(unlimited, block_.friction_static) : unlimited);
    // An impact over a corner unlike this one needs care: it changes what is set here.
    set(RockingField::impact_demand, lopsided_ ? std::numeric_limits<double>::infinity() : impact_demand());
    set(RockingField::incline_sine, side_ * incline_.sine);
    set(RockingField::incline_cosine, incline_.cosine);
    set(RockingField::settle_speed, accuracy_.settle * p);
    // Bounces last 2 omega / deceleration, each e times the one before; the weaker side sets the longest.
    set(RockingField::settle_rate, 2 / ((1 - e) * p * p * corner_.cosine_alpha));
    set(RockingField::tolerance, accuracy_.step_tolerance * corner_.alpha_rad);
    set(RockingField::scale, shaking_.scale / block_.gravity_mps2);
    set(RockingField::time_step, shaking_.time_step_s);
    set(RockingField::sampling_rate, 1 / shaking_.time_step_s);
    set(RockingField::last, static_cast<double>(shaking_.horizontal_mps2.size() - 1));
    lanes.at(RockingWave::horizontal, lane) = shaking_.horizontal_mps2.data();
    lanes.at(RockingWave::vertical, lane) = Vertical ? shaking_.vertical_mps2.data() : nullptr;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
template <int Lanes>
void Integrator<Order, Restoring, Vertical, Friction>::store_lane(RockingFields<Lanes> const& lanes, int lane) {
    auto const get = [&](RockingField field) { return lanes.at(field, lane); };
    auto& out = log_.outcome();
    phi_ = get(RockingField::phi);
    omega_ = get(RockingField::omega);
    sine_ = get(RockingField::sine);
    cosine_ = get(RockingField::cosine);
    trig_is_current_ = true;
    side_ = get(RockingField::side);
    index_ = static_cast<std::size_t>(get(RockingField::index));
    start_root_ = get(RockingField::start) > 0 ? StartRoot::simple : StartRoot::none;
    if (get(RockingField::peak) > log_.peak()) {
        log_.raise_peak(get(RockingField::peak), get(RockingField::peak_time));
    }
    if (get(RockingField::energy) > log_.energy()) {  // what comes back as it went in may not be raised by rounding
        log_.raise_energy(get(RockingField::energy));
    }
    out.friction_demand = get(RockingField::demand);
    out.min_contact_force_ratio = get(RockingField::normal);
    out.steps = static_cast<std::int64_t>(get(RockingField::steps));
    out.impacts = static_cast<std::int64_t>(get(RockingField::impacts));
    out.impact_spin_radps = get(RockingField::impact_spin);
    needs_scalar_step_ = true;
    if (index_ + 1 < shaking_.horizontal_mps2.size()) {
        sample_.load(shaking_, block_.gravity_mps2, index_);
        sample_.tau_s = get(RockingField::tau);
        needs_scalar_step_ = sample_.tau_s < sample_.length_s;
    } else {
        sample_.tau_s = sample_.length_s;  // the wave is over
        index_ -= 1;
        needs_scalar_step_ = false;
    }
    steps_here_ = 0;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::step_in_lane() {
    if constexpr (lanes_offered) {
        if (slipping || log_.observed()) {
            step_lane_observed();
            return;
        }
        RockingFields<1> lane;
        load_lane(lane, 0);
        step_lanes(lane, Vertical);
        store_lane(lane, 0);
    }
}

// Near the limit of friction step_lanes wants care. If nothing slips after all, its step is the one to take: so that a
// limit which is never reached changes no bit.
template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::step_unless_slip() {
    if constexpr (lanes_offered && limited) {
        RockingFields<1> lane;
        load_lane(lane, 0);
        auto const before = lane;
        lane.at(RockingField::friction_limit, 0) = unlimited;
        LaneStep taken;
        (void)step_lane_once(lane, Vertical, taken);
        bool const impact = lane.at(RockingField::impacts, 0) != before.at(RockingField::impacts, 0);
        if (lane.at(RockingField::steps, 0) == before.at(RockingField::steps, 0)
            || (impact && !(lane.at(RockingField::impact_demand, 0) <= block_.friction_static))) {
            return false;
        }
        Series<Order> series;
        auto const forcing = sample_.forcing(side_);
        expand<Order, Restoring, Vertical>(series, corner_.alpha_rad, corner_.p_radps, phi_, omega_, forcing, false);
        auto const forces = contact_now(series, forcing);
        if (slips_at_once(forces)
            || limits_of_contact(series, forcing, forces, taken.share * taken.length_s).event != Event::none) {
            return false;
        }
        account_for(before, lane, taken);
        store_lane(lane, 0);
        needs_scalar_step_ = false;
        return true;
    }
    return false;
}

// Step by step, where the steps themselves are asked for.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::step_lane_observed() {
    RockingFields<1> lane;
    load_lane(lane, 0);
    LaneStep series;
    for (bool on = true; on;) {
        auto const before = lane;
        on = step_lane_once(lane, Vertical, series);
        if (lane.at(RockingField::steps, 0) == before.at(RockingField::steps, 0)) {
            continue;
        }
        account_for(before, lane, series);
    }
    store_lane(lane, 0);
}

// What a step means to an observer and to the balance of energy.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::account_for(RockingFields<1> const& before,
                                                                   RockingFields<1> const& after,
                                                                   LaneStep const& series) {
    bool const impact = after.at(RockingField::impacts, 0) != before.at(RockingField::impacts, 0);
    show_lane_step(before, series);
    if (impact) {
        show_impact(after);
    }
    if constexpr (slipping) {
        auto& energy = log_.outcome().energy;
        energy.input += block_.gravity_mps2 * corner_.radius_m * shaking_work(series);
        if (impact) {
            double const rebound = corner_.radius_m * after.at(RockingField::omega, 0);
            double const e = corner_.restitution;
            energy.impact_loss += 0.5 / corner_.inertia_ratio * rebound * rebound * (1 / (e * e) - 1);
        }
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::show_impact(RockingFields<1> const& after) {
    if (!log_.observed()) {
        return;
    }
    double const time = after.at(RockingField::index, 0) * shaking_.time_step_s + after.at(RockingField::tau, 0);
    double const rebound = after.at(RockingField::side, 0) * after.at(RockingField::omega, 0);
    log_.show({time, 0, rebound / corner_.restitution, 0, 0, x_m_, v_mps_});
    log_.show({time, 0, rebound, 0, 0, x_m_, v_mps_});
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::show_lane_step(RockingFields<1> const& before,
                                                                      LaneStep const& series) {
    if (!log_.observed()) {
        return;
    }
    auto const index = static_cast<std::size_t>(before.at(RockingField::index, 0));
    double const side = before.at(RockingField::side, 0);
    Sample<Vertical> sample;
    sample.load(shaking_, block_.gravity_mps2, index);
    sample.tau_s = before.at(RockingField::tau, 0);
    auto const f = sample.forcing(side);
    double const s = series.sine[0];
    double const c = series.cosine[0];
    double const omega = before.at(RockingField::omega, 0);
    double const grip = -corner_.inertia_ratio * (f.vertical * s + f.horizontal * c);
    double const spin = corner_.r * omega * omega;
    auto const [friction, normal] = turned(c * grip + s * spin + f.horizontal, s * grip - c * spin + f.vertical, side);
    log_.show(
        {sample.now(), side * before.at(RockingField::phi, 0), side * omega, side * friction, normal, x_m_, v_mps_});
}

}  // namespace overturn::rocking
