/// The same rocking block by other people's means: Boost.odeint's Dormand-Prince pair and the classical RK4, both
/// stopping at every sample of the wave, with impacts located on the step. For side-by-side timings only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/numeric/odeint.hpp>

#include "rocking/planar_rocking.hpp"

namespace overturn::peers {

struct Answer {
    bool overturned = false;
    double peak_rad = 0;
};
using State = std::array<double, 2>;  // phi >= 0 and its rate, mirrored to the corner in contact

/// phi'' = -p^2 (sin(alpha - phi) + A cos(alpha - phi)); A over g, mirrored, linear within the sample.
struct Block {
    double alpha, p, a0, slope;
    void operator()(State const& x, State& rate, double t) const {
        rate[0] = x[1];
        double const psi = alpha - x[0];
        rate[1] = -p * p * (std::sin(psi) + (a0 + slope * t) * std::cos(psi));
    }
};

// Dormand-Prince 5(4) with dense output; roots on the dense output by regula falsi with bisection's safety.
class Dopri5 {
  public:
    // From t on by one step that ends at `end` at the latest. The dense output then covers [from(), to()].
    void step(Block const& f, State const& x, double t, double end) {
        stepper_.initialize(x, t, end - t);
        stepper_.do_step(std::cref(f));
    }
    [[nodiscard]] double to() const { return stepper_.current_time(); }
    [[nodiscard]] State at(double t) const {
        State x;
        stepper_.calc_state(t, x);
        return x;
    }

  private:
    static constexpr double tolerance = 1e-10;
    decltype(boost::numeric::odeint::make_dense_output(tolerance, tolerance,
                                                       boost::numeric::odeint::runge_kutta_dopri5<State>())) stepper_ =
        boost::numeric::odeint::make_dense_output(tolerance, tolerance,
                                                  boost::numeric::odeint::runge_kutta_dopri5<State>());
};

// One classical Runge-Kutta step to wherever it is asked for.
class Rk4 {
  public:
    void step(Block const& f, State const& x, double t, double end) {
        f_ = f;
        x_ = x;
        t_ = t;
        to_ = end;
    }
    [[nodiscard]] double to() const { return to_; }
    [[nodiscard]] State at(double t) const {
        double const h = t - t_;
        State k1, k2, k3, k4;
        f_(x_, k1, t_);
        f_({x_[0] + h / 2 * k1[0], x_[1] + h / 2 * k1[1]}, k2, t_ + h / 2);
        f_({x_[0] + h / 2 * k2[0], x_[1] + h / 2 * k2[1]}, k3, t_ + h / 2);
        f_({x_[0] + h * k3[0], x_[1] + h * k3[1]}, k4, t_ + h);
        return {x_[0] + h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0]),
                x_[1] + h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])};
    }

  private:
    Block f_{};
    State x_{};
    double t_ = 0, to_ = 0;
};

/// Where component `c` of the step's solution passes zero between `lo` and `hi`.
template <class Method> double root(Method const& method, std::size_t c, double lo, double hi) {
    double left = method.at(lo)[c];
    for (int i = 0; i < 60 && hi - lo > 1e-15; ++i) {
        double const middle = 0.5 * (lo + hi);
        double const value = method.at(middle)[c];
        if ((value > 0) == (left > 0)) {
            lo = middle;
            left = value;
        } else {
            hi = middle;
        }
    }
    return hi;
}

template <class Method>
Answer rock(RockingBlock const& block, std::vector<double> const& wave, double dt, double scale) {
    Answer answer;
    Method method;
    double const k = scale / block.gravity_mps2;
    double const tip = std::tan(block.alpha_rad);
    constexpr double slow = 1e-5;  // rad/s: rest after an impact
    bool rests = true;
    double side = 1;
    State x{0, 0};
    for (std::size_t i = 0; i + 1 < wave.size(); ++i) {
        double const a0 = k * wave[i];
        double const a1 = k * wave[i + 1];
        double t = 0;
        if (rests) {
            if (std::abs(a1) <= tip) {
                continue;
            }
            side = a1 > 0 ? -1 : 1;
            t = dt * std::max(0.0, (tip - std::abs(a0)) / (std::abs(a1) - std::abs(a0)));
            rests = false;
            x = {0, 0};
        }
        while (t < dt && !rests) {
            Block const f{block.alpha_rad, block.p_radps, side * a0, side * (a1 - a0) / dt};
            method.step(f, x, t, dt);
            double to = method.to();
            State y = method.at(to);
            bool const strikes = y[0] < 0;
            if (strikes) {
                double lo = t;
                if (x[0] <= 0 && x[1] > 0) {
                    lo = t + 1e-9 * (to - t);
                }
                to = root(method, 0, lo, to);
                y = method.at(to);
            }
            if (x[1] > 0 && y[1] <= 0) {
                answer.peak_rad = std::max(answer.peak_rad, method.at(root(method, 1, t, to))[0]);
            }
            answer.peak_rad = std::max(answer.peak_rad, y[0]);
            if (y[0] >= 0.5 * std::numbers::pi) {
                answer.overturned = true;
                return answer;
            }
            t = std::max(to, std::nextafter(t, dt));
            x = y;
            if (strikes) {
                side = -side;
                x = {0, block.restitution * std::abs(y[1])};
                rests = x[1] < slow && std::abs(a0 + (a1 - a0) / dt * t) <= tip;
            }
        }
    }
    return answer;
}

}  // namespace overturn::peers
