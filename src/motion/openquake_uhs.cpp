#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/openquake.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::vector<std::string> cells_of(Text line) {
    std::vector<std::string> cells;
    for (bool more = true; more;) {
        auto const end = line.find(',');
        more = end != Text::npos;
        std::string cell(trimmed(line.substr(0, end)));
        std::erase(cell, '"');
        cells.push_back(std::move(cell));
        line = more ? line.substr(end + 1) : Text{};
    }
    return cells;
}

/// What stands behind `key`, up to a comma or a quote.
Text behind_key(Text line, Text key) {
    auto const at = line.find(key);
    auto rest = at == Text::npos ? Text{} : line.substr(at + key.size());
    rest.remove_prefix(rest.starts_with('\'') ? 1 : 0);
    return trimmed(rest.substr(0, rest.find_first_of(",'\"")));
}

/// "0.1~SA(0.5)": probability and period, that of PGA 0. [s]
struct Column {
    std::string probability;
    double period_s = 0;
    std::size_t at = 0;
};

std::vector<Column> columns_of(std::vector<std::string> const& names) {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto const& name = names[i];
        auto const tilde = name.find('~');
        auto const measure = tilde == std::string::npos ? Text{} : Text(name).substr(tilde + 1);
        double period = 0;
        bool const spectral =
            measure.starts_with("SA(") && parse_number(measure.substr(3, measure.find(')') - 3), period) && period > 0;
        if (measure == "PGA" || spectral) {
            columns.push_back({name.substr(0, tilde), period, i});
        }
    }
    std::ranges::sort(columns, {}, &Column::period_s);
    return columns;
}

}  // namespace

std::optional<std::string> uniform_hazard_of_openquake(std::string_view content, std::string const& name) {
    TextLines lines(content);
    auto line = lines.next();
    std::string kind;
    while (line && (trimmed(*line).empty() || line->starts_with('#'))) {
        auto const stated = behind_key(*line, "kind=");
        kind = stated.empty() || stated == "mean" ? kind : fmt::format("# kind {}, not mean\n", stated);
        line = lines.next();
    }
    auto const columns = columns_of(cells_of(line.value_or("")));
    if (columns.empty()) {
        return std::nullopt;
    }
    if (std::ranges::adjacent_find(columns, std::ranges::not_equal_to{}, &Column::probability) != columns.end()) {
        throw InputError(
            {name, lines.number()},
            fmt::format("spectra of several probabilities, {} and others (one is needed). Keep the columns "
                        "of one",
                        columns.front().probability));
    }
    auto const row = lines.next();
    auto const rest = lines.next();
    if (!row || (rest && !trimmed(*rest).empty())) {
        throw InputError({name, lines.number()}, fmt::format("{} (the spectrum of one site is needed). Keep one row",
                                                             row ? "several sites" : "no site"));
    }
    auto const cells = cells_of(*row);
    auto table = kind + "T (s),Sa (g)\n";
    for (auto const& column : columns) {
        table += fmt::format("{:.17g},{}\n", column.period_s, column.at < cells.size() ? cells[column.at] : "-");
    }
    return table;
}

}  // namespace overturn
