/// Steps on one corner, stuck or slipping. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// The rest of the sample, or less where substeps or the last series term ask for it.
template <int Order, class Restoring, bool Vertical, Slip Friction>
double Integrator<Order, Restoring, Vertical, Friction>::step_length(Series<Order> const& series) {
    double const left = sample_.left();
    double h = accuracy_.substeps > 1 ? std::min(left, sample_.length_s / accuracy_.substeps * (1 + 1e-12)) : left;
    double power = 1;
    for (int k = 0; k < Order; ++k) {
        power *= h;
    }
    // The last but one term guards against a last one that vanishes by accident.
    double const size =
        power * std::max(std::abs(series.phi[Order]), std::abs(series.phi[Order - 1]) * corner_.p_radps);
    if (double const allowed = accuracy_.step_tolerance * corner_.alpha_rad; size > allowed) {
        h *= 0.9 * std::pow(allowed / size, 1.0 / Order);
    }
    constexpr double min_step_share = 1e-12;  // of the sample: shorter steps end no trial
    if (!(h > sample_.length_s * min_step_share) && left > sample_.length_s * min_step_share) {
        log_.fail(FailureReason::no_convergence);
    }
    return h;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::rock() {
    Series<Order> series;
    auto const forcing = sample_.forcing(side_);
    expand<Order, Restoring, Vertical>(series, corner_.alpha_rad, corner_.p_radps, phi_, omega_, forcing,
                                       start_root_ == StartRoot::twofold);
    ++log_.outcome().steps;
    auto const forces = contact_now(series, forcing);
    if (slips_at_once(forces)) {
        start_slip(forces.friction);
        return;
    }
    if (start_root_ == StartRoot::twofold) {
        log_.uplifted(sample_.now());
    }
    log_.watch_forces(forces.friction, forces.normal);
    show(side_ * forces.friction, forces.normal);
    double const h = step_length(series);
    if (log_.done()) {
        return;
    }
    Ending ending{h, Event::none};
    if constexpr (nonlinear) {
        ending = limits_of_contact(series, forcing, forces, h);
    }
    double const impact = first_fall_through_zero(series.phi, ending.at, start_root_);
    if (impact >= 0) {
        ending = {impact, Event::impact};
    }
    find_overturning(series, ending);
    raise_energy_inside(series, forcing, ending.at);
    if constexpr (slipping) {
        log_.outcome().energy.input +=
            block_.gravity_mps2 * corner_.radius_m * shaking_work(series, forcing, ending.at);
    }
    move(series, ending);
    switch (ending.event) {
        case Event::impact:
            if constexpr (nonlinear) {
                watch_landing();
            }
            apply_impact();
            break;
        case Event::overturned:
            log_.overturn(sample_.now());
            break;
        case Event::contact_lost:
            lose_contact(false);
            break;
        case Event::slip_starts:
            start_slip(ending.friction);
            break;
        default:
            break;
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::slip_rock() {
    if constexpr (slipping) {
        Series<Order> series;
        auto const forcing = forcing_of_ground(side_);
        auto const shaking = shaking_of(forcing, side_);
        double const g = block_.gravity_mps2;
        double const forwards = side_ * sigma_;
        auto slip = expand_slipping(series, corner_.base_angle_rad, corner_.r, corner_.law.kappa,
                                    block_.friction_kinetic * forwards, phi_, omega_, forcing,
                                    start_root_ == StartRoot::twofold);
        ++log_.outcome().steps;
        if (start_root_ == StartRoot::twofold) {
            log_.uplifted(sample_.now());
        }
        if (v_mps_ == 0 && forwards * slip.acceleration[0] < 0) {
            slip.acceleration[0] = 0;  // slip starts where this is zero or drives it, whatever rounding says
        }
        log_.lower_contact(slip.normal[0]);
        show(-block_.friction_kinetic * sigma_ * slip.normal[0], slip.normal[0]);
        double const h = step_length(series);
        if (log_.done()) {
            return;
        }
        // Speed along the slip, and its integral.
        std::array<double, Order> speed{};
        speed[0] = sigma_ * v_mps_;
        for (int k = 1; k < Order; ++k) {
            speed[k] = forwards * g * slip.acceleration[k - 1] / k;
        }
        Ending ending{h, Event::none};
        ending.earlier(slip.normal[0] > 0 ? first_fall_through_zero(slip.normal, h, StartRoot::none) : 0.0,
                       Event::contact_lost);
        ending.earlier(first_fall_through_zero(speed, ending.at, v_mps_ == 0 ? StartRoot::simple : StartRoot::none),
                       Event::slip_stops);
        ending.earlier(first_fall_through_zero(series.phi, ending.at, start_root_), Event::impact);
        find_overturning(series, ending);
        auto& energy = log_.outcome().energy;
        std::array<double, Order> push{forwards * shaking.horizontal, forwards * shaking.horizontal_slope};
        std::array<double, Order> normal{};
        std::copy(slip.normal.begin(), slip.normal.end(), normal.begin());
        energy.input += g * corner_.radius_m * shaking_work(series, shaking, ending.at)
                        - g * product_integral(speed, push, ending.at);
        energy.friction_work += g * block_.friction_kinetic * product_integral(speed, normal, ending.at);
        log_.raise_energy(rocking_energy());
        x_m_ += sigma_ * integral(speed, ending.at);
        v_mps_ = ending.event == Event::slip_stops ? 0 : sigma_ * evaluate(speed, ending.at);
        log_.raise_slip(x_m_);
        log_.lower_contact(evaluate(slip.normal, ending.at));
        move(series, ending);
        switch (ending.event) {
            case Event::impact:
                apply_impact();
                break;
            case Event::overturned:
                log_.overturn(sample_.now());
                break;
            case Event::slip_stops:
                mode_ = Mode::rock;
                break;  // whether it sticks is seen at once
            case Event::contact_lost:
                lose_contact(false);
                break;
            default:
                break;
        }
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
auto Integrator<Order, Restoring, Vertical, Friction>::contact_now(Series<Order> const& series,
                                                                   Forcing const& forcing) const -> ContactForces {
    double const acceleration = 2 * series.phi[2];
    double const spin = omega_ * omega_;
    return turned(corner_.r * (series.cosine[0] * acceleration + series.sine[0] * spin) + forcing.horizontal,
                  corner_.r * (series.sine[0] * acceleration - series.cosine[0] * spin) + forcing.vertical, side_);
}

// Just before an impact the corner carries least: the block turns fastest.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::watch_landing() {
    double const a = side_ * sample_.horizontal(sample_.tau_s);
    double const gv = sample_.vertical(sample_.tau_s);
    double const s = corner_.sine_alpha;
    double const c = corner_.cosine_alpha;
    double const spin = corner_.r * omega_ * omega_;
    double const grip = corner_.inertia_ratio * (gv * s + a * c);
    auto const [friction, normal] = turned(s * spin + a - c * grip, gv - s * grip - c * spin, side_);
    log_.watch_forces(friction, normal);
}

// Where within the step friction or contact would give out. The forces' series are worked out only near a limit. What
// they could change within the step is bounded from their derivatives, as r p^2 = inertia_ratio < 1:
// |F'|, |N'| <= 2 (|A'| + |Gv'|) + |phi'| [4 (|A| + |Gv|) + r phi'^2].
template <int Order, class Restoring, bool Vertical, Slip Friction>
auto Integrator<Order, Restoring, Vertical, Friction>::limits_of_contact(Series<Order> const& series,
                                                                         Forcing const& forcing,
                                                                         ContactForces const& forces, double h) const
    -> Ending {
    Ending ending{h, Event::none};
    auto const& [friction, normal] = forces;
    double const slopes = std::abs(forcing.horizontal_slope) + std::abs(forcing.vertical_slope);
    double const pull = std::abs(forcing.horizontal) + std::abs(forcing.vertical) + h * slopes;
    double const rate = std::abs(omega_) + h * corner_.p_radps * corner_.p_radps * pull;
    double const change = incline_.spread() * h * (2 * slopes + rate * (4 * pull + corner_.r * rate * rate));
    bool const contact_near = normal - change <= 0;
    bool const slip_near = limited && std::abs(friction) + change >= hold_friction_ * (normal - change);
    if (!contact_near && !slip_near) {
        return ending;
    }
    auto contact = contact_series(series, forcing, corner_.r);
    incline_.turn<Order>(contact, side_);
    if (normal <= 0) {
        return {0, Event::contact_lost};
    }
    ending.earlier(first_fall_through_zero(contact.normal, h, StartRoot::none), Event::contact_lost);
    if constexpr (limited) {
        for (double const sign : {1.0, -1.0}) {
            auto spare = contact.normal;
            for (std::size_t k = 0; k < spare.size(); ++k) {
                spare[k] = hold_friction_ * spare[k] - sign * contact.friction[k];
            }
            ending.earlier(first_fall_through_zero(spare, ending.at, StartRoot::none), Event::slip_starts, sign);
        }
    }
    return ending;
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::find_overturning(Series<Order> const& series,
                                                                        Ending& ending) const {
    auto beyond = series.phi;
    beyond[0] -= 0.5 * pi;
    if (ending.event != Event::impact && evaluate(beyond, ending.at) >= 0) {
        auto const roots = roots_in(beyond, 0.0, ending.at);
        ending = {roots.count > 0 ? roots.at[0] : ending.at, Event::overturned};
    }
}

// Advances the rotation to the ending, peaks included, and looks at the energy there.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::move(Series<Order> const& series, Ending const& ending) {
    double const now = sample_.now();
    if (phi_ + tail_bound(series.phi, 1, ending.at) > log_.peak()) {
        for_each_maximum(series.phi, ending.at, [&](double t) { log_.raise_peak(evaluate(series.phi, t), now + t); });
    }
    phi_ = ending.event == Event::impact ? 0 : evaluate(series.phi, ending.at);
    omega_ = evaluate(derivative(series.phi), ending.at);
    sample_.advance(ending.at, ending.event != Event::none);
    start_root_ = ending.at > 0 ? StartRoot::none : start_root_;
    log_.raise_peak(phi_, sample_.now());
    log_.raise_energy(rocking_energy());
}

// The ground cannot give the friction that no slip needs (mirrored, over m g): the corner slips against it.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::start_slip(double friction) {
    if constexpr (!slipping) {
        log_.end_at_slip();
    } else {
        sigma_ = -side_ * std::copysign(1.0, friction);
        v_mps_ = 0;
        slipped_ = true;
        log_.raise_demand(block_.friction_static);
        // A base that has not left the ground yet and is too smooth to be tipped slides flat.
        bool const flat = start_root_ == StartRoot::twofold && block_.friction_kinetic <= corner_.base_ratio;
        mode_ = flat ? Mode::slide : Mode::slip_rock;
    }
}

// N <= 0. On the way out beyond the critical angle the fall is certain, and without contact no torque acts: the block
// turns on as it is. Elsewhere the model ends here.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::lose_contact(bool at_rest) {
    double const now = sample_.now();
    log_.outcome().contact_lost_s = now;
    log_.lower_contact(0);
    if (!at_rest && phi_ >= corner_.alpha_rad && omega_ > 0) {
        log_.overturn(now + (0.5 * pi - phi_) / omega_);
    } else {
        log_.end(Verdict::contact_lost);
    }
}

// Energy is stationary inside a step where the block turns and where the shaking lets go of it: its power is
// -omega (A cos psi + (Gv - 1) sin psi).
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::raise_energy_inside(Series<Order> const& series,
                                                                           Forcing const& forcing, double end) {
    log_.raise_energy(rocking_energy());
    auto const velocity = derivative(series.phi);
    auto const shove = [&](double t) {
        return (forcing.horizontal + forcing.horizontal_slope * t) * evaluate(series.cosine, t)
               + (forcing.vertical + forcing.vertical_slope * t - 1) * evaluate(series.sine, t);
    };
    auto const energy = [&](double t) {
        double const speed = evaluate(velocity, t) / corner_.p_radps;
        return 0.5 * speed * speed + Restoring::potential(corner_.alpha_rad, evaluate(series.phi, t));
    };
    auto const turns = roots_in(velocity, 0.0, end);
    for (std::size_t i = 0; i < turns.count; ++i) {
        log_.raise_energy(energy(turns.at[i]));
    }
    double const here = shove(0);
    double const there = shove(end);
    if (here * there < 0) {
        double const yield = (here - there) / end;
        double const near = here / yield;  // the shove is almost a line
        log_.raise_energy(energy(std::clamp(near + shove(near) / yield, 0.0, end)));
    }
}

}  // namespace overturn::rocking
