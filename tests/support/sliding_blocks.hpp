/// Blocks that may slip, the last state of a history, and short waves with a number in place of a seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "body/rigid_body.hpp"
#include "rocking/planar_rocking.hpp"
#include "rocking/rocking_models.hpp"

namespace overturn::testing {

/// A free-standing cask of the heavier kind.
inline RockingBlock type_a(double friction_static, double friction_kinetic) {
    return {.alpha_rad = std::atan(0.68 / 1.045),
            .p_radps = 2.4288,
            .restitution = 0.5538,
            .inertia_ratio = 0.75,
            .friction_static = friction_static,
            .friction_kinetic = friction_kinetic};
}
inline RockingBlock type_a(double friction) { return type_a(friction, friction); }
/// The same with its centre of gravity off the middle, on ground that falls towards +x.
inline RockingBlock lopsided_a(double offset_m, double slope_rad, double friction_static, double friction_kinetic) {
    double const mass = 12.6e3;
    RigidBody const body({.mass_kg = mass,
                          .half_width_m = 0.68,
                          .centre_height_m = 1.045,
                          .inertia_kgm2 = mass * (0.68 * 0.68 + 1.045 * 1.045) / 3,
                          .offset_m = offset_m,
                          .slope_rad = slope_rad});
    return block_of(body, Friction{friction_static, friction_kinetic});
}
inline RockingBlock lopsided_a(double offset_m, double slope_rad, double friction) {
    return lopsided_a(offset_m, slope_rad, friction, friction);
}
inline constexpr double type_a_tips = 0.68 / 1.045;  ///< tan(alpha)

inline Excitation shaking_of(std::span<double const> a, double time_step_s, double scale = 1) {
    return {.horizontal_mps2 = a, .vertical_mps2 = {}, .time_step_s = time_step_s, .scale = scale};
}

inline RockingOutcome simulate_slipping(RockingBlock const& block, Excitation const& shaking,
                                        RockingObserver* observer = nullptr, RockingStart const& start = {}) {
    return simulate_rocking(block, shaking, {}, start, observer, Slip::simulated);
}

inline std::vector<double> mirrored(std::vector<double> wave) {
    for (double& a : wave) {
        a = -a;
    }
    return wave;
}

/// Keeps every instant it is shown.
struct History : RockingObserver {
    void at(RockingInstant const& instant) override { instants.push_back(instant); }
    std::vector<RockingInstant> instants;
};

/// 20 s at 0.02 s with a peak of 1 m/s2: 24 cosines between 0.15 and 4 Hz, rising for 2 s and decaying after 12 s.
inline std::vector<double> short_wave(int number) {
    constexpr std::size_t samples = 1001;
    constexpr double dt = 0.02;
    std::vector<double> a(samples, 0.0);
    for (int k = 0; k < 24; ++k) {
        double const f = 0.15 * std::pow(4 / 0.15, (k + 0.5) / 24);
        double const golden = 0.6180339887498949 * (k + 1) * (k + 7 * number + 1);
        double const phase = 2 * std::numbers::pi * (golden - std::floor(golden));
        double const amplitude = 1 / (1 + f * f);
        for (std::size_t i = 0; i < samples; ++i) {
            a[i] += amplitude * std::cos(2 * std::numbers::pi * f * static_cast<double>(i) * dt + phase);
        }
    }
    double peak = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        double const t = static_cast<double>(i) * dt;
        a[i] *= t < 2 ? t * t / 4 : t < 12 ? 1.0 : std::exp(-0.4 * (t - 12));
        peak = std::max(peak, std::abs(a[i]));
    }
    for (double& value : a) {
        value /= peak;
    }
    return a;
}

}  // namespace overturn::testing
