// Requirement R-606: a round base that stands on its continuous rim knows no direction, rolls as a rigid cylinder does
// in the stiff limit, keeps its energy without damping and friction's loss.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spatial/cases.hpp"
#include "spatial/rolling_cylinder.hpp"

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

// A rim that adheres all along its contact does not turn about the vertical: in the stiff limit the cylinder that does
// not pivot, at its steady precession in closed form, and nutating about it. The arc of contact, and with it the error,
// shrinks as the frequency to the power of -4/3.
TEST(SpatialRim, RollsInTheStiffLimitAsACylinderThatDoesNotPivot) {
    for (double const share : {1.0, 0.9}) {
        std::array<double, 2> tilt{};
        std::array<double, 2> azimuth{};
        for (std::size_t i = 0; i < tilt.size(); ++i) {
            auto footing = round_base();
            footing.pad = {.vertical_frequency_hz = i == 0 ? 98.0 : 784.0, .normal_restitution = 1};
            auto const block = standing(body_a(), footing, 100);
            auto const rigid = rolling_cylinder(block, false);
            double const precession = share * rigid.steady_precession_radps(0.2);
            double const spin = RollingCylinder::spin_without_pivoting(0.2, precession);
            RollingCylinder::State const start{0.2, 0, 0, precession, spin};
            double const changed = rigid.after(start, 1.5)[0] - 0.2;
            EXPECT_TRUE(share == 1 ? std::abs(changed) < 1e-9 : std::abs(changed) > 5e-3) << changed;
            auto const history = released(block, rolling_start(block, 0.2, precession, spin), 1.5).instants;
            for (std::size_t k = 0; k < history.size(); k += history.size() / 30) {
                auto const at = rigid.after(start, std::max(1e-4, history[k].time_s));
                tilt.at(i) = std::max(tilt.at(i), std::abs(history[k].tilt_rad() - at[0]));
                azimuth.at(i) =
                    std::max(azimuth.at(i), std::abs(std::remainder(history[k].azimuth_rad() - at[2], 2 * pi)));
            }
        }
        RecordProperty("tilt_1e-6", std::to_string(1e6 * tilt[0]) + " " + std::to_string(1e6 * tilt[1]));
        RecordProperty("azimuth_1e-6", std::to_string(1e6 * azimuth[0]) + " " + std::to_string(1e6 * azimuth[1]));
        EXPECT_LT(tilt[0], 1e-3) << share;
        EXPECT_LT(tilt[1], tilt[0] / 8) << share;
        EXPECT_LT(azimuth[0], 1.5e-2) << share;
        EXPECT_LT(azimuth[1], azimuth[0] / 8) << share;
    }
}

// The numbers of the equations of free pivoting alone, and the compliant rim near them: it does not pivot.
TEST(SpatialRim, RollsAsARigidCylinder) {
    auto const block = elastic(body_a(), 100, Pad{}.tangential_damping);
    auto const rigid = rolling_cylinder(block);
    RollingCylinder::State const start{0.2, 0, 0, 1.5, 0};
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
                EXPECT_GT(out.extra.slip_path_m, 1e-3);
                continue;
            }
            EXPECT_NEAR(out.peak_rotation_rad / first->peak_rotation_rad, 1, 1e-9) << degrees;
            EXPECT_NEAR(out.extra.slip_path_m / first->extra.slip_path_m, 1, 1e-6) << degrees;
            EXPECT_NEAR(out.peak_slip_m / first->peak_slip_m, 1, 1e-6) << degrees;
            EXPECT_NEAR(out.extra.peak_yaw_rad, first->extra.peak_yaw_rad, 1e-9) << degrees;
            EXPECT_EQ(out.verdict, first->verdict) << degrees;
        }
        if (second == 0) {
            EXPECT_LT(first->extra.peak_yaw_rad, 1e-12);
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
    EXPECT_LT(out.extra.peak_yaw_rad, 1e-12);
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
