// Requirement R-604: under one horizontal component a square base in space is the planar body, to rounding, and nothing
// of it leaves the plane, to the last bit.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::shaken;
using testing::Shaking;
using testing::SpatialHistory;
using testing::square_base;
using testing::standing;

struct Difference {
    double tilt_rad = 0, sway_m = 0, rise_m = 0;
};

// In space and in the plane, instant by instant.
Difference largest_difference(RigidBody const& body, Footing const& footing, double friction, Shaking const& by,
                              ContactAccuracy const& accuracy = testing::unheld) {
    auto const space = standing(body, footing, friction);
    auto const plane =
        contact_block(body, footing.base, {.strength_pa = footing.pad.strength_pa}, Friction{friction, friction});
    SpatialHistory of_space;
    testing::ContactHistory of_plane;
    static_cast<void>(simulate_spatial(space, by.excitation(), accuracy, {}, &of_space));
    static_cast<void>(simulate_contact(plane, by.excitation(), accuracy, {}, &of_plane));
    EXPECT_EQ(of_space.instants.size(), of_plane.instants.size());
    Difference most;
    for (std::size_t i = 0; i < std::min(of_space.instants.size(), of_plane.instants.size()); ++i) {
        auto const& s = of_space.instants[i];
        auto const& p = of_plane.instants[i];
        double const base = p.sway_m - plane.centre_height_m * std::sin(p.rotation_rad);
        most.tilt_rad = std::max(most.tilt_rad, std::abs(s.tilts_rad()[1] - p.rotation_rad));
        most.sway_m = std::max(most.sway_m, std::abs(s.x_m - base));
        most.rise_m = std::max(most.rise_m, std::abs(s.rise_m - p.rise_m));
    }
    return most;
}

// 60 s of noise at 1.4 times the uplift acceleration.
TEST(SpatialOneAxis, IsThePlanarBody) {
    testing::TwoWaves const waves;
    for (auto const& body : {body_a(), body_b()}) {
        for (double const friction : {0.8, 10.0}) {
            double const level = 1.4 * body.uplift_acceleration_mps2();
            auto const most = largest_difference(body, {}, friction, {waves.x, Shaking::nothing(), 0.01, level});
            EXPECT_LT(most.tilt_rad, 1e-12) << friction;
            EXPECT_LT(most.sway_m, 1e-12) << friction;
            EXPECT_LT(most.rise_m, 1e-12) << friction;
            RecordProperty("tilt_1e-15_rad", std::to_string(most.tilt_rad * 1e15));
        }
    }
}

// Beds, pads that yield, friction that slips, vertical motion, rest and run-out.
TEST(SpatialOneAxis, IsThePlanarBodyOnEveryBed) {
    auto const wave = testing::sine(1, 1, 2, 1, 0.01);
    auto const up = testing::sine(0.4, 3, 6, 1, 0.01);
    auto weak = square_base(0.3);
    weak.pad.strength_pa = 3e6;
    for (auto const& footing : {square_base(), square_base(0.1), square_base(0.25, 5), weak}) {
        for (double const friction : {0.4, 0.8}) {
            auto const most = largest_difference(body_a(), footing, friction, {wave, Shaking::nothing(), 0.01, 8, up});
            EXPECT_LT(most.tilt_rad, 1e-11) << friction << " " << footing.base.points;
            EXPECT_LT(most.sway_m, 1e-11) << friction << " " << footing.base.points;
        }
    }
    auto const held = largest_difference(body_a(), {}, 0.8, {wave, Shaking::nothing(), 0.01, 8}, {.rest_gate = false});
    EXPECT_LT(held.tilt_rad, 1e-11);
}

TEST(SpatialOneAxis, OutcomesAreThePlanarOnes) {
    auto const wave = testing::sine(1, 1, 1, 2, 1e-3);
    for (auto const& body : {body_a(), body_b()}) {
        for (double const level : {0.9, 1.3, 1.7, 2.4}) {
            Excitation const by{
                .horizontal_mps2 = wave, .time_step_s = 1e-3, .scale = level * body.uplift_acceleration_mps2()};
            auto const space = simulate_spatial(standing(body, {}, 0.8), by, {.rest_gate = false});
            auto const plane =
                simulate_contact(contact_block(body, {}, {}, Friction{0.8, 0.8}), by, {.rest_gate = false});
            EXPECT_EQ(space.verdict, plane.verdict) << level;
            EXPECT_EQ(space.impacts, plane.impacts) << level;
            EXPECT_NEAR(space.peak_rotation_rad, plane.peak_rotation_rad, 1e-11) << level;
            EXPECT_NEAR(space.peak_energy_ratio, plane.peak_energy_ratio, 1e-10) << level;
            EXPECT_NEAR(space.peak_impact_velocity_mps, plane.peak_impact_velocity_mps, 1e-9) << level;
            EXPECT_EQ(plane.peak_impact_velocity_mps > 0, plane.impacts > 0) << level;
            EXPECT_NEAR(space.response_velocity_mps, plane.response_velocity_mps, 1e-4) << level;
            EXPECT_NEAR(space.peak_slip_m, plane.peak_slip_m, 1e-11) << level;
            EXPECT_NEAR(space.residual_slip_m, std::abs(plane.residual_slip_m), 1e-11) << level;
            EXPECT_NEAR(space.extra.peak_contact_force_ratio, plane.extra.peak_contact_force_ratio, 1e-7) << level;
            EXPECT_NEAR(space.extra.peak_rise_m, plane.extra.peak_rise_m, 1e-11) << level;
            EXPECT_EQ(std::isnan(space.contact_lost_s), std::isnan(plane.contact_lost_s)) << level;
            EXPECT_EQ(std::isnan(space.first_uplift_s), std::isnan(plane.first_uplift_s)) << level;
        }
    }
}

// where corners have been crushed too, a body's height is that of its base as it was made.
TEST(SpatialOneAxis, EnergiesOnACrushedPadAreThePlanarOnes) {
    auto const wave = testing::sine(1, 1, 1, 2, 1e-3);
    auto weak = square_base(0.3);
    weak.pad.strength_pa = 3e6;
    for (double const level : {8.0, 10.0, 12.0}) {
        Excitation const by{.horizontal_mps2 = wave, .time_step_s = 1e-3, .scale = level};
        auto const space = simulate_spatial(standing(body_a(), weak, 0.8), by, {.rest_gate = false});
        auto const plane = simulate_contact(
            contact_block(body_a(), weak.base, {.strength_pa = 3e6}, Friction{0.8, 0.8}), by, {.rest_gate = false});
        EXPECT_GT(space.extra.peak_crush_m, 1e-6) << level;
        EXPECT_NEAR(space.extra.peak_crush_m, plane.extra.peak_crush_m, 1e-11) << level;
        EXPECT_NEAR(space.peak_energy_ratio, plane.peak_energy_ratio, 1e-9) << level;
    }
}

// Whatever the bed and whichever of the two axes: exact zeros, and the same bits along both.
TEST(SpatialOneAxis, NothingLeavesThePlane) {
    testing::TwoWaves waves;
    waves.x.resize(2001);
    auto const& none = Shaking::nothing();
    auto const still = testing::constant(0, waves.x.size());
    for (auto const& footing : {square_base(), square_base(0.1), testing::round_base()}) {
        auto const block = standing(body_a(), footing, 0.8);
        SpatialHistory along;
        SpatialHistory across;
        static_cast<void>(shaken(block, {waves.x, none, 0.01, 9}, {}, &along));
        static_cast<void>(shaken(block, {still, waves.x, 0.01, 9}, {}, &across));
        ASSERT_EQ(along.instants.size(), across.instants.size());
        double tilt = 0;
        bool const corners = footing.base.shape == BaseShape::square && *footing.base.corner_share == 1;
        for (std::size_t i = 0; i < along.instants.size(); ++i) {
            auto const& x = along.instants[i];
            auto const& y = across.instants[i];
            ASSERT_TRUE(x.quaternion[1] == 0 && x.quaternion[3] == 0 && x.y_m == 0 && x.velocity_mps[1] == 0
                        && x.angular_radps[0] == 0 && x.angular_radps[2] == 0)
                << i;
            if (corners) {
                ASSERT_TRUE(y.quaternion[2] == 0 && y.quaternion[3] == 0 && y.x_m == 0) << i;
                ASSERT_TRUE(y.quaternion[1] == -x.quaternion[2] && y.y_m == x.x_m && y.rise_m == x.rise_m) << i;
            }
            tilt = std::max(tilt, x.tilt_rad());
        }
        EXPECT_GT(tilt, 0.005);
    }
}

// A second component of 1e-6 m/s2 stays as small as it is.
TEST(SpatialOneAxis, AnotherComponentDoesNotGrow) {
    testing::TwoWaves const waves;
    auto faint = waves.y;
    double const level = 1.4 * body_a().uplift_acceleration_mps2();
    for (auto& value : faint) {
        value *= 1e-6 / level;
    }
    SpatialHistory history;
    static_cast<void>(shaken(standing(body_a(), {}, 0.8), {waves.x, faint, 0.01, level}, testing::unheld, &history));
    double most = 0;
    for (auto const& instant : history.instants) {
        most = std::max(most, std::abs(instant.tilts_rad()[0]));
    }
    EXPECT_GT(most, 0);
    EXPECT_LT(most, 1e-9);
    RecordProperty("tilt_1e-12_rad", std::to_string(most * 1e12));
}

}  // namespace
}  // namespace overturn
