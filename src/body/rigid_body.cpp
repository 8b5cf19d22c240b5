#include "body/rigid_body.hpp"

#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

double positive(double value, char const* what, char const* unit, char const* remedy) {
    validate(value > 0 && std::isfinite(value), "{} of {} {} (must be positive and finite). {}", what, value, unit,
             remedy);
    return value;
}

double checked_restitution(std::optional<double> const& stated, double housner) {
    if (!stated) {
        validate(housner >= 0,
                 "Housner's restitution is {:.4g} (the body is so squat that it would rebound at a base impact). State "
                 "a restitution from 0 to 1",
                 housner);
        return housner;
    }
    validate(*stated >= 0 && *stated <= 1,
             "restitution {} (must lie in 0 to 1: an impact never adds energy). State a ratio of angular velocities, "
             "or leave it to Housner's value",
             *stated);
    return *stated;
}

}  // namespace

RigidBody::RigidBody(BodyInput const& in)
    : mass_kg_(positive(in.mass_kg, "mass", "kg", "State the mass")),
      half_width_m_(positive(in.half_width_m, "half width", "m", "State the width of the base")),
      centre_height_m_(positive(in.centre_height_m, "centre height", "m",
                                "State the height of the centre of gravity above the base")),
      inertia_kgm2_(positive(in.inertia_kgm2, "moment of inertia", "kg m2",
                             "State the moment about the centre of gravity, or assemble the body from extended parts")),
      gravity_mps2_(positive(in.gravity_mps2, "gravity", "m/s2", "State the downward acceleration")),
      radius_m_(std::hypot(half_width_m_, centre_height_m_)),
      alpha_rad_(std::atan2(half_width_m_, centre_height_m_)),
      corner_inertia_kgm2_(inertia_kgm2_ + mass_kg_ * radius_m_ * radius_m_),
      p_radps_(std::sqrt(mass_kg_ * gravity_mps2_ * radius_m_ / corner_inertia_kgm2_)),
      inertia_ratio_(mass_kg_ * radius_m_ * radius_m_ / corner_inertia_kgm2_),
      housner_restitution_(1 - 2 * mass_kg_ * half_width_m_ * half_width_m_ / corner_inertia_kgm2_),
      restitution_(checked_restitution(in.restitution, housner_restitution_)),
      // R - h = b^2 / (R + h): the difference would lose a slender body's digits.
      limit_velocity_mps_(half_width_m_ * std::sqrt(2 * gravity_mps2_ / (radius_m_ + centre_height_m_))) {
    validate(alpha_rad_ > 0 && alpha_rad_ < pi / 2,
             "critical angle of {} rad (half width {} m and centre height {} m do not make a body that can rock). Mend "
             "the sizes",
             alpha_rad_, half_width_m_, centre_height_m_);
    validate(p_radps_ > 0 && std::isfinite(p_radps_) && limit_velocity_mps_ > 0 && std::isfinite(corner_inertia_kgm2_),
             "frequency parameter of {} rad/s (mass, sizes and inertia are too large or too small to compute with). "
             "Mend their units",
             p_radps_);
}

}  // namespace overturn
