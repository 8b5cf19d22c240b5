/// Results as tables. Every column is stated once, with its name, unit, meaning and the value of each row; results
/// file, JSON and csv are written from these tables alone, so that one thing has one name everywhere.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "stats/intensity_unit.hpp"
#include "stats/proportion.hpp"

namespace overturn::output {

/// A value of a row: nothing (not known, or it does not apply), a number, a count, yes or no, a name or a text, names
/// that apply.
using Cell = std::variant<std::monostate, double, std::int64_t, bool, std::string, std::vector<std::string>>;

enum class Kind {
    real,      ///< in a file NaN where nothing is known, in JSON null
    count,     ///< an integer
    yes_no,    ///< in a file 1 and 0
    category,  ///< one of `names`: in a file an enumeration
    names,     ///< those of `names` that apply: in a file a bit mask, whose attribute flag_names names the bits from 0
    text,      ///< in a file names of numbers, or lines of an attribute
};

/// The unit of a column.
struct Unit {
    std::string symbol;   ///< SI: "m"; "1": a pure number
    bool in_name = true;  ///< JSON and csv have it in the name: "peak_slip_m"; else by the table's "units"
    bool by_row = false;  ///< rows are of different measures: it is that of the row's column "units"
    std::optional<IntensityUnit> typed = {};  ///< the campaign's own: JSON has the value in it too, in "stated"

    Unit(char const* fixed) : symbol(fixed) {}  // NOLINT(google-explicit-constructor): every column states one
    /// The same, with the unit that the campaign states such numbers in.
    [[nodiscard]] Unit as(IntensityUnit own) const;
};
/// The unit that the table's constant "units" names: that of the levels, or of a quantity.
[[nodiscard]] Unit stated_unit(std::string const& symbol);
/// The unit of the measure that the row is of.
[[nodiscard]] Unit unit_of_row();

struct Column {
    std::string name;  ///< without the unit: "median_lower"
    Unit unit;
    std::string meaning;  ///< one line
    Kind kind = Kind::real;
    std::vector<std::string> names = {};  ///< of category and names, in their order in a file

    /// Name in JSON and csv, with the unit: "peak_slip_m".
    [[nodiscard]] std::string key() const;
};

/// One table: a list of the same name in JSON, in a file a group of columns of one length.
struct Table {
    std::string name;        ///< "fragility"
    std::string group = {};  ///< its group in a file: "limits/touches/fragility/type-a"; empty: in no file
    std::string axis = {};   ///< the column along which the others lie in a file; empty: each is its own
    /// Values that are the same in all rows: in a file attributes of the group, in JSON fields of every row.
    std::vector<std::pair<std::string, Cell>> constants = {};
    std::vector<Column> columns = {};
    std::vector<std::vector<Cell>> rows = {};
    /// Of each row the campaign's own unit of the columns whose unit is by_row: JSON has values in it too. Empty: none.
    std::vector<std::optional<IntensityUnit>> typed_of_rows = {};

    /// The place of a column. \pre it is there
    [[nodiscard]] std::size_t place_of(std::string_view column) const;
};

/// A text, none where it is empty.
[[nodiscard]] std::optional<std::string> text_or_none(std::string text);

/// Adds columns to a table, with their values in its rows.
template <class Row> class TableOf {
  public:
    /// \param rows outlive this
    TableOf(Table table, std::span<Row const> rows) : table_(std::move(table)), rows_(rows) {
        table_.rows.resize(rows.size());
    }

    /// A column; what `get(row)` returns says of what kind: a number, an integer, a bool or a text; numbers and texts
    /// may be missing (std::optional). An Interval, which may be missing too, gives two columns: name_lower and
    /// name_upper (of an empty name lower and upper).
    template <class Get> TableOf& add(std::string name, Unit unit, std::string meaning, Get get) {
        using Value = std::remove_cvref_t<decltype(get(std::declval<Row const&>()))>;
        if constexpr (std::is_same_v<Value, Interval> || std::is_same_v<Value, std::optional<Interval>>) {
            auto const begin = name.empty() ? name : name + "_";
            auto const end = [get](Row const& row, double Interval::*which) {
                std::optional<Interval> const interval = get(row);
                return interval ? std::optional((*interval).*which) : std::nullopt;
            };
            add(begin + "lower", unit, "lower end of " + meaning,
                [end](Row const& row) { return end(row, &Interval::lower); });
            add(begin + "upper", unit, "upper end of " + meaning + "; infinite: open",
                [end](Row const& row) { return end(row, &Interval::upper); });
        } else {
            put({std::move(name), std::move(unit), std::move(meaning), kind_of<Value>()}, get);
        }
        return *this;
    }
    /// A column whose values are among `names`; `get(row)` is one of them.
    template <class Get>
    TableOf& category(std::string name, std::string meaning, std::vector<std::string> names, Get get) {
        put({std::move(name), "1", std::move(meaning), Kind::category, std::move(names)}, get);
        return *this;
    }
    /// The same, where `names` are the values of the rows, as they come.
    template <class Get> TableOf& category(std::string name, std::string meaning, Get get) {
        std::vector<std::string> names;
        for (auto const& row : rows_) {
            if (std::string value = get(row); std::ranges::find(names, value) == names.end()) {
                names.push_back(std::move(value));
            }
        }
        return category(std::move(name), std::move(meaning), std::move(names), get);
    }
    /// A column of those of `names` that apply.
    template <class Get>
    TableOf& names(std::string name, std::string meaning, std::vector<std::string> names, Get get) {
        put({std::move(name), "1", std::move(meaning), Kind::names, std::move(names)}, get);
        return *this;
    }

    [[nodiscard]] Table take() { return std::move(table_); }

  private:
    template <class Value> static constexpr Kind kind_of() {
        if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::optional<bool>>) {
            return Kind::yes_no;  // what may be missing is in no file
        } else if constexpr (std::integral<Value>) {
            return Kind::count;
        } else if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, std::optional<std::string>>) {
            return Kind::text;
        } else {
            static_assert(std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>);
            return Kind::real;
        }
    }
    template <class Value> static Cell cell_of(Value value) {
        if constexpr (
            std::is_same_v<
                Value,
                std::optional<
                    double>> || std::is_same_v<Value, std::optional<bool>> || std::is_same_v<Value, std::optional<std::string>>) {
            return value ? Cell(*value) : Cell();
        } else if constexpr (std::integral<Value> && !std::is_same_v<Value, bool>) {
            return static_cast<std::int64_t>(value);
        } else {
            return value;
        }
    }
    template <class Get> void put(Column column, Get get) {
        table_.columns.push_back(std::move(column));
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            table_.rows[r].push_back(cell_of(get(rows_[r])));
        }
    }

    Table table_;
    std::span<Row const> rows_;
};

}  // namespace overturn::output
