/// Small polynomials of the time integrators: evaluation, and every real root inside an interval.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace overturn {

/// sum c[k] t^k by Horner's rule.
template <std::size_t N> [[nodiscard]] double evaluate(std::array<double, N> const& c, double t) {
    double value = c[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) {
        value = value * t + c[k];
    }
    return value;
}

/// Coefficients of the derivative.
template <std::size_t N> [[nodiscard]] std::array<double, N - 1> derivative(std::array<double, N> const& c) {
    std::array<double, N - 1> d{};
    for (std::size_t k = 1; k < N; ++k) {
        d[k - 1] = static_cast<double>(k) * c[k];
    }
    return d;
}

/// The root of c between lo and hi, where c changes sign once; Newton steps, bisection where one would leave the
/// bracket. Ends when the bracket holds no further double.
template <std::size_t N> [[nodiscard]] double root_between(std::array<double, N> const& c, double lo, double hi) {
    double const sign = evaluate(c, lo) <= 0 ? 1.0 : -1.0;  // sign * c rises through the root
    auto const slope = derivative(c);
    double t = 0.5 * (lo + hi);
    // Newton needs about 5 steps, bisection alone some 53 to where no double is left in the bracket; only a root at
    // zero has ever smaller ones beside it, and is then given as 2^-200 of the bracket at most.
    constexpr int most = 200;
    for (int i = 0; i < most; ++i) {
        double const value = sign * evaluate(c, t);
        (value < 0 ? lo : hi) = t;
        double const newton = t - value / (sign * evaluate(slope, t));
        double const next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (next == t || !(next > lo && next < hi) || value == 0) {
            break;
        }
        t = next;
    }
    return t;
}

/// An upper bound of |sum_{k >= first} c[k] t^k| for 0 <= t <= h.
template <std::size_t N> [[nodiscard]] double tail_bound(std::array<double, N> const& c, std::size_t first, double h) {
    double bound = 0;
    for (std::size_t k = N; k-- > first;) {
        bound = bound * h + std::abs(c[k]);
    }
    for (std::size_t k = 0; k < first; ++k) {
        bound *= h;
    }
    return bound;
}

/// Every place in (lo, hi] where c changes sign, in rising order; a touching double root may be left out.
/// Works down through the derivatives, so that each bracket is monotone and none can be missed.
template <std::size_t N> struct Roots {
    std::array<double, N> at{};
    std::size_t count = 0;
    [[nodiscard]] std::span<double const> all() const& { return {at.data(), count}; }
    [[nodiscard]] std::span<double const> all() const&& = delete;  // would outlive its roots
};

template <std::size_t N> [[nodiscard]] Roots<N> roots_in(std::array<double, N> const& c, double lo, double hi) {
    Roots<N> found;
    if constexpr (N >= 2) {
        if (std::abs(c[0]) > tail_bound(c, 1, std::max(std::abs(lo), std::abs(hi)))) {
            return found;  // too far from zero to get there
        }
        auto const turning = roots_in(derivative(c), lo, hi);
        double left = lo;
        double left_value = evaluate(c, lo);
        for (std::size_t i = 0; i <= turning.count; ++i) {
            double const right = i < turning.count ? turning.at[i] : hi;
            double const right_value = evaluate(c, right);
            if ((left_value < 0 && right_value >= 0) || (left_value > 0 && right_value <= 0)) {
                found.at[found.count++] = root_between(c, left, right);
            }
            left = right;
            left_value = right_value;
        }
    }
    return found;
}

}  // namespace overturn
