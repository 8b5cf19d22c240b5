// Requirement: the energy criterion's figures of a body are exact from the tiniest rotation to
// overturning.
#include "body/response_velocity.hpp"

#include <cmath>

#include "spectra/band_rule.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

RigidBody type_a() {
    return RigidBody({.mass_kg = 12.6e3, .half_width_m = 0.68, .centre_height_m = 1.045, .inertia_kgm2 = 6e3});
}

TEST(PeriodBand, IsInRootsOfTheStatedUnit) {
    auto const body = type_a();
    double const root = std::sqrt(body.radius_m());

    auto const usual = rocking_period_band(body.radius_m());
    EXPECT_TRUE(near(usual.t0_s, 0.5 * root, exact_formula));
    EXPECT_TRUE(near(usual.t1_s, 5 * root, exact_formula));

    auto const metres = rocking_period_band(body.radius_m(), RadiusUnit::metre);
    EXPECT_TRUE(near(metres.t0_s, 0.05 * root, exact_formula));
    EXPECT_TRUE(near(metres.t1_s, 0.5 * root, exact_formula));
}

TEST(PeriodBand, SpansHousnersPeriodsOfAWholeRangeOfAmplitudes) {
    // A uniform rectangle's period at theta0 = phi alpha is (4 / p) acosh(1 / (1 - phi)), Housner (1963).
    double const mass = 1;
    RigidBody const body(
        {.mass_kg = mass, .half_width_m = 0.3, .centre_height_m = 1.0, .inertia_kgm2 = mass * 1.09 / 3});
    auto const amplitude = [&](double period) { return 1 - 1 / std::cosh(period * body.p_radps() / 4); };

    auto const band = rocking_period_band(body.radius_m());

    EXPECT_NEAR(amplitude(band.t0_s), 0.055, 0.001);
    EXPECT_NEAR(amplitude(band.t1_s), 0.93, 0.005);
}

TEST(ResponseVelocity, IsTheLimitVelocityFromAlphaOn) {
    auto const body = type_a();
    for (double const ratio : {1.0, 1.5, 3.0}) {
        EXPECT_EQ(response_velocity(body, ratio * body.alpha_rad()), body.limit_velocity_mps());
    }
    double const just_below = std::nextafter(body.alpha_rad(), 0.0);
    EXPECT_TRUE(near(response_velocity(body, just_below), body.limit_velocity_mps(), exact_formula));
    EXPECT_LE(response_velocity(body, just_below), body.limit_velocity_mps());
}

TEST(ResponseVelocity, FollowsTheRiseOfTheCentreOfGravity) {
    auto const body = type_a();
    for (double const ratio : {0.1, 0.4, 0.9}) {
        double const theta = ratio * body.alpha_rad();
        double const rise = body.radius_m() * (std::cos(body.alpha_rad() - theta) - std::cos(body.alpha_rad()));
        EXPECT_TRUE(near(response_velocity(body, theta), std::sqrt(2 * g0 * rise), exact_formula));
        EXPECT_EQ(response_velocity(body, -theta), response_velocity(body, theta));
    }
}

TEST(ResponseVelocity, KeepsATinyRotationsDigits) {
    auto const body = type_a();
    for (double const theta : {1e-18, 1e-12, 1e-8}) {
        double const first_order = std::sqrt(2 * g0 * body.half_width_m() * theta);  // R sin alpha = b
        EXPECT_TRUE(near(response_velocity(body, theta), first_order, {1e-8, "first order in theta"}));
    }
    EXPECT_EQ(response_velocity(body, 0.0), 0.0);
}

}  // namespace
}  // namespace overturn
