/// Where parts of a body stand on parts, and what parts them there: statics.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "body/parts.hpp"

namespace overturn {

/// A level at which all above stands on all below. All above moves as one there, under the acceleration of the base: it
/// tips about the edge of the smaller face at b / h times gravity, and slides at its friction times gravity.
struct Joint {
    double height_m = 0;                  ///< above the base [m]
    double half_width_m = 0;              ///< b, of the smaller of the two faces that meet [m]
    double mass_kg = 0;                   ///< of all above [kg]
    double centre_above_m = 0;            ///< h, of its centre of gravity above the joint [m]
    std::optional<double> friction = {};  ///< the lowest stated of the parts that stand there [-]
    bool fastened = false;                ///< all parts that stand there are
    std::vector<std::size_t> parts = {};  ///< those that stand there

    [[nodiscard]] double tips_at() const { return half_width_m / centre_above_m; }  ///< over gravity [-]
    /// Over gravity [-]; never above tips_at
    [[nodiscard]] double parts_at() const;
    [[nodiscard]] bool slides_first() const { return friction && *friction < tips_at(); }
};

/// From below. None where a part reaches through the level, as a shell does round its contents, or where parts do not
/// meet within a thousandth of the body's height: what holds them is not known then. A point is above what is below it.
[[nodiscard]] std::vector<Joint> joints_of(std::span<BodyPart const> parts);

/// Places of parts above the base that meet no face below them, are no contents of another part and are not stated to
/// be fastened: joints_of knows nothing of what holds them.
[[nodiscard]] std::vector<std::size_t> without_joint(std::span<BodyPart const> parts);

/// Does any part stand above the base without being stated to be fastened?
[[nodiscard]] bool any_loose(std::span<BodyPart const> parts);

}  // namespace overturn
