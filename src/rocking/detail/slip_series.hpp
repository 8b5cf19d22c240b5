/// Taylor series of rocking about a corner that slips under Coulomb friction, in mirrored coordinates.
#pragma once

#include "rocking/detail/power_series.hpp"

namespace overturn::rocking {

/// One step with slip: the rotation, the normal force over m g and the corner's acceleration over g.
template <class Order> struct SlipSeries {
    explicit SlipSeries(Order order) : rotation(order) {}

    RotationSeries<Order> rotation;
    std::array<double, Order::most - 1> normal{};
    std::array<double, Order::most - 1> acceleration{};
};

/// Equations of motion with slip, friction being -mu sigma N:
/// phi'' = -B (Gv - r cos psi phi'^2) / [r (kappa + sin psi B)], B = sin psi - mu sigma cos psi, r = R/g,
/// kappa = I_G / (m R^2); x''/g = -mu sigma N - A - r (cos psi phi'' + sin psi phi'^2).
///
/// Each term of phi'' asks for the terms before it of all the others, so products are taken term by term, not of whole
/// series (PowerSeries). The forces are those of contact_forces, but N = r sin psi phi'' + (Gv - r cos psi phi'^2) is
/// summed in the order in which phi'' needs its parts: last bits differ, and results keep these.
/// \param drag mu_k times the sign of the slip, mirrored
/// \param from_rest phi'' >= 0 by the step's own start, whatever rounding says
template <class Order>
[[nodiscard]] SlipSeries<Order> slip_series(Order order, double alpha, double r, double kappa, double drag, double phi,
                                            double omega, Forcing const& forcing, bool from_rest) {
    constexpr std::size_t most = Order::most - 1;
    SlipSeries<Order> slip(order);
    auto& s = slip.rotation;
    s.phi[0] = phi;
    s.phi[1] = omega;
    s.sine[0] = std::sin(alpha - phi);
    s.cosine[0] = std::cos(alpha - phi);
    std::array<double, Order::most> velocity{};
    std::array<double, most> spin{};
    std::array<double, most> arm{};       // B
    std::array<double, most> weight{};    // Gv - r cos psi phi'^2
    std::array<double, most> inertia{};   // kappa + sin psi B
    std::array<double, most> quotient{};  // B weight / inertia
    std::array<double, most> rotation{};  // phi''
    auto const coefficient = [](Linear<double> const& f, int k) { return k == 0 ? f.start : k == 1 ? f.slope : 0; };
    velocity[0] = omega;
    for (int k = 0; k + 2 <= order; ++k) {
        spin[k] = product_term(velocity, velocity, k);
        arm[k] = s.sine[k] - drag * s.cosine[k];
        weight[k] = -r * product_term(s.cosine, spin, k);
        weight[k] += coefficient(forcing.vertical, k);
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
        slip.acceleration[k] -= coefficient(forcing.horizontal, k);
        s.phi[k + 2] = rotation[k] / ((k + 1) * (k + 2));
        velocity[k + 1] = rotation[k] / (k + 1);
        s.sine[k + 1] = -product_term(velocity, s.cosine, k) / (k + 1);
        s.cosine[k + 1] = product_term(velocity, s.sine, k) / (k + 1);
    }
    return slip;
}

}  // namespace overturn::rocking
