/// The time loop of planar rocking: steps, events and resets. Included by planar_rocking.cpp only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rocking/planar_rocking.hpp"
#include "rocking/rocking_events.hpp"
#include "rocking/rocking_series.hpp"

namespace overturn::rocking {

template <int Order, class Restoring, bool Vertical> class Integrator {
  public:
    Integrator(RockingBlock const& block, Shaking const& shaking, RockingAccuracy const& accuracy,
               RockingObserver* observer)
        : block_(block),
          shaking_(shaking),
          accuracy_(accuracy),
          observer_(observer),
          uplift_ratio_(Restoring::uplift_ratio(block.alpha_rad)),
          top_(Restoring::top(block.alpha_rad)) {}

    RockingOutcome run(RockingStart const& start) {
        begin(start);
        std::size_t const n = shaking_.horizontal_mps2.size();
        for (std::size_t i = 0; i + 1 < n && !done_; ++i) {
            if (resting_ && observer_ == nullptr) {
                i = skip_rest(i);
                if (i + 1 >= n) {
                    break;
                }
            }
            load(i);
            advance_sample();
        }
        if (!done_ && !resting_) {
            run_out(static_cast<double>(n == 0 ? 0 : n - 1) * shaking_.time_step_s);
        }
        finish();
        return out_;
    }

  private:
    RockingBlock block_;
    Shaking shaking_;
    RockingAccuracy accuracy_;
    RockingObserver* observer_;
    double uplift_ratio_;
    double top_;
    RockingOutcome out_;

    // The state: at rest, or on corner `side_` with phi_ >= 0 and, where phi_ is zero, a reason why it grows.
    bool resting_ = true;
    bool done_ = false;
    double side_ = 1;
    double phi_ = 0;
    double omega_ = 0;
    StartRoot start_root_ = StartRoot::none;

    // The sample: forcing at its start in units of g, slopes, and where in it we are.
    double sample_start_s_ = 0;
    double length_s_ = 0;
    double tau_s_ = 0;
    double a0_ = 0, a_slope_ = 0;
    double g0_ = 1, g_slope_ = 0;

    [[nodiscard]] double now() const { return sample_start_s_ + tau_s_; }
    [[nodiscard]] double horizontal(double tau) const { return a0_ + a_slope_ * tau; }
    [[nodiscard]] double vertical(double tau) const {
        if constexpr (Vertical) {
            return g0_ + g_slope_ * tau;
        }
        return 1.0;
    }

    void begin(RockingStart const& start) {
        if (start.rotation_rad == 0 && start.velocity_radps == 0) {
            return;
        }
        side_ = (start.rotation_rad != 0 ? start.rotation_rad : start.velocity_radps) < 0 ? -1.0 : 1.0;
        phi_ = side_ * start.rotation_rad;
        omega_ = side_ * start.velocity_radps;
        start_root_ = phi_ == 0 ? StartRoot::simple : StartRoot::none;
        resting_ = false;
        out_.first_uplift_s = 0;
        raise_peak(phi_, 0);
        if (phi_ >= 0.5 * pi) {
            overturn(0);
        }
    }

    void load(std::size_t i) {
        double const dt = shaking_.time_step_s;
        double const k = shaking_.scale / block_.gravity_mps2;
        sample_start_s_ = static_cast<double>(i) * dt;
        length_s_ = dt;
        tau_s_ = 0;
        a0_ = k * shaking_.horizontal_mps2[i];
        a_slope_ = (k * shaking_.horizontal_mps2[i + 1] - a0_) / dt;
        if constexpr (Vertical) {
            g0_ = 1 + k * shaking_.vertical_mps2[i];
            g_slope_ = (1 + k * shaking_.vertical_mps2[i + 1] - g0_) / dt;
        }
    }

    // The first sample from i on at whose end the block could lift: most of most waves is passed here.
    std::size_t skip_rest(std::size_t i) {
        std::size_t const last = shaking_.horizontal_mps2.size() - 1;
        double const k = shaking_.scale / block_.gravity_mps2;
        double most = 0;
        double least = 1;
        for (; i < last; ++i) {
            double const a = std::abs(k * shaking_.horizontal_mps2[i + 1]);
            double gv = 1;
            if constexpr (Vertical) {
                gv = 1 + k * shaking_.vertical_mps2[i + 1];
            }
            if (a > gv * uplift_ratio_) {
                break;
            }
            if constexpr (Vertical) {
                if (!(gv > 0)) {
                    break;
                }
                most = std::max(most, a / gv);
                least = std::min(least, gv);
            } else {
                most = std::max(most, a);
            }
        }
        out_.friction_demand = std::max(out_.friction_demand, most);
        out_.min_contact_force_ratio = std::min(out_.min_contact_force_ratio, least);
        return i;
    }

    void advance_sample() {
        while (!done_ && tau_s_ < length_s_) {
            if (resting_) {
                look_for_uplift();
            } else {
                step();
            }
        }
    }

    // At rest |a| <= gv tan(alpha); both sides are linear in time, so the instant of uplift is exact.
    void look_for_uplift() {
        watch_rest(tau_s_);
        double const a = horizontal(tau_s_);
        double const hold = vertical(tau_s_) * uplift_ratio_;
        if (std::abs(a) > hold) {
            lift(tau_s_, a);
            return;
        }
        double const a_end = horizontal(length_s_);
        double const hold_end = vertical(length_s_) * uplift_ratio_;
        if (std::abs(a_end) <= hold_end) {
            tau_s_ = length_s_;
            watch_rest(tau_s_);
            return;
        }
        double const sign = a_end < 0 ? -1.0 : 1.0;
        double const below = hold - sign * a;
        double const above = sign * a_end - hold_end;
        lift(tau_s_ + (length_s_ - tau_s_) * (below / (below + above)), a_end);
    }

    void lift(double tau, double acceleration) {
        tau_s_ = std::min(tau, length_s_);
        resting_ = false;
        side_ = acceleration > 0 ? -1.0 : 1.0;
        phi_ = 0;
        omega_ = 0;
        start_root_ = StartRoot::twofold;
        if (out_.first_uplift_s < 0) {
            out_.first_uplift_s = now();
        }
    }

    void step() {
        Series<Order> series;
        Forcing const forcing{side_ * horizontal(tau_s_), side_ * a_slope_, vertical(tau_s_), g_slope_};
        expand<Order, Restoring, Vertical>(series, block_.alpha_rad, block_.p_radps, phi_, omega_, forcing,
                                           start_root_ == StartRoot::twofold);
        ++out_.steps;
        double const h = step_length(series);
        if (done_) {
            return;
        }
        watch(forcing, series.phi[2] * 2, series.sine[0], series.cosine[0]);
        double const impact = first_fall_through_zero(series.phi, h, start_root_);
        double const end = impact >= 0 ? impact : h;
        for_each_maximum(series.phi, end, [&](double t) { raise_peak(evaluate(series.phi, t), now() + t); });
        raise_energy_inside(series, forcing, end);
        double const phi_end = impact >= 0 ? 0 : evaluate(series.phi, end);
        if (phi_end >= 0.5 * pi) {
            auto beyond = series.phi;
            beyond[0] -= 0.5 * pi;
            auto const roots = roots_in(beyond, 0.0, end);
            overturn(now() + (roots.count > 0 ? roots.at[0] : end));
            return;
        }
        phi_ = phi_end;
        omega_ = evaluate(derivative(series.phi), end);
        // A step that ends at the sample's end ends exactly there.
        tau_s_ = impact < 0 && tau_s_ + h >= length_s_ ? length_s_ : tau_s_ + end;
        start_root_ = StartRoot::none;
        if (impact >= 0) {
            strike();
        } else {
            raise_peak(phi_, now());
        }
    }

    // The rest of the sample, or less where substeps or the last series term ask for it.
    double step_length(Series<Order> const& series) {
        double const left = length_s_ - tau_s_;
        double h = accuracy_.substeps > 1 ? std::min(left, length_s_ / accuracy_.substeps * (1 + 1e-12)) : left;
        double power = 1;
        for (int k = 0; k < Order; ++k) {
            power *= h;
        }
        // The last but one term guards against a last one that vanishes by accident.
        double const size =
            power * std::max(std::abs(series.phi[Order]), std::abs(series.phi[Order - 1]) * block_.p_radps);
        if (double const allowed = accuracy_.step_tolerance * block_.alpha_rad; size > allowed) {
            h *= 0.9 * std::pow(allowed / size, 1.0 / Order);
        }
        if (!(h > length_s_ * 1e-12) && left > length_s_ * 1e-12) {
            fail();
        }
        return h;
    }

    // Base impact. Reset: phi = 0, omega -> e omega on the other corner.
    void strike() {
        ++out_.impacts;
        double const speed = std::max(0.0, -omega_);
        double const energy = 0.5 * speed * speed / (block_.p_radps * block_.p_radps);
        raise_energy(energy);
        notify(0, -speed, 0, 0);
        double const e = block_.restitution;
        out_.friction_demand = std::max(out_.friction_demand, (1 - e) / ((1 + e) * uplift_ratio_));
        side_ = -side_;
        phi_ = 0;
        omega_ = e * speed;
        start_root_ = StartRoot::simple;
        notify(0, omega_, 0, 0);
        double const a = horizontal(tau_s_);
        double const hold = vertical(tau_s_) * uplift_ratio_;
        if (std::abs(a) > hold) {  // driven: it rocks on, however slow
            if (omega_ == 0) {
                lift(tau_s_, a);
            }
            return;
        }
        if (omega_ <= accuracy_.settle * block_.p_radps) {
            settle(a, hold);
        }
    }

    // Impacts accumulate at a finite time: with the forcing as it is now the swings last 2 omega / decel, each e times
    // the one before, over alternating corners. If the sum ends within this sample the block is at rest from then on.
    void settle(double a, double hold) {
        double const e = block_.restitution;
        double const scale = block_.p_radps * block_.p_radps * std::cos(block_.alpha_rad);
        double const here = scale * (hold + side_ * a);
        double const there = scale * (hold - side_ * a);
        double const duration = 2 * omega_ * (1 / here + e / there) / (1 - e * e);
        double const end = tau_s_ + duration;
        constexpr double invisible = 1e-3;  // below settle: at rest whatever the forcing does next
        if (end <= length_s_ && std::abs(horizontal(end)) <= vertical(end) * uplift_ratio_) {
            tau_s_ = end;
        } else if (omega_ > invisible * accuracy_.settle * block_.p_radps) {
            return;
        }
        resting_ = true;
        omega_ = 0;
    }

    // No shaking any more: step on only until energy decides, and until no later peak can be higher.
    void run_out(double end_s) {
        a0_ = a_slope_ = g_slope_ = 0;
        g0_ = 1;
        length_s_ = shaking_.time_step_s > 0 ? shaking_.time_step_s : 0.01 / block_.p_radps;
        double const balance_s =
            100 / block_.p_radps;  // exp(37) lifts the last bit to one; only an exact balance lasts
        for (std::int64_t i = 0; !done_ && !resting_; ++i) {
            sample_start_s_ = end_s + static_cast<double>(i) * length_s_;
            tau_s_ = 0;
            if (decided() || now() - end_s > balance_s) {
                break;
            }
            advance_sample();
        }
    }

    [[nodiscard]] bool decided() const {
        double const energy = total_energy();
        if (phi_ >= block_.alpha_rad || energy >= top_) {
            return false;
        }
        double const e = block_.restitution;
        double const turning = Restoring::turning_point(block_.alpha_rad, omega_ > 0 ? energy : e * e * energy);
        constexpr double slack = 1e-12;
        return turning <= out_.peak_rotation_rad * (1 + slack);
    }

    /// Energy above rest over m g R.
    [[nodiscard]] double total_energy() const {
        double const rate = omega_ / block_.p_radps;
        return 0.5 * rate * rate + Restoring::potential(block_.alpha_rad, phi_);
    }

    void raise_peak(double phi, double time_s) {
        if (phi > out_.peak_rotation_rad) {
            out_.peak_rotation_rad = phi;
            out_.time_of_peak_s = time_s;
        }
    }
    void raise_energy(double energy) { out_.peak_energy_ratio = std::max(out_.peak_energy_ratio, energy / top_); }

    // Energy is stationary inside a step where the shaking's power -omega (A cos psi + (Gv - 1) sin psi) changes sign.
    void raise_energy_inside(Series<Order> const& series, Forcing const& forcing, double end) {
        raise_energy(total_energy());
        double const power0 =
            -(forcing.horizontal * series.cosine[0] + (forcing.vertical - 1) * series.sine[0]) * omega_;
        if (power0 <= 0) {
            return;
        }
        auto const at = [&](double t) {
            double const phi = evaluate(series.phi, t);
            double const rate = evaluate(derivative(series.phi), t);
            double const pull = (forcing.horizontal + forcing.horizontal_slope * t) * evaluate(series.cosine, t)
                                + (forcing.vertical + forcing.vertical_slope * t - 1) * evaluate(series.sine, t);
            double const speed = rate / block_.p_radps;
            struct {
                double power, energy;
            } const both{-pull * rate, 0.5 * speed * speed + Restoring::potential(block_.alpha_rad, phi)};
            return both;
        };
        if (double const power1 = at(end).power; power1 < 0) {
            raise_energy(at(end * power0 / (power0 - power1)).energy);
        }
    }

    // Contact forces of the no-slip motion, over m g.
    void watch(Forcing const& forcing, double acceleration, double sine, double cosine) {
        double const square = block_.p_radps * block_.p_radps;
        double const spin = omega_ * omega_;
        double const friction =
            block_.inertia_ratio * (cosine * acceleration + sine * spin) / square + forcing.horizontal;
        double const normal = block_.inertia_ratio * (sine * acceleration - cosine * spin) / square + forcing.vertical;
        watch_forces(friction, normal);
        notify(phi_, omega_, side_ * friction, normal);
    }
    void watch_rest(double tau) {
        watch_forces(horizontal(tau), vertical(tau));
        if (observer_ != nullptr) {
            observer_->at({sample_start_s_ + tau, 0, 0, horizontal(tau), vertical(tau)});
        }
    }
    void watch_forces(double friction, double normal) {
        out_.min_contact_force_ratio = std::min(out_.min_contact_force_ratio, normal);
        double const demand = normal > 0 ? std::abs(friction) / normal : std::numeric_limits<double>::infinity();
        out_.friction_demand = std::max(out_.friction_demand, demand);
    }
    void notify(double phi, double omega, double friction, double normal) {
        if (observer_ != nullptr) {
            observer_->at({now(), side_ * phi, side_ * omega, friction, normal});
        }
    }

    void overturn(double time_s) {
        out_.overturn_time_s = time_s;
        raise_peak(0.5 * pi, time_s);
        out_.verdict = Verdict::overturned;
        done_ = true;
    }
    void fail() {
        out_.verdict = Verdict::failed;
        done_ = true;
    }
    void finish() {
        if (out_.verdict == Verdict::at_rest && out_.first_uplift_s >= 0) {
            out_.verdict = Verdict::rocked;
        }
        if (!std::isfinite(out_.peak_rotation_rad)) {
            out_.verdict = Verdict::failed;
        }
    }
};

}  // namespace overturn::rocking
