/// The velocity of a body's response, which the energy criterion holds against what the wave offers.
#pragma once

#include "body/rigid_body.hpp"

namespace overturn {

/// V_resp = sqrt(2 g R [cos(alpha - |theta|) - cos alpha]): the velocity whose energy the body held at its peak
/// rotation [m/s]. The paper's Eq. 7, lost in print and inferred. V_Ereq from |theta| = alpha on; keeps all digits of
/// tiny rotations. Of a body whose corners differ: that of the corner it stood on.
/// \param side the sign of the rotation, if its corners differ
[[nodiscard]] double response_velocity(RigidBody const& body, double peak_rotation_rad, double side = 1);

}  // namespace overturn
