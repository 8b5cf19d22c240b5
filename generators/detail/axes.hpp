/// In which horizontal axes a measured motion is used.
#pragma once

#include <array>

#include "config/table.hpp"
#include "core/units.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

enum class Axes { recorded, principal, turned };

struct AxesRequest {
    Axes axes = Axes::recorded;
    double angle_rad = 0;  ///< of Axes::turned
};

inline constexpr std::array axes_names{
    config::Entry<Axes>{"as-recorded", "as the instrument stood", Axes::recorded},
    config::Entry<Axes>{"principal", "the stronger principal axis in the rocking plane", Axes::principal}};
inline constexpr config::Key axes_key =
    config::word_key<axes_names>("axes", "horizontal axes: a name, or an angle of rotation")
        .or_as(config::number_key("axes", Dimension::angle, config::Range::between(-2 * pi, 2 * pi), ""))
        .optional();

/// Key `axes`: "as-recorded", "principal", or an angle. \throws InputError
[[nodiscard]] AxesRequest read_axes(config::Table const& table);

/// The angle from the horizontal to the stronger principal axis, between -pi/2 and pi/2 from it: that of the largest
/// mean square (Penzien & Watabe 1975), along which the components are not correlated [rad].
[[nodiscard]] double principal_angle(GroundMotion const& motion);

/// The components along axes turned by `angle_rad` from the horizontal one towards the transverse one.
void turn_axes(GroundMotion& motion, double angle_rad);

}  // namespace overturn
