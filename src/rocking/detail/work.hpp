/// Work done over one step, by exact integration of its series.
#pragma once

#include "core/polynomial.hpp"
#include "rocking/detail/contact_series.hpp"
#include "rocking/detail/lane_step.hpp"

namespace overturn::rocking {

/// int_0^t c dt.
template <std::size_t N> [[nodiscard]] double integral(std::array<double, N> const& c, double t) {
    double value = 0;
    for (std::size_t k = N; k-- > 0;) {
        value = value * t + c[k] / static_cast<double>(k + 1);
    }
    return value * t;
}

/// int_0^t a b dt for series of one length.
template <std::size_t N>
[[nodiscard]] double product_integral(std::array<double, N> const& a, std::array<double, N> const& b, double t) {
    std::array<double, N> product{};
    for (std::size_t k = 0; k < N; ++k) {
        product[k] = product_term(a, b, static_cast<int>(k));
    }
    return integral(product, t);
}

/// Work of the shaking on the rotation, over m g R: -int phi' (A cos psi + (Gv - 1) sin psi) dt.
template <int Order> [[nodiscard]] double shaking_work(Series<Order> const& s, Forcing const& f, double t) {
    std::array<double, Order> pull{};
    for (int k = 0; k < Order; ++k) {
        pull[k] = f.horizontal * s.cosine[k] + (f.vertical - 1) * s.sine[k];
        if (k > 0) {
            pull[k] += f.horizontal_slope * s.cosine[k - 1] + f.vertical_slope * s.sine[k - 1];
        }
    }
    return -product_integral(Rates<Order>(s).velocity, pull, t);
}

/// The same for a step in a lane.
[[nodiscard]] inline double shaking_work(LaneStep const& s) {
    constexpr std::size_t order = LaneStep::order;
    std::array<double, order> pull{};
    for (std::size_t k = 0; k < order; ++k) {
        for (std::size_t j = 0; j <= std::min<std::size_t>(k, 1); ++j) {
            pull[k] += s.horizontal[j] * s.cosine[k - j] + (s.vertical[j] - (j == 0 ? 1 : 0)) * s.sine[k - j];
        }
    }
    return -product_integral(s.rates, pull, s.share);
}

}  // namespace overturn::rocking
