/// How far a body's mass lies from its centre: what tells an inertia that no body has.
#pragma once

#include <cmath>

#include "body/rigid_body.hpp"

namespace overturn {

/// Radius of gyration about the centre of gravity over R [-]; 1/sqrt(3) for a uniform block.
[[nodiscard]] inline double gyration_share(RigidBody const& body) {
    return std::sqrt(body.inertia_kgm2() / body.mass_kg()) / body.radius_m();
}

/// Less no body has.
inline constexpr double least_gyration_share = 0.2;

}  // namespace overturn
