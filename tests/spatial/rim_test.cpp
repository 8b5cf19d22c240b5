// Requirement R-606: a round base that stands on its continuous rim knows no direction, rolls as a rigid cylinder does
// in the stiff limit, keeps its energy without damping and friction's loss.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::constant;
using testing::released;
using testing::round_base;
using testing::shaken;
using testing::Shaking;
using testing::SpatialHistory;
using testing::standing;
using testing::unheld;

SpatialBlock elastic(RigidBody const& body, double friction, double tangential_damping = 0) {
    auto footing = round_base();
    footing.pad = {.normal_restitution = 1, .tangential_damping = tangential_damping};
    return standing(body, footing, friction);
}

/// A cylinder of the radius of the base, rolling without slip on a rigid plane: tilt, its rate, precession, its rate,
/// spin about the axis (Srinivasan & Ruina 2008; Lagrange's equations with V_n = -s r + psi' h sin(theta)).
struct Rolling {
    double r, h, across, about, g;
    using State = std::array<double, 5>;
    [[nodiscard]] State rate(State const& y) const {
        double const s = std::sin(y[0]);
        double const c = std::cos(y[0]);
        double const v = -y[4] * r + y[3] * h * s;
        double const spin =
            y[1] * (s * r * y[3] + h * (about / across) * y[4]) / (about / r + r + h * h * about / (r * across));
        return {
            y[1],
            (across * y[3] * y[3] * s * c - about * y[4] * y[3] * s + y[3] * v * (h * c + r * s) + g * (h * s - r * c))
                / (across + h * h + r * r),
            y[3], (about * y[4] * y[1] - 2 * across * c * y[3] * y[1] - (h * about / r) * spin) / (across * s), spin};
    }
    [[nodiscard]] State after(State y, double seconds) const {
        int const steps = static_cast<int>(std::lround(seconds / 1e-4));
        double const d = seconds / steps;
        auto const moved = [](State at, State const& by, double time) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                at[i] += time * by[i];
            }
            return at;
        };
        for (int i = 0; i < steps; ++i) {
            auto const a = rate(y);
            auto const b = rate(moved(y, a, d / 2));
            auto const e = rate(moved(y, b, d / 2));
            auto const f = rate(moved(y, e, d));
            for (std::size_t k = 0; k < y.size(); ++k) {
                y[k] += d / 6 * (a[k] + 2 * (b[k] + e[k]) + f[k]);
            }
        }
        return y;
    }
};

// Its lowest point in place, precessing and not spinning, as deep as it bears what rolling presses.
SpatialStart rolling_start(SpatialBlock const& block, double tilt, double precession) {
    double const r = block.edge_m;
    double const h = block.planar.centre_height_m;
    double const w = block.planar.vertical_radps();
    auto const& inertia = block.inertia_over_mass_m2;
    double const quickening =
        Rolling{r, h, inertia[0], inertia[2], block.planar.gravity_mps2}.rate({tilt, 0, 0, precession, 0})[1];
    double const press = precession == 0
                             ? block.planar.gravity_mps2
                             : block.planar.gravity_mps2 + quickening * (r * std::cos(tilt) - h * std::sin(tilt));
    double const arc = std::cbrt(3 * pi * press / (w * w * r * std::sin(tilt)));
    double const deep = r * std::sin(tilt) * (1 - std::cos(arc));
    double const s = std::sin(tilt);
    double const c = std::cos(tilt);
    // Arm from the lowest point to the centre of gravity, angular velocity psi' (e_z - cos(theta) e3).
    std::array const arm{h * s - r * c, 0.0, h * c + r * s};
    std::array const spin{-precession * c * s, 0.0, precession * s * s};
    return {.x_m = arm[0] + r,
            .rise_m = arm[2] - deep - h + block.planar.settlement_m(),
            .rotation_rad = {0, tilt, 0},
            .velocity_mps = {0, spin[2] * arm[0] - spin[0] * arm[2], 0},
            .angular_velocity_radps = {-precession * s, 0, 0}};
}

// The numbers of the equations alone, and the compliant rim near them; it starts out of balance by what rolling presses
// beside the weight, which does not vanish with stiffness.
TEST(SpatialRim, RollsAsARigidCylinder) {
    auto const block = elastic(body_a(), 100, Pad{}.tangential_damping);
    auto const& inertia = block.inertia_over_mass_m2;
    Rolling const rigid{block.edge_m, block.planar.centre_height_m, inertia[0], inertia[2], g0};
    Rolling::State const start{0.2, 0, 0, 1.5, 0};
    auto const soon = rigid.after(start, 0.75);
    auto const later = rigid.after(start, 1.5);
    EXPECT_NEAR(soon[0], 0.18093674, 1e-7);
    EXPECT_NEAR(soon[2], 3.83358541, 1e-7);
    EXPECT_NEAR(later[0], 0.12519426, 1e-7);
    EXPECT_NEAR(later[2], 7.52624965, 1e-7);

    auto const history = released(block, rolling_start(block, 0.2, 1.5), 1.5).instants;
    double tilt = 0;
    double azimuth = 0;
    for (std::size_t i = 0; i < history.size(); i += 50) {
        auto const at = rigid.after(start, std::max(1e-4, history[i].time_s));
        tilt = std::max(tilt, std::abs(history[i].tilt_rad() - at[0]));
        azimuth = std::max(azimuth, std::abs(std::remainder(history[i].azimuth_rad() - at[2], 2 * pi)));
    }
    RecordProperty("tilt_1e-6", std::to_string(1e6 * tilt));
    RecordProperty("azimuth_1e-6", std::to_string(1e6 * azimuth));
    EXPECT_LT(tilt, 6e-3);
    EXPECT_LT(azimuth, 0.12);
}

TEST(SpatialRim, KeepsItsEnergy) {
    for (double const friction : {0.0, 100.0}) {
        auto const block = elastic(body_a(), friction);
        std::array<double, 2> lost{};
        for (std::size_t i = 0; i < lost.size(); ++i) {
            double const ratio = i == 0 ? 0.025 : 0.00625;
            auto const history = released(block, rolling_start(block, 0.2, 1.5), 3,
                                          {.step_ratio = ratio, .longest_after_s = 0, .rest_gate = false})
                                     .instants;
            double const start = history.front().energy_jpkg;
            for (auto const& instant : history) {
                lost.at(i) = std::max(lost.at(i), std::abs(instant.energy_jpkg / start - 1));
            }
        }
        EXPECT_LT(lost[0], 1e-8) << friction;
        EXPECT_LT(lost[1], 1e-11) << friction;
        EXPECT_LT(lost[1], lost[0] / 100) << friction;  // of fourth order: 256
    }
}

// Nothing damps: it rolls on and on, and never gains.
TEST(SpatialRim, RollsForTenMinutes) {
    struct Extremes : SpatialObserver {
        double first = 0, least = 0, most = 0, tilt = 0;
        void at(SpatialInstant const& instant) override {
            double const energy = instant.energy_jpkg;
            first = first == 0 ? energy : first;
            least = least == 0 ? energy : std::min(least, energy);
            most = std::max(most, energy);
            tilt = std::max(tilt, instant.tilt_rad());
        }
    } seen;
    auto const block = elastic(body_a(), 100);
    auto const calm = constant(0, 60001);
    static_cast<void>(shaken(block, {calm, Shaking::nothing()},
                             {.step_ratio = 0.1, .longest_after_s = 0, .rest_gate = false}, &seen,
                             rolling_start(block, 0.2, 1.5)));
    EXPECT_LT(seen.most / seen.first, 1 + 1e-6);
    EXPECT_GT(seen.least / seen.first, 0.99);
    EXPECT_LT(seen.tilt, 0.25);
    RecordProperty("least", std::to_string(seen.least / seen.first));
}

std::vector<double> turned(std::vector<double> const& wave, double by) {
    auto other = wave;
    for (auto& value : other) {
        value *= by;
    }
    return other;
}

// Two components, and one: whatever the direction, the same tilt, slip, path and yaw.
TEST(SpatialRim, KnowsNoDirection) {
    auto const one_sine = testing::sine(8, 0.7, 1, 0.5, 0.01);
    auto wide = one_sine;
    std::rotate(wide.rbegin(), wide.rbegin() + 40, wide.rend());
    for (double const second : {0.0, 0.6}) {
        auto const block = standing(body_a(), round_base(), 0.7);
        std::optional<SpatialOutcome> first;
        for (double const degrees : {0.0, 2.0, 17.0, 33.0, 77.0, 180.0, 251.0}) {
            double const c = std::cos(degrees * pi / 180);
            double const s = std::sin(degrees * pi / 180);
            auto x = turned(one_sine, c);
            auto y = turned(one_sine, s);
            for (std::size_t i = 0; i < x.size(); ++i) {
                x[i] -= second * s * wide[i];
                y[i] += second * c * wide[i];
            }
            auto const out = shaken(block, {x, y});
            if (!first) {
                first = out;
                EXPECT_GT(out.peak_rotation_ratio, 0.1);
                EXPECT_GT(out.own.slip_path_m, 1e-3);
                continue;
            }
            EXPECT_NEAR(out.peak_rotation_rad / first->peak_rotation_rad, 1, 1e-9) << degrees;
            EXPECT_NEAR(out.own.slip_path_m / first->own.slip_path_m, 1, 1e-6) << degrees;
            EXPECT_NEAR(out.peak_slip_m / first->peak_slip_m, 1, 1e-6) << degrees;
            EXPECT_NEAR(out.own.peak_yaw_rad, first->own.peak_yaw_rad, 1e-9) << degrees;
            EXPECT_EQ(out.verdict, first->verdict) << degrees;
        }
        if (second == 0) {
            EXPECT_LT(first->own.peak_yaw_rad, 1e-12);
        }
    }
}

TEST(SpatialRim, SettlesAsDeepAsItsWeightPresses) {
    auto const block = standing(body_a(), round_base(), 0.8);
    auto const end = released(block, {.rise_m = 1e-3}, 3).instants.back();
    EXPECT_NEAR(end.rise_m, -g0 / std::pow(2 * pi * 98, 2), 1e-12);
    EXPECT_EQ(end.tilt_rad(), 0);
    EXPECT_EQ(end.yaw_rad, 0);
}

// mu N r against J_z = m r^2 / 2.
TEST(SpatialRim, SpinInPlaceDecaysByFriction) {
    auto const block = standing(body_a(), round_base(), 0.3);
    auto const history = released(block, {.angular_velocity_radps = {0, 0, 3}}, 0.2).instants;
    auto const& early = history[history.size() / 4];
    auto const& late = history.back();
    double const slowing = (early.angular_radps[2] - late.angular_radps[2]) / (late.time_s - early.time_s);
    EXPECT_NEAR(slowing, 2 * 0.3 * g0 / block.edge_m, 1e-9);
    EXPECT_EQ(late.tilt_rad(), 0);
}

TEST(SpatialRim, SlidesAlongThePush) {
    auto const block = standing(body_a(), round_base(), 0.3);
    auto const x = constant(4, 101);
    auto const y = constant(3, 101);
    auto const out = shaken(block, {x, y}, unheld);
    EXPECT_NEAR(out.end_velocity_mps[0] / out.end_velocity_mps[1], 4.0 / 3, 1e-9);
    EXPECT_LT(out.own.peak_yaw_rad, 1e-12);
}

// A push below friction, and what is left of a shake: neither creeps.
TEST(SpatialRim, RestsForTenMinutes) {
    auto const block = standing(body_a(), round_base(), 0.3);
    auto const push = constant(0.22 * g0, 60001);
    SpatialHistory history;
    static_cast<void>(shaken(block, {push, Shaking::nothing()},
                             {.step_ratio = 0.6, .longest_after_s = 0, .rest_gate = false}, &history));
    auto const& early = history.instants[history.instants.size() / 300];
    auto const& late = history.instants.back();
    EXPECT_NEAR(late.x_m, early.x_m, 1e-12);
    EXPECT_NEAR(late.rise_m, early.rise_m, 1e-12);
    EXPECT_LT(late.tilt_rad(), 1e-3);
}

}  // namespace
}  // namespace overturn
