#include "body/response_velocity.hpp"

#include <algorithm>
#include <cmath>

namespace overturn {

double response_velocity(RigidBody const& body, double peak_rotation_rad, double side) {
    double const theta = std::abs(peak_rotation_rad);
    auto const& corner = body.corner(side);
    double const alpha = corner.alpha_rad;
    if (theta >= alpha) {
        return corner.limit_velocity_mps;
    }
    // cos(alpha - theta) - cos alpha as a product: the difference would lose a tiny theta's digits.
    double const lift = 2 * std::sin(alpha - theta / 2) * std::sin(theta / 2);
    return std::min(std::sqrt(2 * body.gravity_mps2() * corner.radius_m * lift), corner.limit_velocity_mps);
}

}  // namespace overturn
