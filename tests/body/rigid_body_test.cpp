// Requirement: a body's derived figures follow the closed forms, and a body that cannot rock is refused.
#include "body/rigid_body.hpp"

#include <cmath>
#include <limits>

#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;
using testing::rounding;

BodyInput rectangle(double half_width_m, double half_height_m) {
    double const mass = 1000;
    return {.mass_kg = mass,
            .half_width_m = half_width_m,
            .centre_height_m = half_height_m,
            .inertia_kgm2 = mass * (half_width_m * half_width_m + half_height_m * half_height_m) / 3};
}

TEST(RigidBody, UniformRectangleHasHousnersClosedForms) {
    for (auto const& [b, h] : {std::pair{0.2, 0.8}, {0.68, 1.045}, {1.0, 1.0}, {0.01, 3.0}}) {
        RigidBody const body(rectangle(b, h));
        double const sine = std::sin(body.alpha_rad());

        EXPECT_TRUE(near(body.radius_m(), std::sqrt(b * b + h * h), rounding));
        EXPECT_TRUE(near(std::tan(body.alpha_rad()), b / h, exact_formula));
        EXPECT_TRUE(near(body.p_radps() * body.p_radps(), 3 * g0 / (4 * body.radius_m()), exact_formula));
        EXPECT_TRUE(near(body.housner_restitution(), 1 - 1.5 * sine * sine, exact_formula));
        EXPECT_TRUE(near(body.inertia_ratio(), 0.75, exact_formula));
        EXPECT_TRUE(near(body.corner_inertia_kgm2(), 4 * body.inertia_kgm2(), exact_formula));
        EXPECT_EQ(body.restitution(), body.housner_restitution());
    }
}

TEST(RigidBody, PrototypeAndTypeAHaveTheirKnownFigures) {
    RigidBody const prototype(
        {.mass_kg = 138e3, .half_width_m = 1.7, .centre_height_m = 2.61, .inertia_kgm2 = 4e5, .restitution = 0.8});
    EXPECT_NEAR(prototype.alpha_rad() * 180 / pi, 33.1, 0.05);
    EXPECT_NEAR(prototype.limit_velocity_mps(), 3.15, 0.005);

    RigidBody const type_a(
        {.mass_kg = 12.6e3, .half_width_m = 0.68, .centre_height_m = 1.045, .inertia_kgm2 = 6e3, .restitution = 0.8});
    EXPECT_NEAR(type_a.limit_velocity_mps(), 1.99, 0.005);
    EXPECT_NEAR(type_a.uplift_acceleration_mps2(), 6.38, 0.005);
    EXPECT_EQ(type_a.restitution(), 0.8);
}

TEST(RigidBody, LimitVelocityKeepsASlenderBodysDigits) {
    RigidBody const needle(rectangle(1e-9, 1.0));  // R - h rounds to 0, but is b^2 / 2h

    EXPECT_TRUE(near(needle.limit_velocity_mps(), 1e-9 * std::sqrt(g0), exact_formula));
}

TEST(RigidBody, GravityIsTheStatedOne) {
    auto moon = rectangle(0.2, 0.8);
    moon.gravity_mps2 = 1.62;

    EXPECT_TRUE(near(std::pow(RigidBody(moon).p_radps() / RigidBody(rectangle(0.2, 0.8)).p_radps(), 2), 1.62 / g0,
                     exact_formula));
}

TEST(RigidBody, SquatBodyNeedsAStatedRestitution) {
    auto squat = rectangle(2.0, 1.0);  // alpha = 63 deg, e_H = -0.2
    expect_input_error([&] { (void)RigidBody(squat); }, "Housner's restitution is -0.2", "State a restitution");

    squat.restitution = 0.1;
    EXPECT_EQ(RigidBody(squat).restitution(), 0.1);
    EXPECT_TRUE(near(RigidBody(squat).housner_restitution(), -0.2, exact_formula));
}

TEST(RigidBody, RestitutionOutsideZeroToOneIsRefused) {
    for (double const wrong : {-0.01, 1.01, std::nan("")}) {
        auto body = rectangle(0.2, 0.8);
        body.restitution = wrong;
        expect_input_error([&] { (void)RigidBody(body); }, "restitution", "0 to 1");
    }
    for (double const right : {0.0, 1.0}) {
        auto body = rectangle(0.2, 0.8);
        body.restitution = right;
        EXPECT_EQ(RigidBody(body).restitution(), right);
    }
}

TEST(RigidBody, FiguresThatMakeNoBodyAreRefusedByName) {
    for (double const wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (auto const& [member, name] : {std::pair{&BodyInput::mass_kg, "mass"},
                                           {&BodyInput::half_width_m, "half width"},
                                           {&BodyInput::centre_height_m, "centre height"},
                                           {&BodyInput::inertia_kgm2, "moment of inertia"},
                                           {&BodyInput::gravity_mps2, "gravity"}}) {
            auto body = rectangle(0.2, 0.8);
            body.*member = wrong;
            expect_input_error([&] { (void)RigidBody(body); }, name, "must be positive and finite");
        }
    }
    expect_input_error([] { (void)RigidBody(rectangle(1e-200, 1e200)); }, "moment of inertia of inf");
    expect_input_error(
        [] {
            (void)RigidBody(
                {.mass_kg = 1, .half_width_m = 1e20, .centre_height_m = 1, .inertia_kgm2 = 1, .restitution = 0.5});
        },
        "critical angle");
}

// with the centre of gravity off the middle and inclined ground each corner has closed forms of its own,
// and the body's are those of the weaker side.
TEST(RigidBody, CornersThatDifferHaveTheirOwnClosedForms) {
    for (auto const& [offset, slope] : {std::pair{0.1, 0.0}, {-0.1, 0.0}, {0.0, 0.02}, {0.05, -0.03}}) {
        auto in = rectangle(0.68, 1.045);
        in.offset_m = offset;
        in.slope_rad = slope;
        RigidBody const body(in);
        double const m = in.mass_kg;
        for (double const side : {1.0, -1.0}) {
            auto const& c = body.corner(side);
            double const b = 0.68 - side * offset;
            double const other = 0.68 + side * offset;
            double const landing = in.inertia_kgm2 + m * (other * other + 1.045 * 1.045);
            // Angular momentum about the corner that is struck: spin and path of the centre of gravity.
            double const momentum = in.inertia_kgm2 + m * (1.045 * 1.045 - b * other);

            EXPECT_TRUE(near(c.alpha_rad, std::atan(b / 1.045) - side * slope, exact_formula));
            EXPECT_TRUE(near(c.restitution, momentum / landing, exact_formula));
            EXPECT_TRUE(
                near(c.p_radps * c.p_radps, m * g0 * std::hypot(b, 1.045) / c.corner_inertia_kgm2, exact_formula));
            EXPECT_TRUE(near(c.limit_velocity_mps * c.limit_velocity_mps,
                             2 * g0 * std::hypot(b, 1.045) * (1 - std::cos(c.alpha_rad)), exact_formula));
        }
        auto const& weaker = body.corner(body.weaker_side());
        EXPECT_EQ(body.weaker_side(), offset > 0 || slope > 0 ? 1 : -1);
        EXPECT_LT(weaker.limit_velocity_mps, body.corner(-body.weaker_side()).limit_velocity_mps);
        EXPECT_EQ(body.limit_velocity_mps(), weaker.limit_velocity_mps);
        EXPECT_EQ(body.alpha_rad(), weaker.alpha_rad);
        EXPECT_TRUE(near(body.uplift_acceleration_mps2(), g0 * std::tan(weaker.alpha_rad), exact_formula));
    }
}

//
TEST(RigidBody, WhatFallsByItselfOrGainsEnergyIsRefused) {
    auto const with = [](double BodyInput::*what, double value) {
        auto in = rectangle(0.2, 0.8);
        in.*what = value;
        return in;
    };
    expect_input_error([&] { (void)RigidBody(with(&BodyInput::offset_m, 0.2)); }, "offset of 0.2 m", "falls by itself");
    expect_input_error([&] { (void)RigidBody(with(&BodyInput::slope_rad, -0.25)); }, "slope of", "tips over its lower");
    expect_input_error([&] { (void)RigidBody(with(&BodyInput::initial_tilt_rad, 0.245)); }, "initial tilt of",
                       "falls by itself");
    EXPECT_EQ(RigidBody(with(&BodyInput::initial_tilt_rad, -0.244)).initial_tilt_rad(), -0.244);
    auto leaning = with(&BodyInput::offset_m, 0.05);
    leaning.restitution = 0.999;
    expect_input_error([&] { (void)RigidBody(leaning); }, "restitution 0.999", "would add energy");
}

}  // namespace
}  // namespace overturn
