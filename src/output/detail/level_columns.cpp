#include "output/detail/level_columns.hpp"

#include <fmt/format.h>

namespace overturn::output {

TextColumn level_column(LevelSpec const& levels, std::span<std::size_t const> shown) {
    TextColumn column{fmt::format("{} {}", levels.measure_name(), levels.shown_units())};
    for (auto const l : shown) {
        column.cells.push_back(fmt::format("{:.4g}", levels.shown(levels.levels[l].value)));
    }
    return column;
}

TextColumn purpose_column(LevelSpec const& levels, std::span<std::size_t const> shown) {
    TextColumn column{"", {}, TextColumn::Side::left};
    for (auto const l : shown) {
        auto const purpose = levels.levels[l].purpose;
        column.cells.push_back(purpose == LevelClass::ordinary ? std::string() : name_of(purpose));
    }
    return column;
}

}  // namespace overturn::output
