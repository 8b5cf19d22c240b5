#include "output/typed_columns.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "campaign/typed_units.hpp"

namespace overturn::output {
namespace {

std::optional<IntensityUnit> other_than(std::string const& si, IntensityUnit unit) {
    return unit.symbol.empty() || unit.symbol == si ? std::nullopt : std::optional(std::move(unit));
}

class TypedColumns {
  public:
    explicit TypedColumns(CampaignSpec const& spec)
        : units_(typed_units(spec)),
          levels_{spec.levels.shown_units(), spec.levels.stated_unit_si},
          level_units_(spec.levels.units()),
          level_measure_(spec.levels.measure_name()) {}

    void give(Table& table) const {
        for (auto& column : table.columns) {
            auto& unit = column.unit;
            if (column.kind != Kind::real || unit.typed || unit.by_row) {
                continue;
            }
            bool const of_level = !unit.in_name && unit.symbol == level_units_;
            unit.typed = of_level ? other_than(level_units_, levels_) : of(unit.symbol, table.name);
        }
        if (std::ranges::any_of(table.columns, [](Column const& column) { return column.unit.by_row; })) {
            for (std::size_t r = 0; r < table.rows.size(); ++r) {
                auto const symbol = text_of(table, r, "units");
                table.typed_of_rows.push_back(text_of(table, r, "measure") == level_measure_
                                                  ? other_than(symbol, levels_)
                                                  : of(symbol, table.name));
            }
        }
    }

  private:
    // Bodies are measured in the unit of their own lengths, not in that of slip.
    [[nodiscard]] std::optional<IntensityUnit> of(std::string const& si, std::string_view table) const {
        auto const unit = si == "kg"                       ? units_.mass
                          : si == "Pa"                     ? units_.pressure
                          : si == "m" && table == "bodies" ? units_.length
                                                           : shown_unit(units_, si);
        return other_than(si, unit);
    }

    // Of a row, or of all of them.
    static std::string text_of(Table const& table, std::size_t row, std::string_view name) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (auto const* const text = std::get_if<std::string>(&table.rows[row][c]);
                text != nullptr && table.columns[c].name == name) {
                return *text;
            }
        }
        auto const constant = std::ranges::find(table.constants, name, [](auto const& each) { return each.first; });
        auto const* const text =
            constant == table.constants.end() ? nullptr : std::get_if<std::string>(&constant->second);
        return text == nullptr ? std::string() : *text;
    }

    TypedUnits units_;
    IntensityUnit levels_;
    std::string level_units_, level_measure_;
};

}  // namespace

void give_typed_units(std::span<Table> tables, CampaignSpec const& spec) {
    TypedColumns const columns(spec);
    for (auto& table : tables) {
        columns.give(table);
    }
}

}  // namespace overturn::output
