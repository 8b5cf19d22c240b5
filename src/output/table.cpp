#include "output/table.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace overturn::output {

Unit Unit::as(IntensityUnit own) const {
    auto unit = *this;
    unit.typed = std::move(own);
    return unit;
}

Unit stated_unit(std::string const& symbol) {
    Unit unit(symbol.c_str());
    unit.in_name = false;
    return unit;
}

Unit unit_of_row() {
    auto unit = stated_unit("");
    unit.by_row = true;
    return unit;
}

std::string Column::key() const { return unit.in_name ? Field{name, unit.symbol, {}}.key() : name; }

std::optional<std::string> text_or_none(std::string text) {
    return text.empty() ? std::nullopt : std::optional(std::move(text));
}

std::size_t Table::place_of(std::string_view column) const {
    auto const found = std::ranges::find(columns, column, &Column::name);
    OVERTURN_EXPECT(found != columns.end());
    return static_cast<std::size_t>(found - columns.begin());
}

}  // namespace overturn::output
