#include "motion/detail/list_head.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/component_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {

std::vector<double> pair_above(TextTable const& table) {
    std::vector<double> pair;
    bool const list = table.columns() == 1 || table.columns() >= fewest_to_a_line;
    bool const times_and_values = table.columns() == 2;
    if (table.head.empty() || !(list || times_and_values)) {
        return {};
    }
    try {
        append_numbers(table.head.back().text, {}, 0, pair);
    } catch (InputError const&) {
        return {};
    }
    if (pair.size() != 2) {
        return {};
    }
    bool const counts_behind = pair[0] > 0 && pair[0] < 2 && pair[1] >= 2 && pair[1] == std::floor(pair[1]);
    if (counts_behind) {  // "0.01 1500", as SIMQKE has it
        std::swap(pair[0], pair[1]);
    }
    return pair;
}

std::optional<double> step_beside_count(TextTable const& table, std::string const& file) {
    auto const pair = pair_above(table);
    if (pair.empty()) {
        return std::nullopt;
    }
    auto const& line = table.head.back();
    constexpr double longest_s = 1;
    bool const step = pair[1] > 0 && pair[1] <= longest_s;
    if (!step || pair[0] != static_cast<double>(table.values())) {
        throw InputError({file, line.number},
                         fmt::format("{} and {} above {} values (a count and a time step stand there, or the values "
                                     "are cut short). Mend the line, or fetch the file anew",
                                     pair[0], pair[1], table.values()));
    }
    return pair[1];
}

void check_pair_above(TextTable const& table, double step_s, std::string const& file) {
    constexpr double printed = 1e-3;
    auto const pair = pair_above(table);
    if (!pair.empty() && std::abs(pair[1] - step_s) > printed * step_s) {
        throw InputError({file, table.head.back().number},
                         fmt::format("time step {:.6g} s where the times rise by {:.6g} s (one of them is wrong). Mend "
                                     "the step or the times",
                                     pair[1], step_s));
    }
}

void check_name_of_list(TextTable const& table, std::string const& file) {
    if (table.head.empty() || table.columns() != 1) {
        return;
    }
    auto const& line = table.head.back();
    std::string_view text = line.text;
    text = trimmed(text.substr(std::min(text.find_first_not_of("#%!/*; \t\""), text.size())));
    auto const bracket = std::min(text.find_first_of("(["), text.size());
    auto const plain = trimmed(text.substr(0, bracket));
    auto const blank = plain.find_last_of(" \t");
    bool const pair = blank != std::string_view::npos  // "vit NS", "u dot"
                      && (plain.substr(blank + 1) == "dot"
                          || component_named(plain.substr(blank + 1)).direction != Direction::unknown);
    bool const word =
        (pair ? trimmed(plain.substr(0, blank)) : plain).find_first_of(" \t0123456789:=,") == std::string_view::npos;
    if (!word || text.empty()) {
        return;
    }
    auto const role = column_role(text);
    bool const letter_v = lowered(role.name) == "v";
    bool const other = role.quantity != Quantity::unknown && role.quantity != Quantity::acceleration;
    if (other || letter_v) {
        throw InputError({file, line.number},
                         fmt::format("'{}' ({}: accelerations are read). Take the accelerations of the same record, or "
                                     "mend the name",
                                     text, letter_v ? "a velocity as well as the vertical" : name_of(role.quantity)));
    }
}

void check_first_of_list(TextTable const& table, RecordRequest const& request) {
    constexpr std::size_t telling = 4;
    if (table.columns() != 1 || table.values() < telling) {
        return;
    }
    auto const& values = table.column[0];
    auto const behind = static_cast<double>(values.size() - 1);
    bool const count = values[0] == behind || values[0] == behind - 1;  // alone, or above a step
    bool const step = request.time_step_s && values[0] == *request.time_step_s;
    if (count || step) {
        throw InputError({request.name, table.line[0]},
                         fmt::format("{:g} in the first row ({}, no value of the motion, by its look). Leave such rows "
                                     "out, or give the values a column of times",
                                     values[0], count ? "the count of the values below" : "the stated time step"));
    }
}

}  // namespace overturn
