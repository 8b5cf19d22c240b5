/// Power series in the time since a step's start, with as many terms as the order states.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/polynomial.hpp"
#include "rocking/detail/block_laws.hpp"
#include "rocking/rocking_accuracy.hpp"

namespace overturn::rocking {

/// An order known when compiled, so that loops unroll: that of campaigns.
template <int Terms> struct FixedOrder {
    static constexpr int most = Terms;
    constexpr operator int() const { return Terms; }  // NOLINT(google-explicit-constructor): it is a number
};
/// Order of campaigns, and of step_lanes.
using CampaignOrder = FixedOrder<campaign_order>;
/// Any of taylor_orders, for studies of accuracy. Terms beyond it are zero, which changes no bit of what evaluation,
/// roots and bounds give.
struct AnyOrder {
    static constexpr int most = *std::max_element(taylor_orders.begin(), taylor_orders.end());
    int terms = most;
    constexpr operator int() const { return terms; }  // NOLINT(google-explicit-constructor): it is a number
};

/// sum_{j} a[j] b[k-j]
template <std::size_t N, std::size_t M>
[[nodiscard]] double product_term(std::array<double, N> const& a, std::array<double, M> const& b, int k) {
    double sum = 0;
    for (int j = 0; j <= k; ++j) {
        sum += a[j] * b[k - j];
    }
    return sum;
}

/// int_0^t c dt.
template <std::size_t N> [[nodiscard]] double integral(std::array<double, N> const& c, double t) {
    double value = 0;
    for (std::size_t k = N; k-- > 0;) {
        value = value * t + c[k] / static_cast<double>(k + 1);
    }
    return value * t;
}

/// int_0^t a b dt, of the product's first `terms` terms.
template <std::size_t N>
[[nodiscard]] double product_integral(std::array<double, N> const& a, std::array<double, N> const& b, int terms,
                                      double t) {
    std::array<double, N> product{};
    for (int k = 0; k < terms; ++k) {
        product[k] = product_term(a, b, k);
    }
    return integral(product, t);
}

/// Forcing over a step, in units of g, mirrored to a corner.
struct Forcing {
    Linear<double> horizontal;  ///< A
    Linear<double> vertical;    ///< Gv = 1 + a_vertical / g
};

/// The k-th term of a series, with the one before.
template <std::size_t N> [[nodiscard]] Term<double> term_of(std::array<double, N> const& c, int k) {
    return {c[k], k > 0 ? c[k - 1] : 0};
}
[[nodiscard]] inline double mul_add(Linear<double> f, Term<double> x, double sum) {
    return sum + f.start * x.now + f.slope * x.before;
}

/// A series as a number: as many terms as a second derivative of one of `Order` terms has.
template <class Order> struct PowerSeries {
    static constexpr std::size_t most = Order::most - 1;
    int terms = most;
    std::array<double, most> c{};

    explicit PowerSeries(Order order) : terms(order - 1) {}
    template <std::size_t N> PowerSeries(Order order, std::array<double, N> const& from) : PowerSeries(order) {
        std::copy_n(from.begin(), terms, c.begin());
    }

    [[nodiscard]] PowerSeries operator*(PowerSeries const& other) const {
        auto product = *this;
        for (int k = 0; k < terms; ++k) {
            product.c[k] = product_term(c, other.c, k);
        }
        return product;
    }
    [[nodiscard]] PowerSeries operator+(PowerSeries other) const {
        for (int k = 0; k < terms; ++k) {
            other.c[k] = c[k] + other.c[k];
        }
        return other;
    }
    [[nodiscard]] PowerSeries operator-(PowerSeries other) const {
        for (int k = 0; k < terms; ++k) {
            other.c[k] = c[k] - other.c[k];
        }
        return other;
    }
    [[nodiscard]] PowerSeries operator+(Linear<double> f) const {
        auto sum = *this;
        sum.c[0] += f.start;
        sum.c[1] += f.slope;
        return sum;
    }
    [[nodiscard]] PowerSeries operator-() const { return -1.0 * *this; }
    [[nodiscard]] friend PowerSeries operator*(double factor, PowerSeries x) {
        for (int k = 0; k < x.terms; ++k) {
            x.c[k] = factor * x.c[k];
        }
        return x;
    }
    [[nodiscard]] friend PowerSeries operator*(PowerSeries const& x, double factor) { return factor * x; }
};
template <class Order>
[[nodiscard]] PowerSeries<Order> mul_add(PowerSeries<Order> const& a, double b, PowerSeries<Order> const& c) {
    return a * b + c;
}

/// phi, sin(psi) and cos(psi) (or their linear stand-ins) over one step.
template <class Order> struct RotationSeries {
    explicit RotationSeries(Order of) : order(of) {}

    Order order;
    std::array<double, Order::most + 1> phi{};
    std::array<double, Order::most> sine{};    ///< restoring factor
    std::array<double, Order::most> cosine{};  ///< driving factor

    [[nodiscard]] std::array<double, Order::most> velocity() const { return derivative(phi); }
};

/// Work of the shaking on the rotation, over m g R: the integral of its power, -phi' times its share of the pull.
/// Zero beyond the terms of `velocity`.
template <std::size_t N>
[[nodiscard]] double shaking_work(std::array<double, N> const& velocity, std::array<double, N> const& sine,
                                  std::array<double, N> const& cosine, Forcing const& f, int terms, double t) {
    std::array<double, N> share{};
    Linear<double> const vertical = f.vertical - 1;
    for (int k = 0; k < terms; ++k) {  // not by pull(), whose sums end in other bits
        auto const s = term_of(sine, k);
        auto const c = term_of(cosine, k);
        share[k] = (f.horizontal.start * c.now + vertical.start * s.now)
                   + (f.horizontal.slope * c.before + vertical.slope * s.before);
    }
    return -product_integral(velocity, share, terms, t);
}

}  // namespace overturn::rocking
