/// Taylor series of rocking about a corner that does not slip, and of what the ground must give for that.
#pragma once

#include "rocking/detail/power_series.hpp"

namespace overturn::rocking {

/// phi'' = -p^2 pull, psi' = -phi'.
/// \param from_rest the step starts with the uplift itself, where phi'' is zero to rounding and must not be negative
template <class Order>
[[nodiscard]] RotationSeries<Order> stick_series(Order order, Restoring restoring, double alpha, double p, double phi,
                                                 double omega, Forcing const& forcing, bool from_rest) {
    RotationSeries<Order> s(order);
    bool const linear = restoring == Restoring::linear;
    s.phi[0] = phi;
    s.phi[1] = omega;
    s.sine[0] = linear ? alpha - phi : std::sin(alpha - phi);
    s.cosine[0] = linear ? 1 : std::cos(alpha - phi);
    double const square = p * p;
    for (int k = 0; k + 2 <= order; ++k) {
        double const back = pull(forcing.vertical, forcing.horizontal, term_of(s.sine, k), term_of(s.cosine, k));
        s.phi[k + 2] = -square * back / ((k + 1) * (k + 2));
        if (k == 0 && from_rest && s.phi[2] < 0) {
            s.phi[2] = 0;
        }
        if (linear) {
            s.sine[k + 1] = -s.phi[k + 1];
            s.cosine[k + 1] = 0;
            continue;
        }
        double sine = 0;
        double cosine = 0;
        for (int j = 0; j <= k; ++j) {
            double const rate = (j + 1) * s.phi[j + 1];
            sine -= rate * s.cosine[k - j];
            cosine += rate * s.sine[k - j];
        }
        s.sine[k + 1] = sine / (k + 1);
        s.cosine[k + 1] = cosine / (k + 1);
    }
    return s;
}

/// Contact forces over m g along the step.
template <class Order>
[[nodiscard]] ContactForces<PowerSeries<Order>> contact_series(RotationSeries<Order> const& s, Forcing const& forcing,
                                                               double r) {
    auto const velocity = s.velocity();
    PowerSeries<Order> const rate(s.order, velocity);
    PowerSeries<Order> const acceleration(s.order, derivative(velocity));
    return contact_forces(PowerSeries<Order>(s.order, s.sine), PowerSeries<Order>(s.order, s.cosine), acceleration,
                          rate * rate, r, forcing.horizontal, forcing.vertical);
}

}  // namespace overturn::rocking
