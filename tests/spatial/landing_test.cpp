// Requirement R-607: a body that falls from balance lands with the energy of its height, on points and on a rim, in the
// plane and in space; where its base and its top go is told with signs.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::constant;
using testing::round_base;
using testing::shaken;
using testing::square_base;
using testing::standing;
using testing::unheld;

/// From balance over the edge to the side: I_O w^2 / 2 = m g (R - b). What compliance stores and a little start add is
/// below a hundredth.
struct Landing {
    double spin, velocity, top, energy;
    explicit Landing(RigidBody const& body) {
        double const b = body.half_width_m();
        double const h = body.centre_height_m();
        energy = body.gravity_mps2() * (body.radius_m() - b);
        spin = std::sqrt(2 * energy / (body.inertia_kgm2() / body.mass_kg() + b * b + h * h));
        velocity = spin * body.radius_m();
        top = spin * std::hypot(b, 2 * h);
    }
};
constexpr double compliant = 0.01;

void expect_landing(Outcome const& out, Landing const& expected) {
    ASSERT_EQ(out.verdict, Verdict::overturned);
    EXPECT_NEAR(out.landing_spin_radps / expected.spin, 1, compliant);
    EXPECT_NEAR(out.landing_velocity_mps / expected.velocity, 1, compliant);
    EXPECT_NEAR(out.landing_top_mps / expected.top, 1, compliant);
    EXPECT_NEAR(out.landing_energy_jpkg / expected.energy, 1, compliant);
}

TEST(Landing, FromBalanceInSpace) {
    auto const calm = constant(0, 1001);
    for (auto const& body : {body_a(), body_b()}) {
        for (auto const& footing : {square_base(), round_base()}) {
            for (double const azimuth : {0.0, pi / 2, pi, -pi / 2}) {
                auto const block = standing(body, footing, firm_grip);
                double const tilt = 1.002 * body.alpha_rad();
                double const b = block.edge_m;
                double const h = block.planar.centre_height_m;
                auto const out =
                    shaken(block, {calm, calm}, unheld, nullptr,
                           SpatialStart{.rise_m = b * std::sin(tilt) - h * (1 - std::cos(tilt)),
                                        .rotation_rad = {-tilt * std::sin(azimuth), tilt * std::cos(azimuth), 0}});
                expect_landing(out, Landing(body));
                EXPECT_NEAR(std::remainder(out.extra.landing_azimuth_rad - azimuth, 2 * pi), 0, 1e-9) << azimuth;
            }
        }
    }
}

// a body that rocks back from a corner and lands a little aside of upright has landed, as fast as one that does
// not, whatever the step: its tilt passes by zero, not through it.
TEST(Landing, AsideOfUprightCountsWhateverTheStep) {
    auto const calm = constant(0, 301);
    auto const block = standing(body_a(), square_base(), firm_grip);
    double const tilt = 0.3 * body_a().alpha_rad();
    auto const landed = [&](double aside, double step) {
        ContactAccuracy accuracy = unheld;
        accuracy.step_ratio = step;
        double const azimuth = pi / 4 + aside;
        return shaken(block, {calm, calm, 0.002}, accuracy, nullptr,
                      SpatialStart{.rise_m = block.reach_m * std::sin(tilt),
                                   .rotation_rad = {-tilt * std::sin(azimuth), tilt * std::cos(azimuth), 0}});
    };
    for (double const aside : {0.0, 0.005, 0.01}) {
        auto const fine = landed(aside, 0.03);
        EXPECT_EQ(fine.impacts, 1) << aside;
        for (auto const& [step, error] : {std::pair{0.3, 0.1}, {0.1, 0.01}}) {
            auto const out = landed(aside, step);
            EXPECT_EQ(out.impacts, 1) << aside << " " << step;
            EXPECT_NEAR(out.peak_impact_velocity_mps / fine.peak_impact_velocity_mps, 1, error) << aside << " " << step;
        }
    }
}

TEST(Landing, FromBalanceInThePlane) {
    auto const calm = constant(0, 1001);
    for (auto const& body : {body_a(), body_b()}) {
        auto const block = testing::on_corners(body, firm_grip);
        for (double const side : {1.0, -1.0}) {
            auto start = leaning_start(block, side * 0.998 * body.alpha_rad());
            start.velocity_radps = side * 0.1;
            auto const out =
                simulate_contact(block, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = 0.01},
                                 {.rest_gate = false}, start);
            expect_landing(out, Landing(body));
        }
    }
}

TEST(Landing, WhatStandsDoesNotLand) {
    auto const pulse = testing::sine(5, 1, 1, 0.5, 0.01);
    auto const out = shaken(standing(body_a(), round_base(), 0.8), {pulse, pulse});
    EXPECT_NE(out.verdict, Verdict::overturned);
    EXPECT_EQ(out.landing_spin_radps, 0);
    EXPECT_EQ(out.landing_energy_jpkg, 0);
    EXPECT_TRUE(std::isnan(out.extra.landing_azimuth_rad));
}

// Pushed one way only, a base slides the other way; its circle reaches that much farther, and its top goes along.
TEST(WhereTheBaseGoes, HasASign) {
    std::vector<double> x = constant(4, 101);
    std::vector<double> y = constant(-3, 101);
    for (auto* wave : {&x, &y}) {
        wave->resize(201, 0.0);
    }
    for (auto const& footing : {round_base(), square_base()}) {
        auto const block = standing(body_a(), footing, 0.3);
        testing::SpatialHistory history;
        auto const out = shaken(block, {x, y}, unheld, &history);
        double least = 0;
        double most = 0;
        double top = 0;
        for (auto const& instant : history.instants) {
            least = std::min(least, instant.x_m);
            most = std::max(most, instant.y_m);
            auto const m = testing::matrix_of(instant);
            double const h2 = 2 * block.planar.centre_height_m;
            top = std::max(top, std::hypot(instant.x_m + h2 * m[0][2], instant.y_m + h2 * m[1][2]));
        }
        EXPECT_LT(out.extra.residual_x_m, -0.5);
        EXPECT_NEAR(out.extra.residual_y_m / out.extra.residual_x_m, -0.75, 1e-6);
        EXPECT_NEAR(out.extra.edge_x_least_m, least - block.reach_m, 1e-3);
        EXPECT_NEAR(out.extra.edge_y_most_m, most + block.reach_m, 1e-3);
        EXPECT_NEAR(out.extra.edge_x_most_m, block.reach_m, 1e-3);
        EXPECT_NEAR(out.extra.edge_y_least_m, -block.reach_m, 1e-3);
        EXPECT_NEAR(out.extra.peak_top_m, top, 1e-3);
    }
}

}  // namespace
}  // namespace overturn
