/// Outcome of a body over a grid of frequencies, for the terminal.
#pragma once

#include <string>

#include "results/grid_map.hpp"

namespace overturn::output {

/// A line for each frequency: least level that lifts the body off, overturns it and passes its other limits.
[[nodiscard]] std::string grid_map_text(GridMap const& map);

}  // namespace overturn::output
