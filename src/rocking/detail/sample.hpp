/// One sample interval of a wave: forcing in units of g, linear, and how far into it the trial has come.
#pragma once

#include <algorithm>
#include <cstddef>

#include "model/excitation.hpp"
#include "rocking/detail/power_series.hpp"

namespace overturn::rocking {

struct Sample {
    double start_s = 0, length_s = 0, tau_s = 0;
    double a0 = 0, a1 = 0, a_slope = 0;
    double g0 = 1, g1 = 1, g_slope = 0;

    void load(Excitation const& shaking, double gravity_mps2, std::size_t i) {
        double const k = shaking.scale / gravity_mps2;
        length_s = shaking.time_step_s;
        start_s = static_cast<double>(i) * length_s;
        tau_s = 0;
        a0 = k * shaking.horizontal_mps2[i];
        a1 = k * shaking.horizontal_mps2[i + 1];
        a_slope = (a1 - a0) / length_s;
        if (!shaking.vertical_mps2.empty()) {
            g0 = 1 + k * shaking.vertical_mps2[i];
            g1 = 1 + k * shaking.vertical_mps2[i + 1];
            g_slope = (g1 - g0) / length_s;
        }
    }
    /// No shaking from `begin_s` on.
    void calm(double begin_s, double length) {
        *this = {};
        start_s = begin_s;
        length_s = length;
    }

    [[nodiscard]] double now() const { return start_s + tau_s; }
    [[nodiscard]] double left() const { return length_s - tau_s; }
    /// Exact at both ends.
    [[nodiscard]] double horizontal(double tau) const { return tau < length_s ? a0 + a_slope * tau : a1; }
    [[nodiscard]] double vertical(double tau) const { return tau < length_s ? g0 + g_slope * tau : g1; }
    /// Forcing from here on, mirrored to a side.
    [[nodiscard]] Forcing forcing(double side) const {
        return {{side * horizontal(tau_s), side * a_slope}, {vertical(tau_s), g_slope}};
    }
    /// A step that ends at the sample's end ends exactly there.
    void advance(double end, bool at_event) {
        // tau_s + left() misses the length by two roundings at most, 2^-52 = 2e-16 of it.
        constexpr double rounding = 1e-15;
        tau_s = !at_event && tau_s + end >= length_s * (1 - rounding) ? length_s : std::min(tau_s + end, length_s);
    }
};

}  // namespace overturn::rocking
