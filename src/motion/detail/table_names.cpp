#include <algorithm>
#include <array>
#include <iterator>

#include "core/digit.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/numbered_names.hpp"
#include "motion/detail/quantity_words.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::size_t known_of(std::vector<ColumnRole> const& roles) {
    return std::ranges::count_if(roles, &ColumnRole::is_known);
}

std::vector<ColumnRole> roles_of(std::vector<std::string> const& names) {
    std::vector<ColumnRole> roles;
    std::ranges::transform(names, std::back_inserter(roles), [](auto const& name) { return column_role(name); });
    // "BHZ,BHN,BHE [m/s2]": what one of a seismometer's channels is by its unit, the others without one are.
    auto const is_channel = [](ColumnRole const& role) {
        constexpr std::size_t letters = 3;
        return quantity_in_name(role.name.substr(0, letters)) == Quantity::velocity
               && unit_decides(role.name.substr(0, letters))
               && (role.name.size() == letters || std::string_view(" [(_").find(role.name[letters]) != Text::npos);
    };
    bool const accelerations = std::ranges::any_of(
        roles, [&](ColumnRole const& role) { return is_channel(role) && role.quantity == Quantity::acceleration; });
    for (auto& role : roles) {
        bool const without_unit = !role.unit && role.unknown_unit.empty();
        if (accelerations && without_unit && is_channel(role)) {
            role.quantity = Quantity::unknown;
        }
    }
    return roles;
}

/// A line that names a time or a count of rows first and a motion behind it, as many as there are.
bool names_time_and_others(Text line, std::size_t count) {
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
    std::size_t const marks = std::ranges::count(line, table.separator);
    auto names = names_on(line, std::min(marks + 1, most)).names;
    while (!names.empty() && names.back().empty()) {
        names.pop_back();
    }
    return names.size() > 1 && names.size() != table.columns() && may_be_names(names)
           && std::ranges::all_of(
               names, [](std::string const& name) { return std::ranges::count(name, ' ') <= words_of_a_name; });
}

/// \throws InputError if other columns are named than there are
void take_numbered(TextTable const& table, RecordRequest const& request, TableColumns& columns) {
    auto const numbered = numbered_names(table);
    bool const others =
        columns.names_line > 0 && std::ranges::find(numbered.lines, columns.names_line) == numbered.lines.end();
    auto const roles = roles_of(numbered.names);
    if (others || roles.size() < 2 || known_of(roles) == 0) {
        return;
    }
    if (roles.size() != table.columns()) {
        if (!request.columns.empty()) {
            return;
        }
        throw InputError({request.name, numbered.lines.front()},
                         fmt::format("names of {} columns above {} (their order is ambiguous). {}, or mend the names",
                                     roles.size(), table.columns(), how_to_state(request, table.columns())));
    }
    columns.roles = roles;
    columns.names_line = numbered.lines.front();
    columns.names_lines = numbered.lines;
}

}  // namespace

bool may_be_names(std::vector<std::string> const& names) {
    return std::ranges::none_of(names, [](std::string const& name) {
        bool const digit = !name.empty() && is_digit(name.front());
        return name.find('=') != std::string::npos || (digit && component_in(name).direction == Direction::unknown);
    });
}

bool names_others(TextLine const& line, bool lowest, TextTable const& table) {
    return names_time_and_others(line.text, table.columns()) || (lowest && parts_otherwise(line.text, table));
}

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
    std::string example = count == 1 ? "h1" : "";
    for (std::size_t i = 0; count > 1 && i < count; ++i) {
        example +=
            fmt::format("{}{}", i == 0 ? "" : ",", i < words.size() ? (count == 3 && i == 2 ? "v" : words.at(i)) : "-");
    }
    return fmt::format("State {}, with - for what is none",
                       fmt::vformat(request.columns_key, fmt::make_format_args(example)));
}

TableColumns named_columns(TextTable const& table, RecordRequest const& request) {
    TableColumns columns;
    auto const count = table.columns();
    // Names that say nothing are kept for what they are called, if they stand right above.
    auto const are = [&](Names const& found, bool lowest) {
        auto const least = found.by_blanks || !lowest ? count : 1;
        return may_be_names(found.names) && (known_of(roles_of(found.names)) >= least || (lowest && !found.by_blanks));
    };
    auto const elsewhere = [&](TextLine const& line, bool lowest) {
        auto const names = names_on(line.text, count).names;
        bool const values = !names.empty() && !may_be_names(names);
        if (!values && request.columns.empty() && names_others(line, lowest, table)) {
            throw InputError({request.name, line.number},
                             fmt::format("names of another number of columns than the {} below (their order is "
                                         "ambiguous). {}, or mend the names",
                                         count, how_to_state(request, count)));
        }
    };
    auto const found = names_above(table, are, elsewhere);
    columns.roles = roles_of(found.names);
    columns.names_line = found.line;
    take_numbered(table, request, columns);
    return columns;
}

}  // namespace overturn
