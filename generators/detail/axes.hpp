/// In which horizontal axes a measured motion is used.
#pragma once

#include "config/table.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

enum class Axes { recorded, principal, turned };

struct AxesRequest {
    Axes axes = Axes::recorded;
    double angle_rad = 0;  ///< of Axes::turned
};

/// Key `axes`: "as-recorded", "principal", or an angle. \throws InputError
[[nodiscard]] AxesRequest read_axes(config::Table const& table);

/// The angle from the horizontal to the stronger principal axis, between -pi/2 and pi/2 from it: that of the largest
/// mean square (Penzien & Watabe 1975), along which the components are not correlated [rad].
[[nodiscard]] double principal_angle(GroundMotion const& motion);

/// The components along axes turned by `angle_rad` from the horizontal one towards the transverse one.
void turn_axes(GroundMotion& motion, double angle_rad);

}  // namespace overturn
