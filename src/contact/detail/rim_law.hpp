/// A continuous rim, disc or ring: how it presses and damps, without points and so without directions. In space it is
/// spatial/detail/rim_pressure-inl.hpp and face_pressure-inl.hpp; here what both rest on, and the base in its rocking
/// plane, in plain arithmetic.
#pragma once

#include <optional>

#include "contact/base_layout.hpp"

namespace overturn {

/// y of the rim's law: an element of depth d presses k max(0, d (1 + y d' / sqrt(d'^2 + w_v^2 d^2))), w_v^2 = K / m.
/// Homogeneous of degree one: a mass on the element rebounds with e_n at any speed, and nothing has to be remembered.
/// The root of ln e_n = ln |c| - int_c^1 y u^2 / (1 + y u (1 - u^2)) du, c = max(-1, -1/y): u is d' over its root
/// there. \throws InputError unless 0.05 <= e_n <= 1
[[nodiscard]] double rim_damping(double normal_restitution);

/// Free rocking in one plane: the largest tilt to the other side within some time [rad].
/// \param plane of the body: its sizes, inertia, friction and pad; its points are not used
/// \param start_rad at rest, the lowest point as deep as the weight presses it
/// \param inner_m of a base that bears evenly from this radius on; empty: on its rim alone
[[nodiscard]] double rim_swing_rad(ContactBlock const& plane, double start_rad, double seconds, double step_ratio,
                                   std::optional<double> const& inner_m = {});

}  // namespace overturn
