/// Levels that a table on the terminal shows, where there are very many.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/level_spec.hpp"

namespace overturn::output {

/// Places of things in a row: all of up to 30; of more, 30 evenly spread ones with both ends. Rising.
[[nodiscard]] std::vector<std::size_t> spread_places(std::size_t count);

/// Places of levels, rising: spread ones, and those that have a name.
[[nodiscard]] std::vector<std::size_t> shown_levels(LevelSpec const& levels);

/// "(30 of 10000 levels; all are in the file)" as a line of its own; empty where all are shown.
[[nodiscard]] std::string left_out_levels(LevelSpec const& levels);

}  // namespace overturn::output
