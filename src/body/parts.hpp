/// A body assembled from simple parts that share one vertical axis: cask, pallet, counterweight.
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "body/rigid_body.hpp"

namespace overturn {

/// How a part is held by what it stands on. A body is computed as one whatever is stated here.
struct Standing {
    bool fastened = false;
    std::optional<double> friction = {};  ///< static coefficient there [-]; empty: nothing is known of it
};

/// Upright and solid.
struct Cylinder {
    double mass_kg = 0;
    double radius_m = 0;
    double height_m = 0;
    double bottom_height_m = 0;  ///< of its lower face above the base of the body [m]
    Standing standing = {};
};

/// Upright and solid. Its depth across the rocking plane does not matter to the inertia in that plane.
struct Box {
    double mass_kg = 0;
    double width_m = 0;  ///< in the rocking plane [m]
    double height_m = 0;
    double bottom_height_m = 0;  ///< of its lower face above the base of the body [m]
    Standing standing = {};
};

struct PointMass {
    double mass_kg = 0;
    double height_m = 0;  ///< above the base of the body [m]
};

using BodyPart = std::variant<Cylinder, Box, PointMass>;

/// Mass, centre height and I_G (parallel-axis theorem) of the parts on a base `base_width_m` wide; the restitution is
/// left to Housner's value. The centres of all parts lie on the body's axis.
/// \throws InputError naming the part, counted from 1, unless masses and sizes are positive and heights at least 0, or
/// if there is no part.
[[nodiscard]] BodyInput assemble(std::span<BodyPart const> parts, double base_width_m);

}  // namespace overturn
