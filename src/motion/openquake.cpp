#include "motion/openquake.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

/// What stands behind `key=`, up to a comma or a quote.
Text behind(Text line, Text key) {
    auto const at = line.find(key);
    if (at == Text::npos) {
        return {};
    }
    auto rest = line.substr(at + key.size());
    rest.remove_prefix(rest.starts_with('\'') ? 1 : 0);
    return rest.substr(0, rest.find_first_of(",'\""));
}

std::vector<Text> cells_of(Text line) {
    std::vector<Text> cells;
    for (bool more = true; more;) {
        auto const end = line.find(',');
        more = end != Text::npos;
        cells.push_back(trimmed(line.substr(0, end)));
        line = more ? line.substr(end + 1) : Text{};
    }
    return cells;
}

/// "PGA" in g, "SA(1.0)" in g, "PGV" in cm/s, as the levels of a campaign are called.
std::string measure_of(Text imt, Location const& where) {
    auto const lower = lowered(imt);
    double period_s = 0;
    if (lower == "pga") {
        return "pga [g]";
    }
    if (lower == "pgv") {
        return "pgv [cm/s]";
    }
    if (lower.starts_with("sa(") && parse_number(lower.substr(3, lower.find(')') - 3), period_s)) {
        return fmt::format("sa({:g} s) [g]", period_s);
    }
    throw InputError(where, fmt::format("imt {} (PGA, PGV and SA(T) are known). Export one of these", in_quotes(imt)));
}

struct Curve {
    double time_years = 0;
    std::string measure, kind;
};

Curve read_head(Text line, Location const& where) {
    Curve curve{0, measure_of(behind(line, "imt="), where), std::string(behind(line, "kind="))};
    if (!parse_number(behind(line, "investigation_time="), curve.time_years) || !(curve.time_years > 0)) {
        throw InputError(where, "no investigation_time (a probability is one of so many years). Export it anew");
    }
    return curve;
}

/// A column of probabilities: its level, and what the row holds of it.
struct Column {
    Text name;
    double level = 0, poe = 0;
};

std::vector<Column> columns_of(std::vector<Text> const& names, std::vector<Text> const& cells, Location const& where) {
    constexpr Text prefix = "poe-";
    std::vector<Column> columns;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].starts_with(prefix)) {
            continue;
        }
        Column column{names[i]};
        auto& [name, level, poe] = column;
        if (i >= cells.size() || !parse_number(name.substr(prefix.size()), level) || !parse_number(cells[i], poe)
            || !(poe >= 0 && poe <= 1)) {
            throw InputError(where, fmt::format("column {} (a level and a probability belong there). Export it anew",
                                                in_quotes(name)));
        }
        if (!columns.empty() && !(level > columns.back().level && poe <= columns.back().poe)) {
            throw InputError(where, fmt::format("column {}: {} after {} (levels rise, and stronger motions are "
                                                "rarer). Export it anew",
                                                in_quotes(name), poe, columns.back().poe));
        }
        columns.push_back(column);
    }
    return columns;
}

OpenQuakeHazard hazard_of(Curve const& curve, std::vector<Column> const& columns) {
    OpenQuakeHazard hazard{curve.measure + ", annual_exceedance\n", {}};
    Text certain;
    Text never;
    for (auto const& [name, level, poe] : columns) {
        if (poe > 0 && poe < 1) {
            hazard.table += fmt::format("{}, {}\n", level, -std::log1p(-poe) / curve.time_years);
        }
        certain = poe == 1 ? name : certain;
        never = poe == 0 && never.empty() ? name : never;
    }
    if (!certain.empty()) {
        hazard.remarks.push_back(fmt::format(
            "up to {} the probability is 1, which no frequency follows from: the curve begins behind it", certain));
    }
    if (!never.empty()) {
        hazard.remarks.push_back(
            fmt::format("from {} on the probability is 0: the curve ends before it, and what "
                        "lies beyond is bounded as beyond any end",
                        never));
    }
    if (!curve.kind.empty() && curve.kind != "mean") {
        hazard.remarks.push_back(
            fmt::format("its kind is {}, not mean: frequencies by it are no mean annual ones, and "
                        "by a low quantile too low. Export the mean",
                        curve.kind));
    }
    return hazard;
}

}  // namespace

std::optional<OpenQuakeHazard> hazard_of_openquake(std::string_view content, std::string const& name) {
    constexpr Text probabilities = "poe-";
    TextLines lines(content);
    auto const head = lines.next().value_or("");
    auto const names = lines.next().value_or("");
    if (head.find(probabilities) != Text::npos && head.find('=') == Text::npos) {
        throw InputError({name, 1},
                         "probabilities (poe-) without the line above them that states investigation_time "
                         "and imt. Keep that line of OpenQuake's");
    }
    if (names.find(probabilities) == Text::npos) {
        return std::nullopt;
    }
    auto const curve = read_head(head, {name, 1});
    auto const row = lines.next().value_or("");
    Location const where{name, lines.number()};
    if (auto const more = lines.next(); more && !trimmed(*more).empty()) {
        throw InputError({name, lines.number()},
                         "a second site (a curve of one is needed). Keep the row of the site that is meant");
    }
    return hazard_of(curve, columns_of(cells_of(names), cells_of(row), where));
}

}  // namespace overturn
