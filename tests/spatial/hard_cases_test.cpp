// Requirement R-605: bodies of every shape stay finite and never gain energy: rolling rims, needles, coins, throws and
// poison.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

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
using testing::square_base;
using testing::standing;
using testing::unheld;

RigidBody solid(double half_width_m, double centre_height_m) {
    double const m = 1000;
    return RigidBody({.mass_kg = m,
                      .half_width_m = half_width_m,
                      .centre_height_m = centre_height_m,
                      .inertia_kgm2 = m * (half_width_m * half_width_m / 4 + centre_height_m * centre_height_m / 3),
                      .restitution = 0.5});
}

// Of motion and height, over the mass; what springs hold comes on top.
double energy(SpatialBlock const& block, SpatialInstant const& at) {
    double sum = block.planar.gravity_mps2 * at.rise_m;
    for (std::size_t i = 0; i < 3; ++i) {
        sum += 0.5
               * (at.velocity_mps[i] * at.velocity_mps[i]
                  + block.inertia_over_mass_m2[i] * at.angular_radps[i] * at.angular_radps[i]);
    }
    return sum;
}

// Leaning on its lowest point, which just touches, and spinning about the vertical.
SpatialStart wobbling(SpatialBlock const& block, double tilt_rad, double spin_radps) {
    double const h = block.planar.centre_height_m;
    double const b = block.planar.half_width_m;
    return {.x_m = b * (1 - std::cos(tilt_rad)) + h * std::sin(tilt_rad),
            .rise_m = b * std::sin(tilt_rad) - h * (1 - std::cos(tilt_rad)) + block.planar.settlement_m(),
            .rotation_rad = {0, tilt_rad, 0},
            .angular_velocity_radps = {-spin_radps * std::sin(tilt_rad), 0, spin_radps * std::cos(tilt_rad)}};
}

TEST(SpatialHardCases, AWobblingCylinderNeverGainsEnergy) {
    for (int const points : {0, 16, 32, 64, 128}) {
        for (double const friction : {0.3, 0.8}) {
            auto const block = standing(body_a(), round_base(points), friction);
            auto const history = released(block, wobbling(block, 0.2, 1), 5);
            double const start = energy(block, history.instants.front());
            for (auto const& instant : history.instants) {
                ASSERT_LT(energy(block, instant) / start, 1 + 1e-9) << points << " " << instant.time_s;
            }
            auto const& end = history.instants.back();
            EXPECT_TRUE(std::isfinite(end.x_m + end.y_m + end.yaw_rad));
            if (points > fewest_rim_points) {  // fewer roll from point to point for some seconds more, a rim for long
                EXPECT_LT(end.tilt_rad(), 1e-9) << points << " " << friction;
            }
            EXPECT_GT(std::abs(end.yaw_rad), 1e-3) << points << " " << friction;
        }
    }
}

// On its edge like a coin that comes to rest, faster and faster: with springs counted, energy falls from step to step.
TEST(SpatialHardCases, ASettlingCoinNeverGainsEnergy) {
    for (double const friction : {0.0, 0.3, 10.0}) {
        auto const block = standing(solid(0.5, 0.02), round_base(), friction);
        auto const history = released(block, wobbling(block, 0.3, 6), 8).instants;
        double least = history.front().energy_jpkg;
        for (auto const& instant : history) {
            ASSERT_LT(instant.energy_jpkg, least + 1e-6) << friction << " " << instant.time_s;
            least = std::min(least, instant.energy_jpkg);
        }
        EXPECT_LT(history.back().tilt_rad(), 0.03) << friction;
    }
}

// Thin and tall, flat and wide: shaken, thrown on an edge, spun.
TEST(SpatialHardCases, NeedleAndCoinStayFinite) {
    testing::TwoWaves waves;
    waves.x.resize(1001);
    waves.y.resize(1001);
    for (auto const& body : {solid(0.05, 5), solid(2, 0.05), solid(0.5, 0.01)}) {
        for (auto const& footing : {square_base(), round_base()}) {
            auto const block = standing(body, footing, 0.5);
            for (double const level : {0.05, 1.0, 30.0}) {
                auto const out = shaken(block, {waves.x, waves.y, 0.01, level});
                EXPECT_EQ(out.failure, FailureReason::none);
                EXPECT_TRUE(out.verdict == Verdict::overturned || out.peak_rotation_rad < pi / 2);
                EXPECT_TRUE(
                    std::isfinite(out.residual_slip_m + out.extra.yaw_rad + out.extra.peak_contact_force_ratio));
            }
            auto start = wobbling(block, 0.5 * std::atan2(block.planar.half_width_m, block.planar.centre_height_m), 5);
            auto const history = released(block, start, 3);
            double const most = energy(block, history.instants.front());
            for (auto const& instant : history.instants) {
                ASSERT_LT(energy(block, instant), most * (1 + 1e-6));
            }
        }
    }
    EXPECT_EQ(shaken(standing(solid(0.05, 5), {}, 0.5), {waves.x, waves.y, 0.01, 1}).verdict, Verdict::overturned);
}

// The ground falls with 1 g for a second: the springs let go of the weight, the base drifts up with no force on it, as
// fast as the springs threw it (g / w_v, if they are elastic), and comes down flat when gravity is back.
TEST(SpatialHardCases, VerticalMotionOfOneGravity) {
    std::vector<double> fall = constant(-g0, 1001);
    fall.resize(1301, 0.0);
    auto const calm = constant(0, fall.size());
    auto disc = round_base();
    disc.base.corner_share.reset();
    auto ring = disc;
    ring.base.inner_radius_m = 0.4;
    for (auto footing : {square_base(), square_base(0.1), round_base(), round_base(64), disc, ring}) {
        for (double const restitution : {1.0, 0.25}) {
            footing.pad.normal_restitution = restitution;
            auto const block = standing(body_a(), footing, 0.8);
            SpatialHistory seen;
            auto const out = shaken(block, {calm, calm, 1e-3, 1, fall},
                                    {.step_ratio = 0.025, .longest_after_s = 2, .rest_gate = false}, &seen);
            double const thrown = g0 / block.planar.vertical_radps();
            std::array<SpatialInstant, 2> drifting;
            for (auto const& instant : seen.instants) {
                if (instant.time_s < 0.9) {
                    (instant.time_s < 0.1 ? drifting[0] : drifting[1]) = instant;
                }
                if (instant.time_s > 0.05 && instant.time_s < 0.99) {
                    ASSERT_EQ(instant.contact_force_ratio, 0) << instant.time_s;
                }
            }
            double const velocity =
                (drifting[1].rise_m - drifting[0].rise_m) / (drifting[1].time_s - drifting[0].time_s);
            EXPECT_NEAR(velocity, drifting[1].velocity_mps[2], 1e-9);
            if (restitution == 1) {
                EXPECT_NEAR(velocity / thrown, 1, 5e-5);  // letting go within a step errs as its square
            } else {
                EXPECT_GT(velocity, 0);
                EXPECT_LT(velocity, thrown);
            }
            EXPECT_EQ(out.failure, FailureReason::none);
            EXPECT_EQ(out.verdict, Verdict::rocked);  // every point parted from the ground
            EXPECT_LT(out.peak_rotation_rad, 1e-9);
            EXPECT_NEAR(out.extra.peak_rise_m, velocity, 0.01 * velocity + thrown / 98);
            if (restitution < 1) {
                EXPECT_NEAR(seen.instants.back().rise_m, -block.planar.settlement_m(), 1e-9);
            }
        }
    }
}

// Thrown up and caught again, over and over; nothing tips what falls flat.
TEST(SpatialHardCases, TenTimesGravityUpAndDown) {
    auto const up = testing::sine(10 * g0, 2, 10, 2);
    auto const calm = constant(0, up.size());
    for (auto const& footing : {square_base(), square_base(0.1), round_base()}) {
        auto const out = shaken(standing(body_a(), footing, 0.8), {calm, calm, 1e-3, 1, up});
        EXPECT_EQ(out.failure, FailureReason::none);
        EXPECT_EQ(out.verdict, Verdict::rocked);  // every point parted from the ground
        EXPECT_LT(out.peak_rotation_rad, 1e-6);
        EXPECT_GT(out.extra.peak_contact_force_ratio, 10);
        EXPECT_GT(out.extra.peak_rise_m, 0.1);
        EXPECT_EQ(out.min_contact_force_ratio, 0);
        EXPECT_FALSE(std::isnan(out.contact_lost_s));
    }
}

// After the motion a body is followed until it rests: what is reported does not hang on where the motion ends.
TEST(SpatialHardCases, FollowedUntilItRests) {
    auto const pulse = testing::sine(1, 2, 1, 0);
    auto longer = pulse;
    longer.resize(pulse.size() + 8000, 0.0);
    for (auto const& footing : {square_base(), square_base(0.3), round_base()}) {
        auto const block = standing(body_a(), footing, 10);
        auto const followed = shaken(block, {pulse, pulse, 1e-3, 7});
        auto const shaken_on = shaken(block, {longer, longer, 1e-3, 7});
        EXPECT_EQ(followed.verdict, Verdict::rocked);
        EXPECT_EQ(followed.verdict, shaken_on.verdict);
        EXPECT_EQ(followed.peak_rotation_rad, shaken_on.peak_rotation_rad);
        EXPECT_EQ(followed.peak_slip_m, shaken_on.peak_slip_m);
        EXPECT_EQ(followed.impacts, shaken_on.impacts);
        EXPECT_EQ(followed.min_contact_force_ratio, shaken_on.min_contact_force_ratio);
    }
}

// A small second component makes a round base roll, a square one not.
TEST(SpatialHardCases, RoundBasesFeelASecondComponent) {
    testing::TwoWaves const waves;
    std::vector<double> faint = waves.y;
    for (auto& value : faint) {
        value *= 0.05;
    }
    auto const change = [&](Footing const& footing) {
        auto const block = standing(body_a(), footing, 0.8);
        double most = 0;
        for (double const level : {8.0, 9.0, 10.0, 11.0}) {
            double const alone = shaken(block, {waves.x, Shaking::nothing(), 0.01, level}).peak_rotation_ratio;
            double const both = shaken(block, {waves.x, faint, 0.01, level}).peak_rotation_ratio;
            most = std::max(most, std::abs(both - alone));
        }
        return most;
    };
    double const round = change(round_base());
    double const square = change(square_base());
    RecordProperty("round", std::to_string(round));
    RecordProperty("square", std::to_string(square));
    EXPECT_GT(round, 0.1);
    EXPECT_LT(square, 0.02);
}

// Little inertia shivers quickly: steps are shorter, and nothing else changes under a push that moves nothing.
TEST(SpatialHardCases, LittleInertiaNeedsShortSteps) {
    testing::TwoWaves waves;
    waves.x.resize(2001);
    waves.y.resize(2001);
    for (auto footing : {square_base(), round_base()}) {
        double const plain =
            shaken(standing(body_a(), footing, 0.8), {waves.x, waves.y, 0.01, 3}, unheld).peak_rotation_rad;
        for (double const share : {0.3, 0.03}) {
            double const inertia = share * body_a().inertia_kgm2();
            footing.inertia_across_kgm2 = inertia;
            footing.inertia_vertical_kgm2 = inertia;
            auto const out = shaken(standing(body_a(), footing, 0.8), {waves.x, waves.y, 0.01, 3}, unheld);
            EXPECT_NEAR(out.peak_rotation_rad / plain, 1, 0.05) << share;
            EXPECT_LT(out.extra.peak_yaw_rad, 1e-4) << share;
        }
    }
}

// All but balanced over its edge at rest: nothing moves at first, yet it may not be held there.
TEST(SpatialHardCases, BalanceIsNoRest) {
    auto const block = standing(body_a(), {}, 0.8);
    auto const calm = constant(0, 1501);
    auto const out = shaken(block, {calm, calm}, {}, nullptr, wobbling(block, (1 - 1e-6) * body_a().alpha_rad(), 0));
    EXPECT_TRUE(out.verdict == Verdict::overturned || out.impacts > 0);
}

TEST(SpatialHardCases, RestCostsNothing) {
    auto const block = standing(body_a(), {}, 0.8);
    auto const wave = testing::sine(2.2, 1, 20, 0);
    auto const calm = constant(0, wave.size());
    auto const out = shaken(block, {wave, wave, 1e-3});
    EXPECT_EQ(out.verdict, Verdict::at_rest);
    EXPECT_EQ(out.steps, 0);
    EXPECT_EQ(out.peak_rotation_rad, 0);
    EXPECT_EQ(out.extra.yaw_rad, 0);
    EXPECT_EQ(shaken(block, {calm, calm, 1e-3}).steps, 0);
    EXPECT_EQ(shaken(block, {Shaking::nothing(), Shaking::nothing(), 1e-3}).verdict, Verdict::at_rest);
    EXPECT_GT(shaken(block, {wave, wave, 1e-3, 2}).steps, 0);
}

// One bad number anywhere.
TEST(SpatialHardCases, PoisonFails) {
    testing::TwoWaves waves;
    std::vector<double> up(waves.x.size(), 0.1);
    auto const block = standing(body_a(), round_base(), 0.8);
    for (auto* wave : {&waves.x, &waves.y, &up}) {
        for (double const bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            double const sound = (*wave)[1500];
            (*wave)[1500] = bad;
            auto const out = shaken(block, {waves.x, waves.y, 0.01, 5, up});
            EXPECT_EQ(out.verdict, Verdict::failed);
            EXPECT_EQ(out.failure, FailureReason::no_convergence);
            (*wave)[1500] = sound;
        }
    }
    EXPECT_NE(shaken(block, {waves.x, waves.y, 0.01, 5, up}).verdict, Verdict::failed);
}

}  // namespace
}  // namespace overturn
