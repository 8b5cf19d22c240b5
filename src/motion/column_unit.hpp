/// The unit that the name of a column states.
#pragma once

#include <optional>
#include <string_view>

namespace overturn {

/// SI value of one unit of a column of accelerations: "ax_mps2", "acceleration (g)", "Acc(gal)", "NS [cm/s2]". Nothing
/// if the name says none; a bare suffix "_g" says none either: it is as often the ground [m/s2].
[[nodiscard]] std::optional<double> unit_in_name(std::string_view name);

}  // namespace overturn
