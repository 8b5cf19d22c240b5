/// Tables as JSON: a list of objects each, by the names of their columns. What is not known is null, never 0.
#pragma once

#include <span>

#include <nlohmann/json.hpp>

#include "output/table.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn::output {

using Json = nlohmann::ordered_json;

/// Infinite and unknown numbers are null.
[[nodiscard]] Json json_of(Cell const& cell);
/// {"value": 600, "unit": "gal"}: a quantity in the unit that the campaign states. \param si it, in SI
[[nodiscard]] Json stated_json(double si, IntensityUnit const& unit);
/// The rows, each with what is the same in all of them first. Where columns have a unit of the campaign's own, a row
/// ends with "stated": these columns' names, without a unit, each with its value and unit.
[[nodiscard]] Json json_of(Table const& table);
/// {name: rows}; tables of one name are one list.
[[nodiscard]] Json json_of(std::span<Table const> tables);

}  // namespace overturn::output
