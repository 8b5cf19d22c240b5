#include "output/detail/sheet_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::output {
namespace {

std::size_t place_of(std::vector<SheetColumn> const& columns, std::string const& title) {
    return static_cast<std::size_t>(std::ranges::find(columns, title, &SheetColumn::title) - columns.begin());
}

// As a person would write it: 892 and not 892.0000000000001.
double rounded(double value) {
    double shown = value;
    (void)parse_number(fmt::format("{:.12g}", value), shown);
    return shown;
}

// The cells of a part, some rows at a time.
class PartReader {
  public:
    PartReader(store::ResultsReader const& file, SheetPart const& part, std::vector<SheetColumn> const& columns)
        : file_(file), part_(part), cells_(columns.size()), names_(part.sources.size()) {
        table_.row_bytes = part.sources.size() * sizeof(double);
        for (std::size_t s = 0; s < part.sources.size(); ++s) {
            auto const& source = part.sources[s];
            places_.push_back(place_of(columns, source.column.title()));
            if (!source.path.empty()) {
                add_field(source, s);
            }
        }
    }

    void each_row(Sheet::Take const& take) {
        constexpr std::int64_t at_once = 1 << 13U;
        std::vector<std::byte> rows;
        for (std::int64_t first = 0; first < part_.rows; first += at_once) {
            auto const count = static_cast<std::size_t>(std::min(at_once, part_.rows - first));
            rows.assign(count * table_.row_bytes, {});
            file_.rows(table_, part_.rows, first, rows);
            for (std::size_t r = 0; r < count; ++r) {
                fill(std::span(rows).subspan(r * table_.row_bytes, table_.row_bytes));
                take(cells_);
            }
        }
    }

  private:
    void add_field(SheetSource const& source, std::size_t place) {
        auto const slash = source.path.find('/');
        table_.group = source.path.substr(0, slash);
        Field field{source.path.substr(slash + 1), "1", {}, source.type, place * sizeof(double), {}};
        if (source.type == FieldType::category) {
            field.categories = source.names;
        }
        for (auto const& [value, name] : source.names) {
            names_[place].emplace(value, name == store::no_text ? std::string() : name);
        }
        table_.columns.push_back(std::move(field));
    }

    void fill(std::span<std::byte const> row) {
        for (std::size_t s = 0; s < part_.sources.size(); ++s) {
            cells_[places_[s]] = cell(row, s);
        }
        for (std::size_t s = 0; s < part_.sources.size(); ++s) {
            if (auto const& source = part_.sources[s]; !source.only_where.empty() && !applies(source)) {
                cells_[places_[s]] = std::monostate();
            }
        }
    }

    [[nodiscard]] bool applies(SheetSource const& source) const {
        for (std::size_t s = 0; s < part_.sources.size(); ++s) {
            if (part_.sources[s].column.name == source.only_where) {
                auto const* const name = std::get_if<std::string_view>(&cells_[places_[s]]);
                return name != nullptr && *name == source.only_is;
            }
        }
        return false;
    }

    [[nodiscard]] SheetCell cell(std::span<std::byte const> row, std::size_t s) {
        auto const& source = part_.sources[s];
        if (source.path.empty()) {
            return std::string_view(source.text);
        }
        Field const place{{}, "1", {}, source.type, s * sizeof(double)};
        if (source.type == FieldType::real) {
            double const value = real_at(row, place);
            return std::isnan(value)      ? SheetCell()
                   : source.per_unit != 0 ? SheetCell(rounded(value / source.per_unit))
                                          : SheetCell(value);
        }
        auto const value = integer_at(row, place);
        if (!source.flags.empty()) {
            return flags_of(s, value);
        }
        auto const name = names_[s].find(value);
        return source.names.empty() || name == names_[s].end() ? SheetCell(value)
               : name->second.empty()                          ? SheetCell()
                                                               : SheetCell(std::string_view(name->second));
    }

    // The names of the bits that are set, kept for the next row that has the same.
    [[nodiscard]] SheetCell flags_of(std::size_t s, std::int64_t bits) {
        auto const [found, is_new] = names_[s].try_emplace(bits);
        auto const& flags = part_.sources[s].flags;
        for (std::size_t f = 0; is_new && f < flags.size(); ++f) {
            if ((bits >> f & 1) != 0) {
                found->second += (found->second.empty() ? "" : " ") + flags[f];
            }
        }
        return found->second.empty() ? SheetCell() : SheetCell(std::string_view(found->second));
    }

    store::ResultsReader const& file_;
    SheetPart const& part_;
    store::TableSpec table_;
    std::vector<std::size_t> places_;  // of the sources among the cells
    std::vector<SheetCell> cells_;
    std::vector<std::map<std::int64_t, std::string>> names_;  // by source
};

}  // namespace

Sheet sheet_of(std::string name, store::ResultsReader const& file, std::vector<SheetPart> parts) {
    Sheet sheet{.name = std::move(name)};
    for (auto const& part : parts) {
        sheet.rows += part.rows;
        for (auto const& source : part.sources) {
            if (std::ranges::find(sheet.columns, source.column.title(), &SheetColumn::title) == sheet.columns.end()) {
                sheet.columns.push_back(source.column);
            }
        }
    }
    auto const kept = std::make_shared<std::vector<SheetPart> const>(std::move(parts));
    sheet.each_row = [&file, kept, columns = sheet.columns](Sheet::Take const& take) {
        for (auto const& part : *kept) {
            PartReader(file, part, columns).each_row(take);
        }
    };
    return sheet;
}

Sheet text_sheet(std::string name, std::vector<SheetColumn> columns, std::vector<std::vector<std::string>> rows) {
    Sheet sheet{.name = std::move(name), .columns = std::move(columns), .rows = std::ssize(rows)};
    sheet.each_row = [rows = std::move(rows)](Sheet::Take const& take) {
        for (auto const& row : rows) {
            std::vector<SheetCell> cells;
            cells.reserve(row.size());
            for (auto const& text : row) {
                cells.push_back(text.empty() ? SheetCell() : SheetCell(std::string_view(text)));
            }
            take(cells);
        }
    };
    return sheet;
}

}  // namespace overturn::output
