/// Taylor series of rocking about a corner that slips under Coulomb friction, in mirrored coordinates.
#pragma once

#include "rocking/detail/contact_series.hpp"

namespace overturn::rocking {

/// What the slip adds to a step: the normal force over m g and the corner's acceleration over g, mirrored like phi.
template <int Order> struct SlipSeries {
    std::array<double, Order - 1> normal{};
    std::array<double, Order - 1> acceleration{};
};

/// phi'' = -B (Gv - r cos psi phi'^2) / [r (kappa + sin psi B)], B = sin psi - mu sigma cos psi, r = R/g,
/// kappa = I_G / (m R^2); x''/g = -mu sigma N - A - r (cos psi phi'' + sin psi phi'^2).
/// \param drag mu_k times the sign of the slip, mirrored
/// \param from_rest phi'' >= 0 by the step's own start, whatever rounding says
template <int Order>
[[nodiscard]] SlipSeries<Order> expand_slipping(Series<Order>& s, double alpha, double r, double kappa, double drag,
                                                double phi, double omega, Forcing const& forcing, bool from_rest) {
    s.phi[0] = phi;
    s.phi[1] = omega;
    s.sine[0] = std::sin(alpha - phi);
    s.cosine[0] = std::cos(alpha - phi);
    std::array<double, Order> velocity{};
    std::array<double, Order - 1> spin{};
    std::array<double, Order - 1> arm{};       // B
    std::array<double, Order - 1> weight{};    // Gv - r cos psi phi'^2
    std::array<double, Order - 1> inertia{};   // kappa + sin psi B
    std::array<double, Order - 1> quotient{};  // B weight / inertia
    std::array<double, Order - 1> rotation{};  // phi''
    SlipSeries<Order> slip;
    velocity[0] = omega;
    for (int k = 0; k + 2 <= Order; ++k) {
        spin[k] = product_term(velocity, velocity, k);
        arm[k] = s.sine[k] - drag * s.cosine[k];
        weight[k] = -r * product_term(s.cosine, spin, k);
        weight[k] += k == 0 ? forcing.vertical : k == 1 ? forcing.vertical_slope : 0;
        inertia[k] = product_term(s.sine, arm, k) + (k == 0 ? kappa : 0);
        double numerator = product_term(arm, weight, k);
        for (int j = 1; j <= k; ++j) {
            numerator -= inertia[j] * quotient[k - j];
        }
        quotient[k] = numerator / inertia[0];
        rotation[k] = -quotient[k] / r;
        if (k == 0 && from_rest && rotation[0] < 0) {
            rotation[0] = 0;
        }
        slip.normal[k] = r * product_term(s.sine, rotation, k) + weight[k];
        slip.acceleration[k] =
            -drag * slip.normal[k] - r * (product_term(s.cosine, rotation, k) + product_term(s.sine, spin, k));
        slip.acceleration[k] -= k == 0 ? forcing.horizontal : k == 1 ? forcing.horizontal_slope : 0;
        s.phi[k + 2] = rotation[k] / ((k + 1) * (k + 2));
        velocity[k + 1] = rotation[k] / (k + 1);
        s.sine[k + 1] = -product_term(velocity, s.cosine, k) / (k + 1);
        s.cosine[k + 1] = product_term(velocity, s.sine, k) / (k + 1);
    }
    return slip;
}

}  // namespace overturn::rocking
