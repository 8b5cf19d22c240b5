/// The rigid body that may overturn: what is stated about it, and what the equations of rocking need.
#pragma once

#include <optional>

#include "core/units.hpp"

namespace overturn {

/// What the user states about a body, in the rocking plane. Plain data; says nothing about validity.
struct BodyInput {
    double mass_kg = 0;                      ///< m [kg]
    double half_width_m = 0;                 ///< b, from the axis to the corner of the base [m]
    double centre_height_m = 0;              ///< h, of the centre of gravity above the base [m]
    double inertia_kgm2 = 0;                 ///< I_G, about the horizontal axis through the centre of gravity [kg m2]
    std::optional<double> restitution = {};  ///< e = omega after / before a base impact [-]; empty: Housner's
    double gravity_mps2 = g0;                ///< g [m/s2]
};

/// What the equations need. Immutable and valid once constructed; symmetric about its axis.
///   R      distance from corner to centre of gravity  sqrt(b^2 + h^2)   (the paper's a)
///   alpha  critical angle                             atan(b / h)       (the paper's alpha is its complement)
///   I_O    inertia about the corner                   I_G + m R^2
///   p      frequency parameter                        sqrt(m g R / I_O)   Housner (1963)
class RigidBody {
  public:
    /// \throws InputError unless mass, sizes, inertia and gravity are positive and finite, alpha lies in (0, 90) deg
    /// and the restitution, stated or Housner's, lies in [0, 1].
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
    /// paper's Eq. 4.
    [[nodiscard]] double limit_velocity_mps() const { return limit_velocity_mps_; }

    /// Horizontal acceleration above which the resting body uplifts, g tan alpha [m/s2].
    [[nodiscard]] double uplift_acceleration_mps2() const { return gravity_mps2_ * half_width_m_ / centre_height_m_; }

  private:
    double mass_kg_, half_width_m_, centre_height_m_, inertia_kgm2_, gravity_mps2_;
    double radius_m_, alpha_rad_, corner_inertia_kgm2_, p_radps_, inertia_ratio_;
    double housner_restitution_, restitution_, limit_velocity_mps_;
};

}  // namespace overturn
