#include "results/hazard_table.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/texts_of.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/openquake.hpp"
#include "motion/operators_in_name.hpp"
#include "motion/pair_table.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"
#include "results/detail/hazard_years.hpp"
#include "results/detail/unusual_hazard.hpp"

namespace overturn {
namespace {

// "pga" of "PGA [g]" and "pga_gal"; "sa(1.9 s)" of "Sa(1.9 s) [g]".
std::string measure_in(std::string_view name) {
    auto const text = measure_in_name(name);
    auto const bracket = text.starts_with("sa(") ? text.find(')') + 1 : 0;
    return std::string(trimmed(text.substr(0, text.find_first_of(" _\t([", bracket))));
}

// "IM", "intensity": of any measure.
bool names_no_measure(std::string_view measure) {
    constexpr auto any = std::to_array<std::string_view>(
        {"im", "iml", "imls", "intensity", "amplitude", "level", "capacity", "collapse", "measure"});
    return std::ranges::find(any, measure) != any.end();
}

void check_measure(PairTable const& table, HazardAxis const& axis, Location const& where) {
    auto const stated = measure_in(axis.column);
    if (axis.label.empty() && !stated.empty() && measure_in(table.first_name) != stated
        && !(names_no_measure(stated) && names_no_measure(measure_in(table.first_name)))) {
        throw InputError(where, fmt::format("hazard over '{}', fragility over '{}' (which names no measure: is it that "
                                            "one?). Name the column '{}' if it is",
                                            table.first_name, axis.column, table.first_name));
    }
    auto const name = measure_in_name(table.first_name);
    auto const behind = name.substr(std::min(axis.label.size(), name.size()));
    bool const other = !name.starts_with(axis.label)
                       || (!behind.empty() && std::string_view(" _\t([").find(behind[0]) == std::string::npos);
    if (!axis.label.empty() && other) {
        throw InputError(where, fmt::format("hazard over '{}' (the levels are {}). State it over {}", table.first_name,
                                            axis.label, axis.label));
    }
}

// What the lines of text say of the intensity. Years are judged above.
TextStatements statements_of(PairTable const& table, Dimension dimension, std::string const& name) {
    TextStatements statements(dimension);
    for (auto const& line : table.text) {
        auto const lower = lowered(line.text);
        bool const of_hazard = years_in(lower) || named_years(lower) || lower.find("annual") != std::string::npos
                               || lower.find("hazard") != std::string::npos;
        TextStatements alone(dimension);
        alone.take(line.text, line.number);
        if (!of_hazard || alone.unit() || !alone.doubt().empty()) {
            statements.take(line.text, line.number);
        }
    }
    statements.check_unit_of(table.first_name, name);
    return statements;
}

// Lines on the hazard that say more of it than a reader of a mean annual curve expects: "median", "per century", "x
// 10", "of the vertical component", "for Sa(1 s)" above another measure.
std::vector<std::string> more_of_hazard(PairTable const& table, HazardAxis const& axis,
                                        TextStatements const& statements) {
    auto lines = statements.unread();
    auto const name = measure_in_name(table.first_name);
    auto const behind = name.substr(std::min(measure_in(table.first_name).size(), name.size()));
    if (tells_more_in_name("x" + behind)) {
        lines.insert(lines.begin(), fmt::format("line {}: {}", table.names_line, in_quotes(table.first_name)));
    }
    for (auto const& line : table.text) {
        auto const lower = lowered(line.text);
        TextStatements alone(axis.dimension);
        alone.take(line.text, line.number);
        bool const spectral = lower.find("sa(") != std::string::npos || lower.find("spectral") != std::string::npos;
        auto const& other = alone.other();
        bool const another = (spectral && !axis.label.starts_with("sa")) || alone.states_peak()
                             || (!other.empty() && other != "a hazard curve");
        bool const known =
            tells_statistic(lower) || tells_vertical(lower) || lower.find('%') != std::string::npos || another;
        auto text = fmt::format("line {}: {}", line.number, in_quotes(trimmed(line.text)));
        if (known && std::ranges::find(lines, text) == lines.end()) {
            lines.insert(lines.begin(), std::move(text));
        }
    }
    return lines;
}

// The unit that the first column's name or the text states, none of a pure number.
IntensityUnit unit_of(PairTable const& table, HazardAxis const& axis, TextStatements const& statements,
                      Location const& where) {
    if (axis.dimension == Dimension::none) {
        return {};
    }
    auto const name = measure_in_name(table.first_name);
    auto const label = axis.label.empty() ? measure_in(table.first_name) : axis.label;
    auto const column = "a" + name.substr(std::min(label.size(), name.size()));
    auto const named = unit_of_values(column, axis.dimension);
    auto const unit = statements.unit_beside(named, {}, where);
    if (!unit) {
        throw InputError(where, fmt::format("'{}' states no unit of {} ({}one of {}). Write for example '{} [{}]'",
                                            table.first_name, name_of(axis.dimension),
                                            statements.doubt().empty() ? "" : statements.doubt() + "; must be ",
                                            accepted_units(axis.dimension), label, si_symbol(axis.dimension)));
    }
    return {named ? std::string(unit_text_in_name(column).text) : name_of_unit(*unit, axis.dimension), *unit};
}

// Rows that tables hold although they say nothing: no motion first, no exceedance last.
void check_row(Pair const& point, Pair const* before) {
    HazardPoint const last{before != nullptr ? before->first : 0, before != nullptr ? before->second : 0};
    bool const first_of_none = before == nullptr && point.first == 0 && point.second > 0;
    bool const none_left = before != nullptr && point.second == 0 && point.first > last.intensity;
    if (!first_of_none && !none_left) {
        check_hazard_point({point.first, point.second}, before != nullptr ? &last : nullptr);
    }
}

struct Cut {
    std::vector<HazardPoint> points;
    std::vector<std::string> remarks;
};

Cut without_zeros(PairTable const& table, double unit_si) {
    Cut cut;
    std::optional<int> first_zero;
    for (std::size_t i = 0; i < table.points.size(); ++i) {
        auto const& [intensity, annual] = table.points[i];
        if (intensity == 0) {
            cut.remarks.push_back(fmt::format("line {} is left out: intensity 0 is no motion", table.line[i]));
        } else if (annual == 0) {
            first_zero = first_zero.value_or(table.line[i]);
        } else {
            cut.points.push_back({intensity * unit_si, annual});
        }
    }
    if (first_zero) {
        cut.remarks.push_back(fmt::format(
            "from line {} on no exceedances are stated: the curve ends at the row before, and what lies beyond is "
            "bounded as beyond any end",
            *first_zero));
    }
    return cut;
}

void check_overlap(HazardCurve const& hazard, HazardAxis const& axis, Location const& where) {
    if (axis.highest == 0 || (hazard.last() >= axis.lowest && hazard.first() <= axis.highest)) {
        return;
    }
    auto const own = axis.lowest == axis.highest
                         ? axis.unit.text(axis.lowest)
                         : fmt::format("{} to {}", axis.unit.text(axis.lowest), axis.unit.text(axis.highest));
    throw InputError(where, fmt::format("hazard curve from {} to {}, fragility over {} (nothing in common). Check the "
                                        "units, or state the hazard over all of it",
                                        hazard_text(hazard, hazard.first()), hazard_text(hazard, hazard.last()), own));
}

}  // namespace

std::optional<HazardCurve> stated_hazard(CampaignInput const& input, LevelSpec const& levels) {
    auto const name = input.hazard_file();
    return name.empty() ? std::nullopt : std::optional(parse_hazard(input.files.at(name), name, levels));
}

std::string hazard_text(HazardCurve const& hazard, double intensity) {
    auto const& unit = hazard.stated();
    auto const value = fmt::format("{:.6g}", unit.of(intensity));
    return unit.symbol.empty() || unit.symbol == "1" ? value : fmt::format("{} {}", value, unit.symbol);
}

HazardAxis hazard_axis(LevelSpec const& levels) {
    return {levels.measure_label(),
            levels.dimension(),
            {levels.shown_units(), levels.stated_unit_si},
            levels.levels.front().value,
            levels.levels.back().value};
}

HazardCurve parse_hazard(std::string_view content, std::string const& name, HazardAxis const& axis) {
    if (auto const converted = hazard_of_openquake(content, name)) {
        auto const curve = parse_hazard(converted->table, name, axis);
        auto remarks = converted->remarks;
        std::ranges::copy(curve.remarks(), std::back_inserter(remarks));
        return HazardCurve(curve.points(), curve.stated(), std::move(remarks));
    }
    auto const table = read_pair_table(
        content, name, {.meaning = "intensity and annual exceedance", .are_names = [&](auto first, auto second) {
                            return is_annual_frequency(second)
                                   || (!axis.label.empty() && measure_in(first) == axis.label);
                        }});
    Location const where{name, table.names_line};
    if (table.names_line == 0) {
        auto const label = axis.label.empty() ? std::string("pga") : axis.label;
        auto const unit = axis.unit.symbol.empty() ? std::string("g") : axis.unit.symbol;
        throw InputError(Location{name, 1}, fmt::format("no line of names (what is exceeded, in which unit?). Begin "
                                                        "with '{} [{}], annual_exceedance'",
                                                        label, unit));
    }
    if (tells_operation_in_name(table.first_name)) {
        throw InputError(where, fmt::format("'{}' (an operation in its name: are its numbers that, or still to be "
                                            "changed by it?). Give the intensities as such, under a plain name",
                                            table.first_name));
    }
    check_measure(table, axis, where);
    check_annual(table, where);
    check_rows(table, name, check_row);  // behind the names: rows of another column break its rules
    auto remarks = check_years(table, name);
    auto const statements = statements_of(table, axis.dimension, name);
    auto unit = unit_of(table, axis, statements, where);
    auto cut = without_zeros(table, unit.si);
    auto& points = cut.points;
    if (points.size() < 2) {
        throw InputError(
            where, fmt::format("hazard curve of {} (at least two). Add some", count_text(std::ssize(points), "point")));
    }
    if (points.front().annual_exceedance == points.back().annual_exceedance) {
        throw InputError({name, table.line.back()},
                         fmt::format("annual exceedance {} throughout (no curve). Add stronger motions",
                                     points.back().annual_exceedance));
    }
    HazardCurve const hazard(std::move(points), std::move(unit), std::move(cut.remarks));
    check_overlap(hazard, axis, where);
    std::ranges::copy(hazard.remarks(), std::back_inserter(remarks));
    if (auto const text = not_understood(more_of_hazard(table, axis, statements)); !text.empty()) {
        remarks.push_back(name + text);
    }
    std::ranges::move(unusual_hazard(hazard, axis, axis.label.empty() ? measure_in(table.first_name) : axis.label),
                      std::back_inserter(remarks));
    return HazardCurve(hazard.points(), hazard.stated(), std::move(remarks));
}

}  // namespace overturn
