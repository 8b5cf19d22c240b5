/// The unit that a line of prose states for the numbers below it, known or not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace overturn {

struct UnitInText {
    std::optional<double> si = {};  ///< of the dimension
    std::string unknown = {};       ///< what stands where a unit does and is none that is known: "g/10", "1e-3 g"
};

/// Behind "units", in brackets or behind "in" in a line on accelerations (velocities, displacements: by the dimension),
/// between commas, or as the whole line: "units: m s-2", "acceleration (% g)", "dt=0.01, g", "g". \param lower a line
/// in lower case
[[nodiscard]] UnitInText unit_in_text(std::string_view lower, Dimension dimension = Dimension::acceleration);

/// Looks it like a unit, known or not: letters of units alone, beside figures and signs?
[[nodiscard]] bool looks_like_unit(std::string_view text);

}  // namespace overturn
