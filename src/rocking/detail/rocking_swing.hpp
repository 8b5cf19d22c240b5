/// Swings: the free flight that swing_on steps, alone or beside others. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

/// Friction without a limit, as a number that may be multiplied.
inline constexpr double unlimited = 1e300;

template <int Order, class Restoring, bool Vertical, Slip Friction>
template <int Lanes>
void Integrator<Order, Restoring, Vertical, Friction>::load_lane(SwingLanes<Lanes>& lanes, int lane) const {
    auto const set = [&](Swing field, double value) { lanes.at(field, lane) = value; };
    auto const& out = log_.outcome();
    double const psi = corner_.alpha_rad - phi_;
    set(Swing::phi, phi_);
    set(Swing::omega, omega_);
    set(Swing::sine, carried_ ? sine_ : phi_ == 0 ? corner_.sine_alpha : std::sin(psi));
    set(Swing::cosine, carried_ ? cosine_ : phi_ == 0 ? corner_.cosine_alpha : std::cos(psi));
    set(Swing::side, side_);
    set(Swing::index, static_cast<double>(index_));
    set(Swing::tau, sample_.tau_s);
    set(Swing::start, start_root_ == StartRoot::simple ? 1 : 0);
    set(Swing::peak, log_.peak());
    set(Swing::peak_time, out.time_of_peak_s);
    set(Swing::energy, log_.energy());
    set(Swing::demand, out.friction_demand);
    set(Swing::normal, out.min_contact_force_ratio);
    set(Swing::steps, static_cast<double>(out.steps));
    set(Swing::impacts, static_cast<double>(out.impacts));
    set(Swing::impact_spin, out.impact_spin_radps);

    double const e = corner_.restitution;
    double const p = corner_.p_radps;
    set(Swing::p, p);
    set(Swing::inverse_p, 1 / p);
    set(Swing::r, corner_.r);
    set(Swing::inertia_ratio, corner_.inertia_ratio);
    set(Swing::restitution, e);
    set(Swing::sine_alpha, corner_.sine_alpha);
    set(Swing::cosine_alpha, corner_.cosine_alpha);
    set(Swing::uplift_ratio, corner_.uplift_ratio);
    set(Swing::friction_limit, limited ? std::min(unlimited, block_.friction_static) : unlimited);
    // An impact over a corner unlike this one needs care: it changes what is set here.
    set(Swing::impact_demand, lopsided_ ? std::numeric_limits<double>::infinity() : impact_demand());
    set(Swing::incline_sine, side_ * incline_.sine);
    set(Swing::incline_cosine, incline_.cosine);
    set(Swing::settle_speed, accuracy_.settle * p);
    // Bounces last 2 omega / deceleration, each e times the one before; the weaker side sets the longest.
    set(Swing::settle_rate, 2 / ((1 - e) * p * p * corner_.cosine_alpha));
    set(Swing::tolerance, accuracy_.step_tolerance * corner_.alpha_rad);
    set(Swing::scale, shaking_.scale / block_.gravity_mps2);
    set(Swing::time_step, shaking_.time_step_s);
    set(Swing::sampling_rate, 1 / shaking_.time_step_s);
    set(Swing::last, static_cast<double>(shaking_.horizontal_mps2.size() - 1));
    lanes.at(SwingWave::horizontal, lane) = shaking_.horizontal_mps2.data();
    lanes.at(SwingWave::vertical, lane) = Vertical ? shaking_.vertical_mps2.data() : nullptr;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
template <int Lanes>
void Integrator<Order, Restoring, Vertical, Friction>::store_lane(SwingLanes<Lanes> const& lanes, int lane) {
    auto const get = [&](Swing field) { return lanes.at(field, lane); };
    auto& out = log_.outcome();
    phi_ = get(Swing::phi);
    omega_ = get(Swing::omega);
    sine_ = get(Swing::sine);
    cosine_ = get(Swing::cosine);
    carried_ = true;
    side_ = get(Swing::side);
    index_ = static_cast<std::size_t>(get(Swing::index));
    start_root_ = get(Swing::start) > 0 ? StartRoot::simple : StartRoot::none;
    if (get(Swing::peak) > log_.peak()) {
        log_.raise_peak(get(Swing::peak), get(Swing::peak_time));
    }
    if (get(Swing::energy) > log_.energy()) {  // what comes back as it went in may not be raised by rounding
        log_.raise_energy(get(Swing::energy));
    }
    out.friction_demand = get(Swing::demand);
    out.min_contact_force_ratio = get(Swing::normal);
    out.steps = static_cast<std::int64_t>(get(Swing::steps));
    out.impacts = static_cast<std::int64_t>(get(Swing::impacts));
    out.impact_spin_radps = get(Swing::impact_spin);
    careful_ = true;
    if (index_ + 1 < shaking_.horizontal_mps2.size()) {
        sample_.load(shaking_, block_.gravity_mps2, index_);
        sample_.tau_s = get(Swing::tau);
        careful_ = sample_.tau_s < sample_.length_s;
    } else {
        sample_.tau_s = sample_.length_s;  // the wave is over
        index_ -= 1;
        careful_ = false;
    }
    steps_here_ = 0;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::swing() {
    if constexpr (swings) {
        if (slipping || log_.observed()) {
            swing_shown();
            return;
        }
        SwingLanes<1> lane;
        load_lane(lane, 0);
        swing_on(lane, Vertical);
        store_lane(lane, 0);
    }
}

// Near the limit of friction swing_on wants care. If nothing slips after all, its step is the one to take: so that a
// limit which is never reached changes no bit.
template <int Order, class Restoring, bool Vertical, Slip Friction>
bool Integrator<Order, Restoring, Vertical, Friction>::swing_unslipped() {
    if constexpr (swings && limited) {
        SwingLanes<1> lane;
        load_lane(lane, 0);
        auto const before = lane;
        lane.at(Swing::friction_limit, 0) = unlimited;
        SwingSeries taken;
        (void)swing_once(lane, Vertical, taken);
        bool const struck = lane.at(Swing::impacts, 0) != before.at(Swing::impacts, 0);
        if (lane.at(Swing::steps, 0) == before.at(Swing::steps, 0)
            || (struck && !(lane.at(Swing::impact_demand, 0) <= block_.friction_static))) {
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
        careful_ = false;
        return true;
    }
    return false;
}

// Step by step, where the steps themselves are asked for.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::swing_shown() {
    SwingLanes<1> lane;
    load_lane(lane, 0);
    SwingSeries series;
    for (bool on = true; on;) {
        auto const before = lane;
        on = swing_once(lane, Vertical, series);
        if (lane.at(Swing::steps, 0) == before.at(Swing::steps, 0)) {
            continue;
        }
        account_for(before, lane, series);
    }
    store_lane(lane, 0);
}

// What a step means to an observer and to the balance of energy.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::account_for(SwingLanes<1> const& before,
                                                                   SwingLanes<1> const& after,
                                                                   SwingSeries const& series) {
    bool const struck = after.at(Swing::impacts, 0) != before.at(Swing::impacts, 0);
    show_swing(before, series);
    if (struck) {
        show_impact(after);
    }
    if constexpr (slipping) {
        auto& energy = log_.outcome().energy;
        energy.input += block_.gravity_mps2 * corner_.radius_m * shaking_work(series);
        if (struck) {
            double const rebound = corner_.radius_m * after.at(Swing::omega, 0);
            double const e = corner_.restitution;
            energy.impact_loss += 0.5 / corner_.inertia_ratio * rebound * rebound * (1 / (e * e) - 1);
        }
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::show_impact(SwingLanes<1> const& after) {
    if (!log_.observed()) {
        return;
    }
    double const time = after.at(Swing::index, 0) * shaking_.time_step_s + after.at(Swing::tau, 0);
    double const rebound = after.at(Swing::side, 0) * after.at(Swing::omega, 0);
    log_.show({time, 0, rebound / corner_.restitution, 0, 0, x_m_, v_mps_});
    log_.show({time, 0, rebound, 0, 0, x_m_, v_mps_});
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::show_swing(SwingLanes<1> const& before,
                                                                  SwingSeries const& series) {
    if (!log_.observed()) {
        return;
    }
    auto const index = static_cast<std::size_t>(before.at(Swing::index, 0));
    double const side = before.at(Swing::side, 0);
    Sample<Vertical> sample;
    sample.load(shaking_, block_.gravity_mps2, index);
    sample.tau_s = before.at(Swing::tau, 0);
    auto const f = sample.forcing(side);
    double const s = series.sine[0];
    double const c = series.cosine[0];
    double const omega = before.at(Swing::omega, 0);
    double const grip = -corner_.inertia_ratio * (f.vertical * s + f.horizontal * c);
    double const spin = corner_.r * omega * omega;
    auto const [friction, normal] = turned(c * grip + s * spin + f.horizontal, s * grip - c * spin + f.vertical, side);
    log_.show({sample.now(), side * before.at(Swing::phi, 0), side * omega, side * friction, normal, x_m_, v_mps_});
}

}  // namespace overturn::rocking
