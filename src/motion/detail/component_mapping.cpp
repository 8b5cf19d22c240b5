#include "motion/detail/component_mapping.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/mapping_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;
using Kind = MappingToken::Kind;

bool is_motion(ColumnRole const& role) {
    return role.quantity == Quantity::acceleration || role.quantity == Quantity::unknown;
}

struct Pair {
    std::size_t column = 0;
    ComponentName component;
    bool joined = false;  ///< by a sign or a bracket
};

/// "x NS y UD z EW", "x=N y=Z", "NS x"; empty if they pair otherwise.
std::vector<Pair> alternating(std::vector<MappingToken> const& tokens) {
    bool column_first = tokens.size() % 2 == 0;
    bool column_last = column_first;
    std::vector<Pair> forwards;
    std::vector<Pair> backwards;
    for (std::size_t i = 0; i + 1 < tokens.size(); i += 2) {
        auto const& one = tokens[i];
        auto const& two = tokens[i + 1];
        bool const both = one.kind == two.kind;
        column_first = column_first && one.kind == Kind::column && (!both || two.joined)
                       && two.component.direction != Direction::unknown;
        column_last = column_last && two.kind == Kind::column && (!both || two.joined)
                      && one.component.direction != Direction::unknown;
        forwards.push_back({one.column, two.component, two.joined});
        backwards.push_back({two.column, one.component, two.joined});
    }
    return column_first ? forwards : column_last ? backwards : std::vector<Pair>{};
}

/// "x y z NS UD EW", "x y z E N Z"; empty if it is not so.
std::vector<Pair> in_halves(std::vector<MappingToken> const& tokens) {
    auto const half = tokens.size() / 2;
    std::vector<Pair> made;
    for (std::size_t i = 0; half > 1 && tokens.size() == 2 * half && i < half; ++i) {
        if (tokens[i].kind != Kind::column || tokens[i + half].component.direction == Direction::unknown) {
            return {};
        }
        made.push_back({tokens[i].column, tokens[i + half].component, true});
    }
    return made;
}

struct Made {
    std::size_t column = 0;
    ComponentName component;
    int line = 0;
};

class Mapping {
  public:
    Mapping(TableColumns const& columns, std::string const& file, Text advice)
        : columns_(columns), file_(file), advice_(advice) {
        for (std::size_t i = 0; i < columns.roles.size(); ++i) {
            aliases_.push_back(is_motion(columns.roles[i]) ? aliases_of(columns.roles[i].name, i)
                                                           : std::vector<std::string>{});
        }
    }

    void take(TextLine const& line) {
        auto const clauses = mapping_clauses(line.text, aliases_);
        std::vector<MappingToken> whole;
        bool wordy = false;
        for (auto const& clause : clauses) {
            std::ranges::copy(clause.tokens, std::back_inserter(whole));
            wordy = wordy || clause.wordy;
        }
        if (auto const pairs = in_halves(whole); !pairs.empty() && !wordy) {  // "x, y, z are NS, UD, EW"
            take(pairs, line);
            return;
        }
        for (auto const& clause : clauses) {
            auto const pairs = alternating(clause.tokens);
            refuse_unpaired(clause, pairs.empty(), line);
            clause.wordy ? refuse_doubt(pairs, line) : take(pairs, line);
        }
    }

    [[nodiscard]] std::vector<Made> made() && { return std::move(made_); }

  private:
    void take(std::vector<Pair> const& pairs, TextLine const& line) {
        for (auto const& [column, component, joined] : pairs) {
            auto const& role = columns_.roles[column];
            auto const before = std::ranges::find(made_, column, &Made::column);
            bool const other = before != made_.end() && !may_be_one(before->component, component);
            bool const against = !is_axis_name(role.name) && !may_be_one(role.component, component);
            if (against && !joined) {
                continue;  // "NS and EW" is a list
            }
            if (other || against) {
                refuse(role, line);
            }
            if (before == made_.end()) {
                made_.push_back({column, component, line.number});
            }
        }
    }

    /// Does it name columns and the vertical, and not which of them that is?
    void refuse_unpaired(MappingClause const& clause, bool unpaired, TextLine const& line) const {
        ColumnRole const* named = nullptr;
        bool vertical = false;
        for (auto const& token : clause.tokens) {
            bool const column = token.kind == Kind::column;
            named = column ? &columns_.roles[token.column] : named;
            vertical = vertical || (!column && is_vertical(token.component.direction));
            unpaired = unpaired && !(column && is_vertical(columns_.roles[token.column].component.direction));
        }
        if (unpaired && vertical && named != nullptr) {
            refuse(*named, line);
        }
    }

    /// Among other words: is it another component than the name's?
    void refuse_doubt(std::vector<Pair> const& pairs, TextLine const& line) const {
        for (auto const& [column, component, joined] : pairs) {
            auto const& role = columns_.roles[column];
            bool const given =
                role.component.direction != Direction::unknown && component.direction != Direction::unknown;
            if (pairs.size() == 1 && given && (joined || is_axis_name(role.name))
                && is_vertical(component.direction) != is_vertical(role.component.direction)) {
                refuse(role, line);
            }
        }
    }

    [[noreturn]] void refuse(ColumnRole const& role, TextLine const& line) const {
        throw InputError({file_, line.number},
                         fmt::format("{} (it says another component of column '{}' than its name, or another line). {}",
                                     in_quotes(trimmed(line.text)), role.name, advice_));
    }

    TableColumns const& columns_;
    std::string const& file_;
    Text advice_;
    std::vector<std::vector<std::string>> aliases_;
    std::vector<Made> made_;
};

std::vector<Made> mapped(TextTable const& table, TableColumns const& columns, std::string const& file, Text advice) {
    Mapping mapping(columns, file, advice);
    for (auto const* lines : {&table.head, &table.notes}) {
        for (auto const& line : *lines) {
            if (line.number != columns.names_line) {
                mapping.take(line);
            }
        }
    }
    return std::move(mapping).made();
}

/// \throws InputError if what is mapped leaves two columns vertical, or one that is no longer the vertical and others
/// of which any may be
void check_the_others(TableColumns const& columns, std::vector<Made> const& made, std::string const& file,
                      Text advice) {
    std::vector<std::string> vertical;
    bool given_up = false;
    bool all = true;
    for (std::size_t i = 0; i < columns.roles.size(); ++i) {
        auto const& role = columns.roles[i];
        if (!is_motion(role)) {
            continue;
        }
        auto const found = std::ranges::find(made, i, &Made::column);
        auto const& component = found == made.end() ? role.component : found->component;
        if (is_vertical(component.direction)) {
            vertical.push_back(role.name);
        }
        all = all && (found != made.end() || !is_axis_name(role.name));
        given_up = given_up
                   || (found != made.end() && is_vertical(role.component.direction)
                       && component.direction == Direction::horizontal);
    }
    if (vertical.size() > 1 || (given_up && !all && vertical.empty())) {
        throw InputError(
            {file, made.front().line},
            fmt::format("what it says of '{}' leaves {} (their order is ambiguous). {}",
                        columns.roles[made.front().column].name,
                        vertical.size() > 1 ? fmt::format("'{}' and '{}' vertical", vertical[0], vertical[1])
                                            : std::string("others open"),
                        advice));
    }
}

std::string joined_names(std::vector<ColumnRole const*> const& roles) {
    std::string names;
    for (auto const* role : roles) {
        names += (names.empty() ? "" : ", ") + role->name;
    }
    return names;
}

/// \throws InputError if the text lists as many components as there are axes, the vertical one in another place
void check_list(std::vector<ColumnRole const*> const& axes, std::vector<std::string> const& listed,
                Location const& where, Text advice) {
    for (std::size_t i = 0; axes.size() == listed.size() && i < axes.size(); ++i) {
        if (is_axis_name(axes[i]->name) && !may_be_one(axes[i]->component, component_named(listed[i]))) {
            throw InputError(where, fmt::format("components {}, columns {} (they contradict each other, unless in "
                                                "another order). {}",
                                                fmt::join(listed, ", "), joined_names(axes), advice));
        }
    }
}

/// \throws InputError likewise at any line of text
void check_lists(TextTable const& table, TableColumns const& columns, TextStatements const& statements,
                 std::string const& file, Text advice) {
    std::vector<ColumnRole const*> axes;
    for (auto const& role : columns.roles) {
        if (is_motion(role)) {
            axes.push_back(&role);
        }
    }
    check_list(axes, statements.components(), {file, statements.components_line()}, advice);
    for (auto const* lines : {&table.head, &table.notes}) {
        for (auto const& line : *lines) {
            if (axes.size() > 1 && line.number != columns.names_line) {
                check_list(axes, listed_directions(line.text), {file, line.number}, advice);
            }
        }
    }
}

}  // namespace

void take_mapped_components(TextTable const& table, TextStatements const& statements, TableColumns& columns,
                            std::string const& file, std::string_view advice) {
    auto const made = mapped(table, columns, file, advice);
    if (made.empty()) {
        check_lists(table, columns, statements, file, advice);
        return;
    }
    check_the_others(columns, made, file, advice);
    for (auto const& [column, component, line] : made) {
        auto& role = columns.roles[column];
        if (component.axis == "h" && role.component.direction == Direction::horizontal) {
            continue;  // says no more than the name
        }
        bool const down = component.direction == Direction::down && is_vertical(role.component.direction);
        bool const open = is_axis_name(role.name) || role.component.direction == Direction::unknown;
        if (down || open) {
            role.component = component;
            columns.mapped.push_back({column, line});
        }
    }
}

void tell_mapped(TableColumns const& columns, std::vector<std::string>& statements, std::vector<std::string>& unread) {
    for (auto const& [column, line] : columns.mapped) {
        auto const& [direction, axis] = columns.roles[column].component;
        auto const* const direction_text = direction == Direction::down ? "downwards"
                                           : is_vertical(direction)     ? "vertical"
                                                                        : "horizontal";
        statements.push_back(
            fmt::format("line {}: {} is {}", line, in_quotes(columns.roles[column].name), direction_text));
        auto const begin = fmt::format("line {}: ", line);
        std::erase_if(unread, [&](std::string const& text) { return text.starts_with(begin); });
    }
}

}  // namespace overturn
