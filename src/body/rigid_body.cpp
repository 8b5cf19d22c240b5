#include "body/rigid_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

double positive(double value, char const* what, char const* unit, char const* remedy) {
    validate(value > 0 && std::isfinite(value), "{} of {} {} (must be positive and finite). {}", what, value, unit,
             remedy);
    return value;
}

double checked_restitution(BodyInput const& in, double housner) {
    auto const& stated = in.restitution;
    if (!stated) {
        validate(housner >= 0,
                 "Housner's restitution is {:.4g} (half width {:.4g} m, centre height {:.4g} m: so squat that the body "
                 "would rebound at a base impact). State a restitution from 0 to 1, or mend the sizes",
                 housner, in.half_width_m, in.centre_height_m);
        return housner;
    }
    validate(*stated >= 0 && *stated <= 1,
             "restitution {} (must lie in 0 to 1: an impact never adds energy). State a ratio of angular velocities, "
             "or leave it to Housner's value",
             *stated);
    return *stated;
}

constexpr double degree = pi / 180;

// Housner's: I_O' omega' is the angular momentum about the new corner, I_G + m (h^2 - b b') times omega.
Corner corner_of(BodyInput const& in, double side) {
    Corner c;
    double const m = in.mass_kg;
    double const h = in.centre_height_m;
    double const b = in.half_width_m - side * in.offset_m;
    double const other = in.half_width_m + side * in.offset_m;
    c.half_width_m = b;
    c.radius_m = std::hypot(b, h);
    c.base_angle_rad = std::atan2(b, h);
    c.alpha_rad = c.base_angle_rad - side * in.slope_rad;
    c.corner_inertia_kgm2 = in.inertia_kgm2 + m * c.radius_m * c.radius_m;
    c.p_radps = std::sqrt(m * in.gravity_mps2 * c.radius_m / c.corner_inertia_kgm2);
    c.inertia_ratio = m * c.radius_m * c.radius_m / c.corner_inertia_kgm2;
    double const landing = in.inertia_kgm2 + m * (other * other + h * h);
    c.housner_restitution = 1 - m * other * (b + other) / landing;
    c.limit_velocity_mps = 2 * std::sqrt(in.gravity_mps2 * c.radius_m) * std::sin(0.5 * c.alpha_rad);
    return c;
}

void check_corner(Corner const& c, Corner const& landing, BodyInput const& in) {
    validate(c.alpha_rad > 0,
             "slope of {:.6g} deg (the body tips over its lower edge by itself from {:.6g} deg on). Lower it",
             in.slope_rad / degree, c.base_angle_rad / degree);
    validate(c.alpha_rad < pi / 2 && std::abs(in.slope_rad) < pi / 4,
             "slope of {:.6g} deg (beyond 45 deg, or such that a corner never tips). Lower it", in.slope_rad / degree);
    validate(c.restitution * c.restitution * landing.corner_inertia_kgm2 <= c.corner_inertia_kgm2,
             "restitution {:.6g} (an impact from the corner at {:.6g} m onto the one at {:.6g} m would add energy: at "
             "most {:.6g}). Lower it, or leave it to Housner's value",
             c.restitution, c.half_width_m, landing.half_width_m,
             std::sqrt(c.corner_inertia_kgm2 / landing.corner_inertia_kgm2));
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
      restitution_(checked_restitution(in, housner_restitution_)),
      // R - h = b^2 / (R + h): the difference would lose a slender body's digits.
      limit_velocity_mps_(half_width_m_ * std::sqrt(2 * gravity_mps2_ / (radius_m_ + centre_height_m_))),
      uplift_acceleration_mps2_(gravity_mps2_ * half_width_m_ / centre_height_m_),
      offset_m_(in.offset_m),
      slope_rad_(in.slope_rad),
      initial_tilt_rad_(in.initial_tilt_rad) {
    validate(alpha_rad_ > 0 && alpha_rad_ < pi / 2,
             "critical angle of {} rad (half width {} m and centre height {} m do not make a body that can rock). Mend "
             "the sizes",
             alpha_rad_, half_width_m_, centre_height_m_);
    validate(p_radps_ > 0 && std::isfinite(p_radps_) && limit_velocity_mps_ > 0 && std::isfinite(corner_inertia_kgm2_),
             "frequency parameter of {} rad/s (mass, sizes and inertia are too large or too small to compute with). "
             "Mend their units",
             p_radps_);
    corners_.fill({half_width_m_, radius_m_, alpha_rad_, alpha_rad_, corner_inertia_kgm2_, p_radps_, inertia_ratio_,
                   housner_restitution_, restitution_, limit_velocity_mps_});
    if (lopsided()) {
        stand_on_two_corners(in);
    }
    double const falls = corner(initial_tilt_rad_).alpha_rad;
    validate(std::abs(initial_tilt_rad_) < falls,
             "initial tilt of {:.6g} deg (from {:.6g} deg on it falls by itself). Lower it", initial_tilt_rad_ / degree,
             falls / degree);
}

void RigidBody::stand_on_two_corners(BodyInput const& in) {
    validate(std::isfinite(offset_m_) && std::isfinite(slope_rad_), "offset {} m or slope {} rad (not finite). Mend it",
             offset_m_, slope_rad_);
    corners_ = {corner_of(in, 1), corner_of(in, -1)};
    for (auto& c : corners_) {
        validate(c.half_width_m > 0,
                 "offset of {:.6g} m (the centre of gravity would not lie over a base of half width {:.6g} m: it falls "
                 "by itself). Lower it",
                 offset_m_, half_width_m_);
        c.restitution = checked_restitution(in, c.housner_restitution);
    }
    check_corner(corners_[0], corners_[1], in);
    check_corner(corners_[1], corners_[0], in);
    weaker_side_ = corners_[1].limit_velocity_mps < corners_[0].limit_velocity_mps ? -1 : 1;
    auto const& weaker = corner(weaker_side_);
    radius_m_ = weaker.radius_m;
    alpha_rad_ = weaker.alpha_rad;
    corner_inertia_kgm2_ = weaker.corner_inertia_kgm2;
    p_radps_ = weaker.p_radps;
    inertia_ratio_ = weaker.inertia_ratio;
    housner_restitution_ = weaker.housner_restitution;
    restitution_ = weaker.restitution;
    limit_velocity_mps_ = weaker.limit_velocity_mps;
    uplift_acceleration_mps2_ =
        gravity_mps2_ * std::min(std::tan(corners_[0].alpha_rad), std::tan(corners_[1].alpha_rad));
}

}  // namespace overturn
