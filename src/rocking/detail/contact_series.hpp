/// What the ground must provide while the corner does not slip, as power series over one step.
#pragma once

#include "rocking/detail/rocking_series.hpp"

namespace overturn::rocking {

/// sum_{j} a[j] b[k-j]
template <std::size_t N, std::size_t M>
[[nodiscard]] double product_term(std::array<double, N> const& a, std::array<double, M> const& b, int k) {
    double sum = 0;
    for (int j = 0; j <= k; ++j) {
        sum += a[j] * b[k - j];
    }
    return sum;
}

/// First two time derivatives of phi, and the square of the first, term by term.
template <int Order> struct Rates {
    std::array<double, Order - 1> acceleration{};  ///< phi''
    std::array<double, Order - 1> spin{};          ///< phi'^2
    std::array<double, Order> velocity{};          ///< phi'

    explicit Rates(Series<Order> const& s) {
        for (int k = 0; k < Order; ++k) {
            velocity[k] = (k + 1) * s.phi[k + 1];
        }
        for (int k = 0; k + 1 < Order; ++k) {
            acceleration[k] = (k + 1) * velocity[k + 1];
            spin[k] = product_term(velocity, velocity, k);
        }
    }
};

/// Contact forces over m g, mirrored like phi: F points with the rocking side.
template <int Order> struct ContactSeries {
    std::array<double, Order - 1> friction{};
    std::array<double, Order - 1> normal{};
};

/// F = r (cos psi phi'' + sin psi phi'^2) + A, N = r (sin psi phi'' - cos psi phi'^2) + Gv, r = R/g [s2].
template <int Order>
[[nodiscard]] ContactSeries<Order> contact_series(Series<Order> const& s, Forcing const& forcing, double r) {
    Rates<Order> const rates(s);
    ContactSeries<Order> contact;
    for (int k = 0; k + 1 < Order; ++k) {
        contact.friction[k] = r * (product_term(s.cosine, rates.acceleration, k) + product_term(s.sine, rates.spin, k));
        contact.normal[k] = r * (product_term(s.sine, rates.acceleration, k) - product_term(s.cosine, rates.spin, k));
    }
    contact.friction[0] += forcing.horizontal;
    contact.friction[1] += forcing.horizontal_slope;
    contact.normal[0] += forcing.vertical;
    contact.normal[1] += forcing.vertical_slope;
    return contact;
}

}  // namespace overturn::rocking
