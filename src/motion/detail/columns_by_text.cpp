#include "motion/detail/columns_by_text.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/list_head.hpp"
#include "motion/detail/motion_look.hpp"
#include "motion/detail/time_words.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {

TextStatements statements_of(TextTable const& table, TableColumns const& columns) {
    TextStatements statements;
    bool const pair = !pair_above(table).empty();
    if (pair && table.head.size() > 1 && !is_comment(table.head.front().text)) {
        statements.expect_title(table.head.front().number);
    }
    auto const is_text = [&](TextLine const& line) {
        return std::ranges::find(columns.names_lines, line.number) == columns.names_lines.end();
    };
    std::vector<TextLine> text;
    std::ranges::copy_if(std::span(table.head).first(table.head.size() - (pair ? 1 : 0)), std::back_inserter(text),
                         is_text);
    std::ranges::copy_if(table.notes, std::back_inserter(text), is_text);
    statements.take(text, columns.names_line);
    auto const is = [](Quantity quantity) { return [=](ColumnRole const& role) { return role.quantity == quantity; }; };
    if (std::ranges::any_of(columns.roles, is(Quantity::acceleration))) {
        constexpr std::array others{Quantity::velocity, Quantity::displacement, Quantity::counts, Quantity::spectrum,
                                    Quantity::other};
        statements.take_named_accelerations(std::ranges::none_of(
            others, [&](Quantity other) { return std::ranges::any_of(columns.roles, is(other)); }));
    }
    return statements;
}

std::optional<double> unit_of_times(TableColumns const& columns, TextStatements const& statements,
                                    std::string const& file) {
    if (columns.roles.empty()) {
        return statements.time_unit_s();
    }
    auto const& role = columns.roles[*columns.time];
    if (!role.unknown_unit.empty()) {
        throw InputError({file, columns.names_line},
                         fmt::format("column '{}' ('{}' is no unit of time that is known). Write s, ms or min",
                                     role.name, role.unknown_unit));
    }
    if (!columns.stated && tells_factor_of_time(role.name)) {
        throw InputError({file, columns.names_line},
                         fmt::format("column '{}' (a factor in the name of the times: are its numbers seconds, or to "
                                     "be multiplied by it?). Name it time, or state the columns",
                                     role.name));
    }
    if (role.unit && statements.time_unit_s() && *role.unit != *statements.time_unit_s()) {
        throw InputError({file, statements.time_unit_line()},
                         fmt::format("times in {}, column '{}' (they contradict each other). Mend one of them",
                                     name_of_time_unit(*statements.time_unit_s()), role.name));
    }
    return role.unit ? role.unit : statements.time_unit_s();
}

std::vector<std::string> telling_names(TableColumns const& columns) {
    std::vector<std::string> names;
    for (auto const& [column, role] : columns.motions) {
        if (columns.names_line > 0 && tells_other_values(role.name)) {
            names.push_back(fmt::format("line {}: {}", columns.names_line, in_quotes(role.name)));
        }
    }
    return names;
}

namespace {

/// \throws InputError if of the components that the text states none is a column, where all columns say what they are
void check_stated_are_there(TableColumns const& columns, TextStatements const& statements, std::string const& file) {
    auto const is_there = [&](std::pair<std::string, int> const& stated) {
        auto const in_text = component_named(stated.first);
        return std::ranges::any_of(columns.roles, [&](ColumnRole const& role) {
            bool const other = role.quantity == Quantity::time || role.quantity == Quantity::index;
            return !other && may_be_one(role.component, in_text);
        });
    };
    auto const& all = statements.all_components();
    if (!all.empty() && !columns.roles.empty() && !columns.stated && std::ranges::none_of(all, is_there)) {
        throw InputError({file, all.front().second},
                         fmt::format("component '{}', which by its name no column is, as '{}' (they contradict each "
                                     "other). Mend one of them",
                                     all.front().first, columns.motions.front().role.name));
    }
}

}  // namespace

void take_stated_component(TableColumns& columns, TextStatements const& statements, std::string const& file,
                           std::string_view advice) {
    if (columns.motions.size() == 1 && columns.motions.front().role.component.direction == Direction::unknown) {
        statements.check_no_vertical(file, advice);
    }
    if (!columns.motions.empty()) {
        check_stated_are_there(columns, statements, file);
    }
    if (columns.motions.size() != 1 || statements.components().size() != 1) {
        return;
    }
    auto& role = columns.motions.front().role;
    auto const in_text = component_named(statements.components().front());
    if (role.component.direction == Direction::unknown) {
        role.component = in_text;
    } else if (in_text.direction != Direction::unknown
               && is_vertical(in_text.direction) != is_vertical(role.component.direction)) {
        throw InputError({file, statements.components_line()},
                         fmt::format("component '{}', column '{}' is {} (they contradict each other). Mend one of them",
                                     statements.components().front(), role.name,
                                     is_vertical(role.component.direction) ? "vertical" : "horizontal"));
    }
}

void check_seconds(std::vector<double> const& values, TextStatements const& statements, Location const& where,
                   std::string const& how) {
    constexpr std::size_t telling = 20;
    if (values.size() >= telling && values[0] >= 0 && values[0] <= 1 && counts_rows(values) && !statements.time_step_s()
        && !statements.time_unit_s()) {
        throw InputError(where, fmt::format("{}, {}, {}, ... in column 1 (a count of rows, or times in s?). Name the "
                                            "columns, or: {}",
                                            values[0], values[1], values[2], how));
    }
}

void check_each_once(std::vector<std::string> const& words, Location const& where, std::string const& how) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        auto const word = lowered(trimmed(words[i]));
        for (std::size_t j = 0; j < i && word != "-" && word != "skip"; ++j) {
            if (lowered(trimmed(words[j])) == word) {
                throw InputError(where, fmt::format("columns {} and {} are both '{}' (one of each is read). {}", j + 1,
                                                    i + 1, word, how));
            }
        }
    }
}

}  // namespace overturn
