/// Tables as JSON: a list of objects each, by the names of their columns. What is not known is null, never 0.
#pragma once

#include <span>

#include <nlohmann/json.hpp>

#include "output/table.hpp"

namespace overturn::output {

using Json = nlohmann::ordered_json;

/// Infinite and unknown numbers are null.
[[nodiscard]] Json json_of(Cell const& cell);
/// The rows, each with what is the same in all of them first.
[[nodiscard]] Json json_of(Table const& table);
/// {name: rows}; tables of one name are one list.
[[nodiscard]] Json json_of(std::span<Table const> tables);

}  // namespace overturn::output
