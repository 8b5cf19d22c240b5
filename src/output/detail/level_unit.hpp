/// Columns in the unit of a campaign's levels.
#pragma once

#include "campaign/level_spec.hpp"
#include "output/table.hpp"

namespace overturn::output {

/// SI by the table's constant "units", with the unit in which the campaign states its levels.
[[nodiscard]] inline Unit level_unit(LevelSpec const& levels) {
    return stated_unit(levels.units()).as({levels.shown_units(), levels.stated_unit_si});
}

}  // namespace overturn::output
