// Requirement R-601: points grip the ground by Coulomb friction in every direction of the plane, without creep.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::constant;
using testing::released;
using testing::shaken;
using testing::Shaking;
using testing::SpatialHistory;
using testing::standing;
using testing::unheld;

SpatialInstant const& at(std::vector<SpatialInstant> const& instants, double time_s) {
    return *std::ranges::find_if(instants, [&](auto const& i) { return i.time_s > time_s - 1e-9; });
}

// a = (4, 3) m/s2 against mu g: along the push.
TEST(SpatialGrip, SlidesAgainstThePush) {
    auto const x = constant(4, 1001);
    auto const y = constant(3, 1001);
    SpatialHistory history;
    auto const out = shaken(standing(body_a(), {}, 0.3), {x, y, 1e-3}, unheld, &history);
    auto const& half = at(history.instants, 0.5);
    auto const& whole = at(history.instants, 1);
    double const dx = whole.velocity_mps[0] - half.velocity_mps[0];
    double const dy = whole.velocity_mps[1] - half.velocity_mps[1];
    EXPECT_NEAR(dx / dy, 4.0 / 3, 1e-6);
    EXPECT_NEAR(std::hypot(dx, dy) / 0.5, 2.058005, 1e-6);
    EXPECT_NEAR(std::hypot(dx, dy) / 0.5, 5 - 0.3 * g0, 1e-8);
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_LT(out.extra.peak_yaw_rad, 1e-6);  // points that bear less slip first
    EXPECT_NEAR(out.extra.slip_path_m, out.peak_slip_m, 1e-4);
}

TEST(SpatialGrip, WithoutFrictionTheGroundLeavesTheBody) {
    auto const x = constant(4, 1001);
    auto const y = constant(3, 1001);
    auto const out = shaken(standing(body_a(), testing::round_base(), 0), {x, y, 1e-3}, unheld);
    EXPECT_NEAR(out.end_velocity_mps[0], -4, 1e-9);
    EXPECT_NEAR(out.end_velocity_mps[1], -3, 1e-9);
    EXPECT_LT(out.peak_rotation_rad, 1e-12);
}

TEST(SpatialGrip, SpinsOnWithoutFriction) {
    for (auto const& footing : {testing::square_base(), testing::round_base()}) {
        auto const history = released(standing(body_a(), footing, 0), {.angular_velocity_radps = {0, 0, 3}}, 10);
        EXPECT_NEAR(history.instants.back().angular_radps[2], 3, 1e-12);
        EXPECT_LT(history.instants.back().tilt_rad(), 1e-12);
        EXPECT_NEAR(history.instants.back().yaw_rad, 30, 1e-9);
        double norm = 0;
        for (double const part : history.instants.back().quaternion) {
            norm += part * part;
        }
        EXPECT_NEAR(norm, 1, 1e-15);
    }
}

// All points lie as far from the axis: w' = -mu g arm / (I_z / m), until it stands.
TEST(SpatialGrip, FrictionStopsASpin) {
    struct Case {
        Footing footing;
        double arm_m;
    };
    for (auto const& [footing, arm] :
         {Case{testing::square_base(), 0.68 * std::sqrt(2)}, {testing::round_base(), 0.68}}) {
        auto const block = standing(body_a(), footing, 0.2);
        double const slowing = 0.2 * g0 * arm / block.inertia_over_mass_m2[2];
        double const start = 6;
        auto const history = released(block, {.angular_velocity_radps = {0, 0, start}}, 3);
        auto const spin = [&](double time_s) { return at(history.instants, time_s).angular_radps[2]; };
        EXPECT_NEAR(
            (spin(0.2) - spin(0.8)) / (at(history.instants, 0.8).time_s - at(history.instants, 0.2).time_s) / slowing,
            1, 1e-8);
        auto const& end = history.instants.back();
        EXPECT_LT(std::abs(end.angular_radps[2]), 1e-9);
        EXPECT_NEAR(end.yaw_rad, start * start / (2 * slowing), 2e-3 * end.yaw_rad);
        EXPECT_LT(std::hypot(end.x_m, end.y_m), 1e-9);
    }
}

// Turned past half a turn and back to rest there.
TEST(SpatialGrip, CountsWholeTurns) {
    auto const block = standing(body_a(), {}, 0.2);
    double const slowing = 0.2 * g0 * 0.68 * std::sqrt(2) / block.inertia_over_mass_m2[2];
    for (double const turns : {-2.3, -0.7, 0.2, 0.6, 1.4, 3.1}) {
        double const spin = std::copysign(std::sqrt(2 * slowing * 2 * pi * std::abs(turns)), turns);
        auto const calm = constant(0, 801);
        auto const out = shaken(block, {calm, Shaking::nothing()}, unheld, nullptr,
                                SpatialStart{.angular_velocity_radps = {0, 0, spin}});
        EXPECT_NEAR(out.extra.yaw_rad, 2 * pi * turns, 0.02 * std::abs(turns) * pi) << turns;
        EXPECT_NEAR(out.extra.peak_yaw_rad, std::abs(out.extra.yaw_rad), 1e-3) << turns;
        EXPECT_EQ(out.verdict, Verdict::slid) << turns;
    }
}

TEST(SpatialGrip, TenMinutesAtRestDoNotCreep) {
    for (auto const& footing : {testing::square_base(), testing::round_base()}) {
        auto const block = standing(body_a(), footing, 0.3);
        auto const early_x = constant(0.12 * g0, 501);
        auto const early_y = constant(0.09 * g0, 501);
        auto const late_x = constant(0.12 * g0, 60001);
        auto const late_y = constant(0.09 * g0, 60001);
        auto const early = shaken(block, {early_x, early_y}, unheld);
        auto const late = shaken(block, {late_x, late_y}, unheld);
        EXPECT_EQ(late.verdict, Verdict::at_rest);
        EXPECT_NEAR(late.residual_m[0], early.residual_m[0], 1e-12);
        EXPECT_NEAR(late.residual_m[1], early.residual_m[1], 1e-12);
        EXPECT_NEAR(late.extra.yaw_rad, early.extra.yaw_rad, 1e-12);
        EXPECT_LT(std::hypot(late.end_velocity_mps[0], late.end_velocity_mps[1]), 1e-12);
    }
}

}  // namespace
}  // namespace overturn
