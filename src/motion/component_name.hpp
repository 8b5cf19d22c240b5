/// One dictionary of the names that components of motion have: SEED codes, compass points and azimuths, axes, words of
/// several languages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace overturn {

/// Direction of a component, as far as its name states it.
enum class Direction { unknown, horizontal, up, down };

[[nodiscard]] constexpr bool is_vertical(Direction direction) {
    return direction == Direction::up || direction == Direction::down;
}

struct ComponentName {
    Direction direction = Direction::unknown;
    std::string axis = {};  ///< of horizontal ones: two of the same axis are parallel ("n" of N, NS and HNN)
};

/// A name that is nothing else: "NS", "N-S", "North-South", "HNE", "BN1", "090", "360 DEG", "N10E", "Trans", "comp2",
/// "UD", "Z", "DWN". Capitals, blanks, hyphens and underscores do not count.
[[nodiscard]] ComponentName component_named(std::string_view name);

/// A name with more in it: "acc_EW (gal)", "CH3(UD)", "accX", "TW.TCU049.HNZ". Unknown where its parts contradict each
/// other ("N-S vertical").
[[nodiscard]] ComponentName component_in(std::string_view name);

/// May both be names of one component: both vertical, or horizontal along lines less than 45 degrees apart, as far as
/// they state it?
[[nodiscard]] bool may_be_one(ComponentName const& one, ComponentName const& other);

/// The direction of component_named.
[[nodiscard]] Direction direction_of(std::string_view name);

/// Angle between the lines along which two horizontal components point, 0 to 90 [deg]: 10 of "000" and "N10E", 0 of
/// "000" and "180"; empty where one of them states no direction of the compass.
[[nodiscard]] std::optional<double> degrees_between(ComponentName const& one, ComponentName const& other);

}  // namespace overturn
