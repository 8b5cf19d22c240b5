#include "output/results_tables.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

#include <fmt/ranges.h>

#include "core/error.hpp"

namespace overturn::output {
namespace {

constexpr char const* units_column = "units";
constexpr char const* names_note = "flag_names";

FieldType type_of(Kind kind) {
    return kind == Kind::real ? FieldType::real : kind == Kind::category ? FieldType::category : FieldType::integer;
}

std::string text_of(Cell const& cell) {
    return std::holds_alternative<std::string>(cell) ? std::get<std::string>(cell) : std::string();
}

double real_of(Cell const& cell) { return std::holds_alternative<double>(cell) ? std::get<double>(cell) : never; }

std::int64_t place_in(std::vector<std::string> const& names, std::string const& name) {
    auto const found = std::ranges::find(names, name);
    OVERTURN_EXPECT(found != names.end());
    return found - names.begin();
}

std::int64_t integer_of(Column const& column, Cell const& cell) {
    switch (column.kind) {
        case Kind::yes_no:
            return std::get<bool>(cell) ? 1 : 0;
        case Kind::category:
            return place_in(column.names, std::get<std::string>(cell));
        case Kind::names: {
            std::int64_t bits = 0;
            for (auto const& name : std::get<std::vector<std::string>>(cell)) {
                bits |= std::int64_t{1} << place_in(column.names, name);
            }
            return bits;
        }
        default:
            return std::get<std::int64_t>(cell);
    }
}

template <class Get> auto values_of(Table const& table, std::size_t c, Get get) {
    std::vector<decltype(get(Cell()))> values;
    values.reserve(table.rows.size());
    for (auto const& row : table.rows) {
        values.push_back(get(row[c]));
    }
    return values;
}

// The unit of every row in their order, "m/s2; m/s; 1".
std::string units_by_row(Table const& table) {
    return fmt::format("{}", fmt::join(values_of(table, table.place_of(units_column), text_of), "; "));
}

// Distinct texts are names of numbers, which every reader of HDF5 and netCDF knows; long ones lines of an attribute.
void write_texts(store::ResultsWriter& file, Table const& table, std::size_t c, Field field, std::string const& axis) {
    constexpr std::size_t longest_name = 200;  // netCDF takes 256 bytes
    auto const texts = values_of(table, c, text_of);
    if (std::ranges::any_of(texts, [](std::string const& text) { return text.size() > longest_name; })) {
        file.attribute(table.group, field.name, fmt::format("{}", fmt::join(texts, "\n")));
        return;
    }
    std::vector<std::string> names;
    std::vector<std::int64_t> numbers;
    for (auto const& text : texts) {
        auto const name = text.empty() ? std::string(store::no_text) : text;
        auto const place = std::ranges::find(names, name) - names.begin();
        if (place == std::ssize(names)) {
            names.push_back(name);
        }
        numbers.push_back(place);
    }
    field.type = FieldType::category;
    field.categories = numbered(names);
    file.array(table.group, field, numbers, axis);
}

void write_column(store::ResultsWriter& file, Table const& table, std::size_t c) {
    auto const& column = table.columns[c];
    bool const by_row = column.unit.by_row;
    bool const named = column.kind == Kind::category;
    Field field{
        column.name, by_row ? units_by_row(table) : column.unit.symbol,       column.meaning, type_of(column.kind),
        0,           named ? numbered(column.names) : std::vector<Category>{}};
    if (by_row) {
        field.notes.emplace_back("units_from", units_column);
    }
    if (column.kind == Kind::names) {
        field.notes.emplace_back(names_note, fmt::format("{}", fmt::join(column.names, " ")));
    }
    auto const axis = c == 0 ? std::string() : table.axis;
    if (column.kind == Kind::real) {
        file.array(table.group, field, values_of(table, c, real_of), axis);
    } else if (column.kind == Kind::text) {
        write_texts(file, table, c, field, axis);
    } else {
        file.array(table.group, field, values_of(table, c, [&](Cell const& cell) { return integer_of(column, cell); }),
                   axis);
    }
}

double relative_difference(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0;
    }
    auto const difference = std::abs(a - b) / std::max(std::abs(a), std::abs(b));
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

// Earlier programs of the same format had another name for it.
std::string_view present_name(std::string_view stored) {
    return stored == "no-five-percent-point" ? "five-percent-doubtful" : stored;
}

/// A column of a file as names or numbers, whatever numbers it gives its names.
class StoredColumn {
  public:
    StoredColumn(store::ResultsReader const& file, std::string const& path, Column const& column) : column_(column) {
        if (column.kind == Kind::real) {
            reals_ = file.reals(path);
        } else if (column.kind == Kind::category) {
            integers_ = file.named(path, numbered(column.names));
        } else {
            integers_ = file.integers(path);
        }
        if (column.kind == Kind::names) {
            bits_by_name(file, path);
        }
    }
    [[nodiscard]] std::size_t rows() const { return std::max(reals_.size(), integers_.size()); }
    [[nodiscard]] double difference(std::size_t row, Cell const& cell) const {
        if (column_.kind == Kind::real) {
            return relative_difference(reals_.at(row), real_of(cell));
        }
        return integers_.at(row) == integer_of(column_, cell) ? 0 : std::numeric_limits<double>::infinity();
    }

  private:
    // Bits as this program numbers their names. Up to format 4 the names are an attribute of the group.
    void bits_by_name(store::ResultsReader const& file, std::string const& path) {
        auto const group = path.substr(0, path.rfind('/'));
        std::istringstream words(file.attribute_or(path, names_note, file.attribute_or(group, names_note, "")));
        std::vector<std::string> const stored{std::istream_iterator<std::string>(words), {}};
        for (auto& bits : integers_) {
            std::int64_t renamed = 0;
            for (std::size_t bit = 0; bit < stored.size(); ++bit) {
                auto const found = std::ranges::find(column_.names, present_name(stored[bit]));
                if ((bits >> bit & 1) != 0 && found != column_.names.end()) {
                    renamed |= std::int64_t{1} << (found - column_.names.begin());
                }
            }
            bits = renamed;
        }
    }

    Column const& column_;
    std::vector<double> reals_;
    std::vector<std::int64_t> integers_;
};

// The row of the table that each row of the file is; none: the table has no such row.
std::vector<std::optional<std::size_t>> matching_rows(store::ResultsReader const& file, Table const& table,
                                                      std::string const& key) {
    auto const c = table.place_of(key);
    auto const names = values_of(table, c, text_of);
    std::vector<std::optional<std::size_t>> rows;
    for (auto const number : file.named(table.group + "/" + key, numbered(names))) {
        rows.push_back(number == unknown_category ? std::nullopt : std::optional(static_cast<std::size_t>(number)));
    }
    return rows;
}

}  // namespace

void write_table(store::ResultsWriter& file, Table const& table) {
    if (table.group.empty() || table.rows.empty()) {
        return;
    }
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        write_column(file, table, c);
    }
    for (auto const& [name, value] : table.constants) {
        if (std::holds_alternative<double>(value)) {
            file.attribute(table.group, name, std::get<double>(value));
        } else if (std::holds_alternative<std::string>(value)) {
            file.attribute(table.group, name, std::get<std::string>(value));
        } else if (std::holds_alternative<std::int64_t>(value)) {
            file.attribute(table.group, name, std::get<std::int64_t>(value));
        } else if (std::holds_alternative<bool>(value)) {
            file.attribute(table.group, name, static_cast<std::int64_t>(std::get<bool>(value)));
        }
    }
}

void write_tables(store::ResultsWriter& file, std::span<Table const> tables) {
    for (auto const& table : tables) {
        write_table(file, table);
    }
}

Difference difference(store::ResultsReader const& file, Table const& table, std::string const& key) {
    Difference largest;
    if (table.rows.empty() || !file.has(table.group + "/" + key)) {
        return largest;
    }
    auto const rows = matching_rows(file, table, key);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        auto const& column = table.columns[c];
        auto const path = table.group + "/" + column.name;
        if (column.name == key || column.kind == Kind::text || column.name == units_column || !file.has(path)) {
            continue;
        }
        StoredColumn const stored(file, path, column);
        validate(stored.rows() == rows.size(), "results file: {} has {} rows, {} has {} (it is damaged). Restore it",
                 path, stored.rows(), key, rows.size());
        for (std::size_t r = 0; r < rows.size(); ++r) {
            auto const apart = rows[r] ? stored.difference(r, table.rows[*rows[r]][c]) : 0;
            if (apart > largest.relative) {
                largest = {apart, path};
            }
        }
    }
    return largest;
}

}  // namespace overturn::output
