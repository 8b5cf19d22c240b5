/// Distance of a body's mass from its centre: a check of its inertia.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "body/rigid_body.hpp"

namespace overturn {

/// Radius of gyration about the centre of gravity over R [-]; 1/sqrt(3) for a uniform block.
[[nodiscard]] inline double gyration_share(RigidBody const& body) {
    return std::sqrt(body.inertia_kgm2() / body.mass_kg()) / body.radius_m();
}

/// Less no body has.
inline constexpr double least_gyration_share = 0.2;
/// More is refused: a body of 1 m whose mass lies 100 m off turns so slowly that following it takes seconds.
inline constexpr double most_gyration_share = 100;

/// An inertia that no body has is what is wrong, not what follows from it. Empty where it is usual.
[[nodiscard]] inline std::string inertia_text(RigidBody const& body) {
    double const share = gyration_share(body);
    return share >= least_gyration_share
               ? ""
               : fmt::format(
                   "; so low because inertia {:.4g} kg m2 is a radius of gyration of {:.2g} R, "
                   "0.58 for a uniform block: check its unit",
                   body.inertia_kgm2(), share);
}

/// Why an inertia is refused. Empty where it is not.
[[nodiscard]] inline std::string gyration_excess(RigidBody const& body) {
    double const share = gyration_share(body);
    return share <= most_gyration_share
               ? ""
               : fmt::format(
                   "a radius of gyration of {:.3g} m, {:.3g} of R (no body's mass lies so far from its centre: "
                   "at most {:g}). Check its unit, or write \"uniform-block\"",
                   share * body.radius_m(), share, most_gyration_share);
}

}  // namespace overturn
