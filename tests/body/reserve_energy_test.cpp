// Requirement R-705: capacities by hand are what their energy balance says.
#include "body/reserve_energy.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace overturn {
namespace {

RigidBody block(double half_width, double height, std::optional<double> restitution = {}) {
    double const mass = 12000;
    return RigidBody({.mass_kg = mass,
                      .half_width_m = half_width,
                      .centre_height_m = height,
                      .inertia_kgm2 = mass * (half_width * half_width + height * height) / 3,
                      .restitution = restitution});
}

/// The oscillator of that frequency, with the body's inertia about its corner, stores at the rotation what lifts the
/// centre of gravity; at alpha that is the energy of the limit velocity, m V_Ereq^2 / 2.
TEST(ReserveEnergy, StoresWhatLiftsTheCentre) {
    auto const body = block(0.45, 1.045);
    for (double const share : {1e-3, 0.3, 0.7, 1.0}) {
        auto const at = rocking_capacity(body, share * body.alpha_rad());
        double const omega = 2 * std::numbers::pi * at.frequency_hz;
        double const stored = 0.5 * body.corner_inertia_kgm2() * std::pow(omega * at.rotation_rad, 2);
        double const lifted = body.mass_kg() * g0 * body.radius_m()
                              * (std::cos(body.alpha_rad() - at.rotation_rad) - std::cos(body.alpha_rad()));
        EXPECT_NEAR(stored / lifted, 1, 1e-9) << share;
        double const inertia = body.corner_inertia_kgm2() / (body.mass_kg() * std::pow(body.centre_height_m(), 2));
        EXPECT_NEAR(at.spectral_mps2, omega * omega * inertia * body.centre_height_m() * at.rotation_rad, 1e-9);
        if (share == 1.0) {
            EXPECT_NEAR(lifted, 0.5 * body.mass_kg() * std::pow(body.limit_velocity_mps(), 2), 1e-6);
        }
    }
}

/// Small rotations ask for twice the static acceleration of uplift, at any frequency; larger ones for less, more
/// slowly.
TEST(ReserveEnergy, FallsFromTwiceTheUpliftAcceleration) {
    auto const body = block(0.45, 1.045);
    EXPECT_NEAR(rocking_capacity(body, 1e-7).spectral_mps2, 2 * body.uplift_acceleration_mps2(), 1e-5);
    auto const small = rocking_capacity(body, 0.2 * body.alpha_rad());
    auto const large = rocking_capacity(body, 0.9 * body.alpha_rad());
    EXPECT_GT(small.spectral_mps2, large.spectral_mps2);
    EXPECT_GT(small.frequency_hz, large.frequency_hz);
}

/// Two impacts a cycle leave e^4 of its energy; a viscous oscillator exp(-4 pi beta / sqrt(1 - beta^2)).
TEST(ReserveEnergy, DampingIsTheLossOfTwoImpacts) {
    for (double const e : {0.6, 0.8, 0.95}) {
        double const beta = rocking_capacity(block(0.45, 1.045, e), 0.1).damping;
        EXPECT_NEAR(std::exp(-4 * std::numbers::pi * beta / std::sqrt(1 - beta * beta)), std::pow(e, 4), 1e-12) << e;
    }
    EXPECT_EQ(rocking_capacity(block(0.45, 1.045, 0.0), 0.1).damping, 1);
}

/// Friction spends over the distance what the oscillator stores there.
TEST(ReserveEnergy, SlidingSpendsWhatIsStored) {
    double const capacity = sliding_capacity_mps2(0.5);
    // Published: mu_e = mu (1 - 0.4 A_v / g). At 0.25 g of vertical motion a tenth of the grip is gone.
    EXPECT_DOUBLE_EQ(sliding_capacity_mps2(0.5, 0.25 * g0), 0.9 * capacity);
    EXPECT_EQ(sliding_capacity_mps2(0.5, 3 * g0), 0) << "it does not hold at all";
    double const x = sliding_distance_m(capacity, 0.7);
    double const omega = 2 * std::numbers::pi * 0.7;
    EXPECT_NEAR(0.5 * g0 * x, 0.5 * omega * omega * x * x, 1e-12);
}

}  // namespace
}  // namespace overturn
