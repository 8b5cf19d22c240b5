#include "body/reserve_energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

RockingCapacity rocking_capacity(RigidBody const& body, double rotation_rad) {
    [[maybe_unused]] constexpr double rounding = 1e-12;  // a promise is checked in some builds alone
    OVERTURN_EXPECT(rotation_rad > 0 && rotation_rad <= body.alpha_rad() * (1 + rounding));
    // On a slope, or off the middle: as the weaker corner has them, from the vertical.
    double const h = body.lopsided() ? body.radius_m() * std::cos(body.alpha_rad()) : body.centre_height_m();
    double const a = body.lopsided() ? std::tan(body.alpha_rad()) : body.half_width_m() / h;
    double const g = body.gravity_mps2();
    // cos theta - 1 without its cancellation at small rotations.
    double const half = std::sin(rotation_rad / 2);
    double const rise = a * std::sin(rotation_rad) - 2 * half * half;
    double const inertia = body.corner_inertia_kgm2() / (body.mass_kg() * h * h);
    double const gamma = -2 * std::log(body.restitution());
    return {rotation_rad, 2 * g * rise / rotation_rad,
            std::sqrt(2 * rise * g / (inertia * rotation_rad * rotation_rad * h)) / two_pi,
            std::isfinite(gamma) ? gamma / std::hypot(two_pi, gamma) : 1};
}

double sliding_capacity_mps2(double friction, double vertical_mps2, double gravity_mps2) {
    OVERTURN_EXPECT(friction > 0);
    constexpr double at_once = 0.4;  // of the vertical peak, with the horizontal one
    return std::max(0.0, 2 * friction * (gravity_mps2 - at_once * vertical_mps2));
}

double sliding_distance_m(double capacity_mps2, double frequency_hz) {
    return capacity_mps2 / std::pow(two_pi * frequency_hz, 2);
}

}  // namespace overturn
