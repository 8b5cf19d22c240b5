/// The rigid body that may overturn: what is stated about it, and what the equations of rocking need.
#pragma once

#include <array>
#include <optional>

#include "core/units.hpp"

namespace overturn {

/// The body as the user states it, in the rocking plane. Plain data, not validated.
struct BodyInput {
    double mass_kg = 0;                      ///< m [kg]
    double half_width_m = 0;                 ///< b, from the axis to the corner of the base [m]
    double centre_height_m = 0;              ///< h, of the centre of gravity above the base [m]
    double inertia_kgm2 = 0;                 ///< I_G, about the horizontal axis through the centre of gravity [kg m2]
    std::optional<double> restitution = {};  ///< e = omega after / before a base impact [-]; empty: Housner's
    double gravity_mps2 = g0;                ///< g [m/s2]
    double offset_m = 0;          ///< d: the centre of gravity lies that far from the base's middle, towards +x [m]
    double slope_rad = 0;         ///< beta: the ground falls towards +x by this angle, and the base lies on it [rad]
    double initial_tilt_rad = 0;  ///< rotation at t = 0, let go there; positive towards +x [rad]
};

/// One of the two edges that a body may tip over, in the rocking plane.
struct Corner {
    double half_width_m = 0;         ///< from under the centre of gravity, along the base: b -/+ d [m]
    double radius_m = 0;             ///< R, to the centre of gravity [m]
    double base_angle_rad = 0;       ///< atan of half width over centre height [rad]
    double alpha_rad = 0;            ///< the tilt at which it falls by itself: base angle -/+ slope [rad]
    double corner_inertia_kgm2 = 0;  ///< I_O [kg m2]
    double p_radps = 0;              ///< [rad/s]
    double inertia_ratio = 0;        ///< m R^2 / I_O [-]
    double housner_restitution = 0;  ///< of the impact that leaves this corner for the other one [-]
    double restitution = 0;          ///< the one in force there [-]
    double limit_velocity_mps = 0;   ///< sqrt(2 g R (1 - cos alpha)) [m/s]
};

/// The body's constants in the equations. Immutable and valid once constructed. Symmetric about its axis unless an
/// offset or a slope is stated. Then its two corners differ, and R, alpha, I_O, p, e and V_Ereq are those of the weaker
/// corner: the one over which less energy tips the body.
///   R      distance from corner to centre of gravity  sqrt(b^2 + h^2)   (the paper's a)
///   alpha  critical angle                             atan(b / h)       (the paper's alpha is its complement)
///   I_O    inertia about the corner                   I_G + m R^2
///   p      frequency parameter                        sqrt(m g R / I_O)   Housner (1963)
class RigidBody {
  public:
    /// \throws InputError unless mass, sizes, inertia and gravity are positive and finite, alpha lies in (0, 90) deg
    /// at both corners, the restitution, stated or Housner's, lies in [0, 1] and adds no energy at either corner, and
    /// the initial tilt is below alpha.
    explicit RigidBody(BodyInput const& in);

    [[nodiscard]] double mass_kg() const { return mass_kg_; }                  ///< m [kg]
    [[nodiscard]] double half_width_m() const { return half_width_m_; }        ///< b [m]
    [[nodiscard]] double centre_height_m() const { return centre_height_m_; }  ///< h [m]
    [[nodiscard]] double inertia_kgm2() const { return inertia_kgm2_; }        ///< I_G [kg m2]
    [[nodiscard]] double gravity_mps2() const { return gravity_mps2_; }        ///< g [m/s2]
    [[nodiscard]] double restitution() const { return restitution_; }          ///< e, the one in force [-]

    [[nodiscard]] double radius_m() const { return radius_m_; }                        ///< R [m]
    [[nodiscard]] double alpha_rad() const { return alpha_rad_; }                      ///< alpha [rad]
    [[nodiscard]] double corner_inertia_kgm2() const { return corner_inertia_kgm2_; }  ///< I_O [kg m2]
    [[nodiscard]] double p_radps() const { return p_radps_; }                          ///< p [rad/s]
    [[nodiscard]] double inertia_ratio() const { return inertia_ratio_; }              ///< m R^2 / I_O [-]

    /// e_H = 1 - 2 m b^2 / I_O: angular momentum about the new corner is kept [-]. Housner (1963), for a general body;
    /// his printed r is e_H^2. Negative for a squat body, which would rebound.
    [[nodiscard]] double housner_restitution() const { return housner_restitution_; }

    /// V_Ereq = sqrt(2 g (R - h)): the velocity whose energy lifts the centre of gravity over the corner [m/s]. The
    /// paper's Eq. 4. On a slope sqrt(2 g R (1 - cos alpha)); of two corners the lower: that of the weaker side.
    [[nodiscard]] double limit_velocity_mps() const { return limit_velocity_mps_; }

    /// Horizontal acceleration above which the resting body uplifts, g tan alpha, at the corner that needs less [m/s2].
    [[nodiscard]] double uplift_acceleration_mps2() const { return uplift_acceleration_mps2_; }

    /// Whether its two corners differ: an offset or a slope is stated.
    [[nodiscard]] bool lopsided() const { return offset_m_ != 0 || slope_rad_ != 0; }
    /// Whether anything of offset, slope and initial tilt is stated.
    [[nodiscard]] bool needs_planar_rocking() const { return lopsided() || initial_tilt_rad_ != 0; }
    /// The corner that it stands on when it rotates to that side. \param side its sign counts: + towards +x
    [[nodiscard]] Corner const& corner(double side) const { return corners_[side < 0 ? 1 : 0]; }
    [[nodiscard]] double weaker_side() const { return weaker_side_; }  ///< +1 or -1
    [[nodiscard]] double offset_m() const { return offset_m_; }        ///< d [m]
    [[nodiscard]] double slope_rad() const { return slope_rad_; }      ///< beta [rad]
    [[nodiscard]] double initial_tilt_rad() const { return initial_tilt_rad_; }

  private:
    void stand_on_two_corners(BodyInput const& in);

    double mass_kg_, half_width_m_, centre_height_m_, inertia_kgm2_, gravity_mps2_;
    double radius_m_, alpha_rad_, corner_inertia_kgm2_, p_radps_, inertia_ratio_;
    double housner_restitution_, restitution_, limit_velocity_mps_, uplift_acceleration_mps2_;
    double offset_m_, slope_rad_, initial_tilt_rad_, weaker_side_ = 1;
    std::array<Corner, 2> corners_{};  ///< at +x and at -x
};

}  // namespace overturn
