#include "spectra/detail/design_part.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/units.hpp"
#include "motion/cell_rows.hpp"
#include "motion/column_role.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

std::string without_unit(std::string_view name) {
    return std::string(trimmed(name.substr(0, name.find_first_of("(["))));
}

/// The names of all columns but the first.
std::vector<std::string> ordinates_of(std::vector<Cell> const& header, bool with_units) {
    std::vector<std::string> names;
    for (auto const& cell : std::span(header).subspan(1)) {
        names.push_back(with_units ? std::string(cell.text) : without_unit(cell.text));
    }
    return names;
}

/// "sigma", "Sa uncertainty", "ln std": what a spectrum scatters by is no second spectrum.
bool is_spread(std::string_view name) {
    constexpr auto parts = std::to_array<std::string_view>(
        {"sigma", "\xCF\x83", "std", "st.dev", "deviation", "uncert", "dispersion", "scatter"});
    auto const lower = lowered(name);
    bool const shifted = lower.find_first_of("+-") != std::string::npos;  // "Sa + 1 sigma" is one
    return !shifted && std::ranges::any_of(parts, [&](auto part) { return lower.find(part) != std::string::npos; });
}

std::vector<std::string> spreads_of(std::vector<std::string> const& names) {
    std::vector<std::string> spreads;
    std::ranges::copy_if(names, std::back_inserter(spreads), is_spread);
    return spreads;
}

/// The place of the one ordinate that is no spread; nothing if there are several, or if one is named.
std::optional<std::size_t> only_ordinate(std::vector<std::string> const& names, std::string const& part) {
    bool const one = std::ranges::count_if(names, is_spread) + 1 == std::ssize(names);
    auto const at = static_cast<std::size_t>(std::ranges::find_if_not(names, is_spread) - names.begin());
    return part.empty() && one ? std::optional(at) : std::nullopt;
}

}  // namespace

std::size_t part_among(std::vector<std::string> const& names, std::string const& part, std::string_view what,
                       Location const& where) {
    if (part.empty() ? names.size() != 1 : std::ranges::count(names, part) != 1) {
        throw InputError(
            where, fmt::format("{} {}: {} ({}). State part = \"...\" with the name of the one that is meant",
                               names.size(), what, fmt::join(names, ", "),
                               part.empty() ? "which is meant?" : fmt::format("'{}' is not one of them alone", part)));
    }
    return part.empty() ? 0 : static_cast<std::size_t>(std::ranges::find(names, part) - names.begin());
}

std::optional<std::string> table_of_one_ordinate(std::string_view content, std::string const& name,
                                                 std::string const& part) {
    if (trimmed(content).empty()) {
        return std::nullopt;
    }
    CellRows rows(content, name, "Give two columns, period and value");
    auto const header = rows.header();
    bool const names = !header.empty() && (is_period_name(header[0].text) || is_frequency_name(header[0].text));
    if (header.size() < 3 || !names) {
        return std::nullopt;
    }
    bool const by_stem = !part.empty() && without_unit(part) == part;
    auto const all_names = ordinates_of(header, !by_stem);
    auto const only = only_ordinate(all_names, part);
    auto const column = 1 + (only ? *only : part_among(all_names, part, "ordinates", {name, rows.header_line()}));
    std::vector<std::string> lines;
    TextLines all(content);
    while (auto const line = all.next()) {
        lines.emplace_back(*line);
    }
    auto const keep = [&](std::vector<Cell> const& cells) {
        auto& line = lines[rows.line() - 1];
        auto const note = line.find('#');
        line = fmt::format("{},{}{}", cells[0].text, cells[column].text,
                           note == std::string::npos ? "" : " " + line.substr(note));
    };
    keep(header);
    if (only) {
        lines[rows.header_line() - 1] += fmt::format(" # left out: {}", fmt::join(spreads_of(all_names), ", "));
    }
    while (auto const cells = rows.next()) {
        keep(*cells);
    }
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace overturn
