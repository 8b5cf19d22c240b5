#include "cli/named_column.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/operators_in_name.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"

namespace overturn::cli {

namespace {

/// The measure of waves that a name states: "PGA", "Sa", "vector PGA", "sa-average"; nothing if it is none.
IntensityMeasure const* measure_called(std::string_view bare) {
    auto plain = lowered(bare);
    std::ranges::replace_if(
        plain, [](char c) { return c == ' ' || c == '-'; }, '_');
    auto const* const found = std::ranges::find_if(intensity_measures, [&](IntensityMeasure const& entry) {
        return !plain.empty() && entry.dimension != Dimension::none && (entry.name == plain || entry.level == plain);
    });
    return found == intensity_measures.end() ? nullptr : found;
}

}  // namespace

std::string NamedColumn::measure() const { return measure_called(bare) != nullptr ? name : std::string(); }

bool NamedColumn::is_intensity() const {
    constexpr auto names = std::to_array<std::string_view>(
        {"amplitude", "im",       "iml",        "imlevel",    "intensity",        "intensitymeasure",  "intensitylevel",
         "level",     "capacity", "collapseim", "imcollapse", "collapsecapacity", "collapseintensity", "pga",
         "pgv",       "sa",       "psa",        "sat1",       "sacollapse",       "collapsesa"});
    auto plain = lowered(bare);
    std::erase_if(plain, [](char c) { return std::string_view(" _-.").find(c) != std::string_view::npos; });
    return std::ranges::find(names, plain) != names.end() || measure_called(bare) != nullptr;
}

NamedColumn named_column(std::string_view cell) {
    cell = trimmed(cell);
    // The brackets of a period, "sa(1 s)", belong to the name.
    bool const period = lowered(cell).starts_with("sa(") && cell.find(')') != std::string_view::npos;
    auto const from = period ? cell.find(')') + 1 : 0;
    auto const open = std::min(cell.find_first_of("[(", from), cell.size());
    NamedColumn column{lowered(trimmed(cell.substr(0, open))), trimmed(cell.substr(0, period ? 2 : open)), {}};
    if (open < cell.size()) {
        auto const close = cell.find_first_of(")]", open);
        column.unit = trimmed(cell.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
    } else if (auto const mark = cell.find_last_of("_ "); mark != std::string_view::npos && mark >= from) {
        NamedColumn before{{}, trimmed(cell.substr(0, period ? 2 : mark)), {}};
        auto const unit = trimmed(cell.substr(mark + 1));
        if (intensity_unit_spelled(unit) && before.is_intensity()) {
            column = {lowered(trimmed(cell.substr(0, mark))), before.bare, unit};
        }
    }
    column.name = measure_in_name(column.name);
    return column;
}

std::string counted_things(std::string_view name) {
    auto plain = lowered(name);
    bool const numbered = plain.starts_with("no.");  // "no collapse" and "non-collapses" are the others
    std::erase_if(plain, [](char c) { return std::string_view(" _-.").find(c) != std::string_view::npos; });
    for (std::string_view const before : {"numberof", "noof", "numof", "num", "no"}) {
        if (before == "no" && !numbered) {
            continue;
        }
        if (plain.starts_with(before) && plain.size() > before.size()) {
            plain.erase(0, before.size());
            break;
        }
    }
    if (plain.size() > 2 && plain.ends_with('s')) {
        plain.pop_back();
    }
    return plain;
}

namespace {

/// Of a unit, or of a measure that the name states; none: it may be any.
Dimension dimension_of(NamedColumn const& column) {
    if (auto const unit = intensity_unit_spelled(column.unit)) {
        return unit->dimension;
    }
    auto const* const measure = measure_called(column.bare);
    return measure == nullptr || !column.unit.empty() ? Dimension::none : measure->dimension;
}

// "PGA in gal" above "pga [g]": words, without a number of their own, on what the column holds.
void check_lines_on(NamedColumn const& column, std::span<TextLine const> lines, Dimension dimension, double own,
                    std::string_view header, std::string const& file) {
    for (auto const& line : lines) {
        auto const lower = lowered(line.text);
        bool named = false;
        bool same = false;
        bool other = false;
        auto words = lower;
        std::ranges::replace_if(
            words, [](unsigned char c) { return std::isalnum(c) == 0 && c != '/'; }, ' ');
        for (auto const word : parts_of(words, ' ')) {
            double const unit = word.empty() ? 0 : unit_spelled(word, dimension).value_or(0);  // 0: none
            named = named || word == lowered(column.bare);
            same = same || unit == own;
            other = other || (unit > 0 && unit != own);
        }
        bool const number = std::ranges::any_of(lower, [](unsigned char c) { return std::isdigit(c) != 0; });
        if (named && other && !same && !number) {
            throw InputError(
                {file, line.number},
                fmt::format("'{}' beside column '{}' (two units of it: they contradict each other). Correct "
                            "one of them",
                            trimmed(line.text), header));
        }
    }
}

}  // namespace

IntensityText intensity_text(CellRows const& rows, std::string const& file, std::string_view column) {
    if (tells_operation_in_name(column)) {
        throw InputError({file, rows.header_line()},
                         fmt::format("'{}' (an operation in its name: are its numbers that, or still to be changed by "
                                     "it?). Give the intensities as such, under a plain name",
                                     column));
    }
    auto const named = named_column(column);
    auto dimension = dimension_of(named);
    auto const heard = [&](Dimension of) {
        TextStatements statements(of);
        statements.expect_counts();
        statements.take(rows.text(), 0);
        return statements;
    };
    if (dimension == Dimension::none && named.unit.empty()) {  // "IM" below "intensities in g"
        dimension = heard(Dimension::velocity).unit() ? Dimension::velocity : Dimension::acceleration;
    }
    auto const statements = heard(dimension);
    statements.check_unit_of(column, file);
    auto const own = dimension == Dimension::none ? std::nullopt : unit_spelled(named.unit, dimension);
    if (own) {
        check_lines_on(named, rows.text(), dimension, *own, column, file);
    }
    auto const unit = statements.unit_beside(own, {}, {file, rows.header_line()});
    if (named.unit.empty() && !unit && !statements.doubt().empty()) {
        throw InputError(
            {file, rows.header_line()},
            fmt::format("unit of '{}' missing ({}). Write for example '{} [g]'", column, statements.doubt(), column));
    }
    return {named.unit.empty() && unit ? name_of_unit(*unit, dimension) : std::string(named.unit), statements.unread()};
}

}  // namespace overturn::cli
