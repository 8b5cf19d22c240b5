/// What the energy criterion asks of a body: the periods at which it takes up energy, and the velocity of its response.
#pragma once

#include "body/rigid_body.hpp"

namespace overturn {

/// The unit of R in the period band. The paper prints none; only centimetres make the band span the rocking periods of
/// amplitudes 0.055 to 0.93 of alpha (by Housner's period), so they are the default wherever a user has the choice.
enum class RadiusUnit { centimetre, metre };

struct PeriodBand {
    double shortest_s = 0;  ///< T0 = 0.05 sqrt(R) [s]
    double longest_s = 0;   ///< T1 = 0.5 sqrt(R) [s]
};

/// The band over which Akiyama's measure weighs the energy spectrum (the paper's Eq. 5).
[[nodiscard]] PeriodBand period_band(RigidBody const& body, RadiusUnit unit = RadiusUnit::centimetre);

/// V_resp = sqrt(2 g R [cos(alpha - |theta|) - cos alpha]): the velocity whose energy the body held at its peak
/// rotation [m/s]. The paper's Eq. 7, lost in print and inferred. V_Ereq from |theta| = alpha on; keeps all digits of
/// tiny rotations.
[[nodiscard]] double response_velocity(RigidBody const& body, double peak_rotation_rad);

}  // namespace overturn
