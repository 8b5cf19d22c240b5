/// Columns of a table for the terminal that has a row for each level.
#pragma once

#include <cstddef>
#include <span>

#include "campaign/level_spec.hpp"
#include "output/detail/columns_text.hpp"

namespace overturn::output {

/// Their values, in the campaign's unit. \param shown places of levels
[[nodiscard]] TextColumn level_column(LevelSpec const& levels, std::span<std::size_t const> shown);

/// "design-basis" and "beyond-design" where they apply.
[[nodiscard]] TextColumn purpose_column(LevelSpec const& levels, std::span<std::size_t const> shown);

}  // namespace overturn::output
