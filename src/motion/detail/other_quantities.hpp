/// Quantities that are recorded beside motions: strain, pressure, force, temperature, rotation, seismic intensity.
#pragma once

#include <string_view>

namespace overturn {

/// Does the name of a column say such a quantity? \param lower in lower case, without its unit
[[nodiscard]] bool names_other_quantity(std::string_view lower);

/// Does a line of prose say that all numbers below it are of such a quantity: "Pore pressure (kPa)", "Strain time
/// history", "data type: force"? Not if it gives one value ("intensity: 5.2", "temperature 20 C") or speaks of an
/// earthquake's size ("seismic moment") or of an instrument. \param lower in lower case
[[nodiscard]] bool labels_other_quantity(std::string_view lower);

}  // namespace overturn
