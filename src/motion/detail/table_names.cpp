#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

/// Without the brackets around it.
std::string bare_unit(std::string text) {
    std::erase_if(text, [](char c) { return Text("()[]").find(c) != Text::npos; });
    return std::string(trimmed(text));
}

/// "(s),(gal)", "sec  cm/s2"
bool is_units_row(std::vector<std::string> const& names) {
    return !names.empty() && std::ranges::all_of(names, [](std::string const& name) {
        auto const unit = bare_unit(name);
        return unit.empty() || unit == "-" || column_role("x (" + unit + ")").unit;
    });
}

/// "dt = 0.01 s" and "100 Hz" are values, no names; "090" is one.
bool may_be_names(std::vector<std::string> const& names) {
    return std::ranges::none_of(names, [](std::string const& name) {
        bool const digit = !name.empty() && name.front() >= '0' && name.front() <= '9';
        return name.find('=') != std::string::npos || (digit && component_in(name).direction == Direction::unknown);
    });
}

bool all_blank_or_rule(Text line) { return line.find_first_not_of(" \t-=_,;|#%") == Text::npos; }

std::size_t known_of(std::vector<ColumnRole> const& roles) {
    return static_cast<std::size_t>(std::ranges::count_if(roles, &ColumnRole::said));
}

std::vector<ColumnRole> roles_of(std::vector<std::string> const& names) {
    std::vector<ColumnRole> roles;
    std::ranges::transform(names, std::back_inserter(roles), [](auto const& name) { return column_role(name); });
    return roles;
}

/// A line that names a time or a count of rows first and a motion behind it, as many as there are.
bool names_others(Text line, std::size_t count) {
    constexpr std::size_t most = 12;
    for (std::size_t n = 2; n <= most; ++n) {
        auto const names = n == count ? std::vector<std::string>{} : names_on(line, n).names;
        auto const roles = roles_of(names);
        if (!roles.empty() && (roles[0].quantity == Quantity::time || roles[0].quantity == Quantity::index)
            && !roles[0].name.empty() && known_of(roles) == n) {
            return true;
        }
    }
    return false;
}

/// Words parted as the rows are, but more or fewer than these: "foo,bar,baz" over "0.01,1.5".
bool parts_otherwise(Text line, TextTable const& table) {
    constexpr std::size_t most = 64;
    constexpr auto words_of_a_name = 2;
    if (table.separator == ' ') {
        return false;
    }
    auto const marks = static_cast<std::size_t>(std::ranges::count(line, table.separator));
    auto names = names_on(line, std::min(marks + 1, most)).names;
    while (!names.empty() && names.back().empty()) {
        names.pop_back();
    }
    return names.size() > 1 && names.size() != table.columns() && may_be_names(names)
           && std::ranges::all_of(
               names, [](std::string const& name) { return std::ranges::count(name, ' ') <= words_of_a_name; });
}

}  // namespace

void forget_numbered(std::vector<ColumnRole>& roles) {
    for (auto const& third : roles) {
        auto const name = lowered(third.name);
        if (third.component.direction != Direction::unknown || !name.ends_with('3')) {
            continue;
        }
        for (auto& other : roles) {
            auto const plain = lowered(other.name);
            if (plain.size() == name.size() && plain.substr(0, plain.size() - 1) == name.substr(0, name.size() - 1)) {
                other.component = {};
            }
        }
    }
}

std::string how_to_state(RecordRequest const& request, std::size_t count) {
    constexpr std::array words{"time", "h1", "h2", "v"};
    std::string example;
    for (std::size_t i = 0; i < count; ++i) {
        example +=
            fmt::format("{}{}", i == 0 ? "" : ",", i < words.size() ? (count == 3 && i == 2 ? "v" : words.at(i)) : "-");
    }
    return fmt::format("State {}, with - for what is none",
                       fmt::vformat(request.columns_key, fmt::make_format_args(example)));
}

TableColumns named_columns(TextTable const& table, RecordRequest const& request) {
    TableColumns columns;
    auto const count = table.columns();
    std::vector<std::string> units;
    bool lowest = true;  // but for units and rules
    for (auto line = table.head.rbegin(); count > 1 && line != table.head.rend(); ++line) {
        if (all_blank_or_rule(line->text)) {
            continue;
        }
        auto [names, by_blanks] = names_on(line->text, count);
        if (!names.empty() && units.empty() && is_units_row(names)) {
            units = std::move(names);
            continue;
        }
        bool const last = std::exchange(lowest, false);
        if (!names.empty() && !may_be_names(names)) {
            continue;
        }
        auto roles = roles_of(names);
        auto const least = by_blanks || !last ? count : 1;
        // Names that say nothing are kept for what they are called, if they stand right above.
        if (!names.empty() && (known_of(roles) >= least || (last && !by_blanks))) {
            for (std::size_t i = 0; i < units.size(); ++i) {
                roles[i] = column_role(fmt::format("{} ({})", names[i], bare_unit(units[i])));
            }
            columns.roles = std::move(roles);
            columns.names_line = line->number;
            break;
        }
        if (request.columns.empty()
            && (names_others(line->text, count) || (last && parts_otherwise(line->text, table)))) {
            throw InputError({request.name, line->number},
                             fmt::format("names of another number of columns than the {} below (which is which cannot "
                                         "be told). {}, or mend the names",
                                         count, how_to_state(request, count)));
        }
    }
    return columns;
}

}  // namespace overturn
