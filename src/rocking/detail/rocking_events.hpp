/// Guards of the rocking block on one step's series: the fall through zero, and the turning points.
#pragma once

#include "core/polynomial.hpp"

namespace overturn::rocking {

/// Kind of the zero of phi at the start of a step: such a zero is no event, however close rounding brings it.
enum class StartRoot { none = 0, simple = 1, twofold = 2 };

namespace detail {

// c / t^Drop: the same polynomial without the roots at the start.
template <std::size_t Drop, std::size_t N> std::array<double, N - Drop> deflated(std::array<double, N> const& c) {
    std::array<double, N - Drop> d{};
    for (std::size_t k = Drop; k < N; ++k) {
        d[k - Drop] = c[k];
    }
    return d;
}

// c starts at zero, or below it by rounding: it falls at once, or after having risen.
template <std::size_t N> double fall_from_zero(std::array<double, N> const& c, double h) {
    for (std::size_t k = 1; k < N; ++k) {
        if (c[k] < 0) {
            return 0;
        }
        if (c[k] > 0) {
            break;
        }
    }
    auto const slope = derivative(c);
    auto const turning = roots_in(slope, 0.0, h);
    double before = 0;
    for (std::size_t i = 0; i <= turning.count; ++i) {
        double const next = i < turning.count ? turning.at[i] : h;
        if (evaluate(c, before) > 0 && evaluate(c, next) <= 0) {
            return root_between(c, before, next);
        }
        before = next;
    }
    return -1;
}

template <std::size_t N> double first_fall(std::array<double, N> const& c, double h) {
    // Cheap ways out first: far from zero; or monotone or concave, where only the end's sign matters.
    if (c[0] > tail_bound(c, 1, h)) {
        return -1;
    }
    auto const slope = derivative(c);
    bool const rising = slope[0] > tail_bound(slope, 1, h);
    if (rising) {
        return -1;
    }
    if (c[0] <= 0) {
        return fall_from_zero(c, h);
    }
    bool bending_once = -slope[0] > tail_bound(slope, 1, h);  // falling all the way
    if constexpr (N > 2) {
        auto const curvature = derivative(slope);
        bending_once = bending_once || -curvature[0] > tail_bound(curvature, 1, h);  // or concave
    }
    if (bending_once) {
        return evaluate(c, h) <= 0 ? root_between(c, 0.0, h) : -1;
    }
    auto const roots = roots_in(c, 0.0, h);
    for (double const root : roots.all()) {
        if (evaluate(slope, root) <= 0) {
            return root;
        }
    }
    return -1;
}

}  // namespace detail

/// The first time in [0, h] at which c falls through zero, or -1; 0 if it starts there, but for rounding, and falls.
template <std::size_t N>
[[nodiscard]] double first_fall_through_zero(std::array<double, N> const& c, double h, StartRoot start) {
    switch (start) {
        case StartRoot::none:
            return detail::first_fall(c, h);
        case StartRoot::simple:
            return detail::first_fall(detail::deflated<1>(c), h);
        case StartRoot::twofold:
            return detail::first_fall(detail::deflated<2>(c), h);
    }
    return -1;
}

/// Calls visit(t) for every t in (0, h] where c turns from rising to falling.
template <std::size_t N, class Visit> void for_each_maximum(std::array<double, N> const& c, double h, Visit&& visit) {
    auto const slope = derivative(c);
    if (std::abs(slope[0]) > tail_bound(slope, 1, h)) {
        return;
    }
    auto const curvature = derivative(slope);
    auto const roots = roots_in(slope, 0.0, h);
    for (double const root : roots.all()) {
        if (evaluate(curvature, root) <= 0) {
            visit(root);
        }
    }
}

}  // namespace overturn::rocking
