#include "motion/detail/table_columns.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/columns_by_text.hpp"
#include "motion/detail/component_mapping.hpp"
#include "motion/detail/mapping_words.hpp"
#include "motion/detail/motion_look.hpp"
#include "motion/detail/program_axes.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool is_motion(Quantity quantity) { return quantity == Quantity::acceleration || quantity == Quantity::unknown; }

class Placing {
  public:
    Placing(TextTable const& table, TextStatements const& statements, RecordRequest const& request,
            TableColumns& columns)
        : table_(table),
          statements_(statements),
          request_(request),
          columns_(columns),
          components_(request.format == "components"),
          where_{request.name, columns.names_line > 0 ? columns.names_line : table.line.front()} {}

    void as_stated() {
        columns_.stated = true;
        auto words = names_on(request_.columns, table_.columns()).names;
        if (words.empty() && table_.columns() == 1) {
            words = {request_.columns};
        }
        if (words.empty()) {
            throw InputError(where_,
                             fmt::format("{} columns, '{}' stated (one word for each is needed). {}", table_.columns(),
                                         request_.columns, how_to_state(request_, table_.columns())));
        }
        for (std::size_t i = 0; i < words.size(); ++i) {
            take_stated(i, lowered(trimmed(words[i])));
        }
        check_each_once(words, where_, how_to_state(request_, table_.columns()));
        take_stated_component(columns_, statements_, request_.name, how_to_state(request_, table_.columns()));
    }

    void as_named() {
        find_time();
        bool const explicit_ones = std::ranges::any_of(
            columns_.roles, [](ColumnRole const& role) { return role.quantity == Quantity::acceleration; });
        for (std::size_t i = 0; i < table_.columns(); ++i) {
            if (i == columns_.time) {
                continue;
            }
            auto const& role = columns_.roles[i];
            if (lowered(role.name) == "sample" && !counts_rows(table_.column[i])) {
                columns_.motions.push_back({i, {role.name}});
            } else if (role.quantity == Quantity::index) {
                check_index(i);
                columns_.left_out.push_back(role.name.empty() ? fmt::format("column {}", i + 1) : role.name);
            } else if (is_motion(role.quantity)) {
                columns_.motions.push_back({i, role});
            } else if (explicit_ones && role.quantity != Quantity::time && role.quantity != Quantity::hazard
                       && (role.quantity != Quantity::frequency || columns_.time)) {
                columns_.left_out.push_back(role.name);
            } else {
                refuse(i);
            }
        }
        take_stated_component(columns_, statements_, request_.name, how_to_state(request_, table_.columns()));
        check_program_axes(columns_, where_, how_to_state(request_, table_.columns()));
        check_stated();
    }

    void unnamed() {
        if (table_.line.size() < 2) {
            throw InputError(where_, "one row only (a motion has more). Give the whole record");
        }
        auto const& first = table_.column[0];
        auto const& named = statements_.components();
        bool const all_named = named.size() == table_.columns() && statements_.time_step_s();
        bool const rises = std::ranges::is_sorted(first) && first.front() < first.back();
        std::size_t const begin = table_.columns() > 1 && rises && !components_ && !all_named ? 1 : 0;
        if (begin == 1) {
            check_seconds(first, statements_, where_, how_to_state(request_, table_.columns()));
            columns_.time = 0;
        }
        auto const motions = table_.columns() - begin;
        bool const in_text = named.size() == motions;
        for (std::size_t i = 0; i < motions; ++i) {
            ColumnRole role;
            role.name = in_text ? named[i] : motions > 1 ? fmt::format("column {}", begin + i + 1) : std::string();
            role.component = in_text ? component_named(named[i]) : ComponentName{};
            columns_.motions.push_back({begin + i, role});
        }
        take_stated_component(columns_, statements_, request_.name, how_to_state(request_, table_.columns()));
        check_stated();
    }

  private:
    void take_stated(std::size_t i, std::string const& word) {
        auto const role = columns_.roles.empty() ? ColumnRole{} : columns_.roles[i];
        if (word == "-" || word == "skip") {
            columns_.left_out.push_back(role.name.empty() ? fmt::format("column {}", i + 1) : role.name);
            return;
        }
        if (word == "time" || word == "t") {
            if (role.quantity != Quantity::time && role.quantity != Quantity::unknown) {
                contradict(i, word);
            }
            columns_.time = i;
            return;
        }
        bool const vertical = word == "v" || word == "up" || word == "down";
        if (!vertical && word != "h" && word != "h1" && word != "h2") {
            throw InputError(where_, fmt::format("'{}' for column {} (must be time, h1, h2, v, down or -). {}", word,
                                                 i + 1, how_to_state(request_, table_.columns())));
        }
        auto const direction = is_axis_name(role.name) ? Direction::unknown : role.component.direction;
        bool const t = role.component.axis == "t" && role.quantity == Quantity::time;  // the letter T
        if ((!is_motion(role.quantity) && !t)
            || (direction != Direction::unknown && (direction != Direction::horizontal) != vertical)) {
            contradict(i, word);
        }
        auto placed = role;
        placed.quantity = Quantity::acceleration;
        placed.component = word == "down" ? ComponentName{Direction::down}
                           : vertical     ? ComponentName{direction == Direction::unknown ? Direction::up : direction}
                                          : ComponentName{Direction::horizontal, word};
        placed.name = role.name.empty() ? fmt::format("column {}", i + 1) : role.name;
        bool const first = word == "h1" || word == "h";
        columns_.motions.insert(first ? columns_.motions.begin() : columns_.motions.end(), {i, placed});
    }

    [[noreturn]] void contradict(std::size_t i, std::string const& word) const {
        auto const& role = columns_.roles[i];
        auto const says = role.component.direction != Direction::unknown && is_motion(role.quantity)
                              ? (role.component.direction == Direction::horizontal ? "horizontal" : "vertical")
                              : name_of(role.quantity);
        throw InputError(where_, fmt::format("column '{}' (its name says {}, '{}' is stated: they contradict each "
                                             "other). Mend one of them",
                                             role.name, says, word));
    }

    [[noreturn]] void refuse(std::size_t i) const {
        auto const& role = columns_.roles[i];
        throw InputError(where_, fmt::format("column '{}' ({}: columns are a time and accelerations, "
                                             "time,a_horizontal[,a_transverse][,a_vertical]). Leave it out, or name "
                                             "the accelerations as such",
                                             role.name, name_of(role.quantity)));
    }

    /// By name or unit; a letter T beside another time is transverse.
    void find_time() {
        for (std::size_t i = 0; i < table_.columns(); ++i) {
            auto& role = columns_.roles[i];
            if (role.quantity != Quantity::time) {
                continue;
            }
            if (!columns_.time) {
                columns_.time = i;
                continue;
            }
            auto& first = columns_.roles[*columns_.time];
            bool const letter = role.component.direction == Direction::horizontal;
            if (!letter && first.component.direction != Direction::horizontal) {
                throw InputError(where_, fmt::format("'{}' and '{}' (two times: which one counts?). {}", first.name,
                                                     role.name, how_to_state(request_, table_.columns())));
            }
            auto& transverse = letter ? role : first;
            columns_.time = letter ? *columns_.time : i;
            transverse.quantity = Quantity::unknown;
        }
        bool const letter = columns_.time && columns_.roles[*columns_.time].component.direction != Direction::unknown;
        if (letter && !rises_evenly(table_.column[*columns_.time])) {
            auto const among_components = std::ranges::any_of(columns_.roles, [](ColumnRole const& role) {
                return role.quantity != Quantity::time && role.component.direction != Direction::unknown
                       && role.component.axis != "h";
            });
            if (among_components && *columns_.time > 0) {  // L,T,V
                columns_.roles[*columns_.time].quantity = Quantity::unknown;
                columns_.time.reset();
            }
        }
        find_unnamed_time();
    }

    /// "x,y" of a digitiser, and the first column by place: it rises as times do, and nothing else is one.
    void find_unnamed_time() {
        auto const& first = columns_.roles[0];
        bool const may_be = first.quantity == Quantity::unknown && first.component.direction == Direction::unknown;
        bool const digitised = table_.columns() == 2 && lowered(first.name) == "x";
        if (!columns_.time && table_.columns() > 1 && ((may_be && request_.by_place) || digitised)
            && rises_evenly(table_.column[0])) {
            columns_.time = 0;
            if (digitised) {
                columns_.roles[1].component = {};
            }
        }
    }

    void check_index(std::size_t i) const {
        if (!counts_rows(table_.column[i])) {
            throw InputError(where_, fmt::format("column '{}' (a count of rows by its name, but it does not count "
                                                 "them). {}",
                                                 columns_.roles[i].name, how_to_state(request_, table_.columns())));
        }
    }

    /// As before format 5 of results files.
    void tell_by_place() {
        auto const count = columns_.motions.size();
        for (std::size_t i = 0; i < count; ++i) {
            auto& component = columns_.motions[i].role.component;
            bool const last = i > 0 && i + 1 == count;
            component = last    ? ComponentName{Direction::up, "v"}
                        : i > 0 ? ComponentName{Direction::horizontal, "t"}
                                : ComponentName{Direction::horizontal, "h"};
        }
    }

    /// \throws InputError unless it is known of each of several which it is
    void check_stated() {
        bool const unstated = std::ranges::all_of(columns_.motions, [](PlacedColumn const& column) {
            return column.role.component.direction == Direction::unknown;
        });
        if (request_.by_place && unstated) {
            tell_by_place();
        }
        if (columns_.motions.empty()) {
            throw InputError(where_, fmt::format("no column of accelerations (a time alone shakes nothing). {}",
                                                 how_to_state(request_, table_.columns())));
        }
        if (columns_.motions.size() < 2) {
            return;
        }
        for (auto const& [column, role] : columns_.motions) {
            if (role.component.direction == Direction::unknown) {
                throw InputError(where_,
                                 fmt::format("column {}{} (its component is ambiguous). {}", column + 1,
                                             columns_.roles.empty() ? std::string() : fmt::format(", '{}'", role.name),
                                             how_to_state(request_, table_.columns())));
            }
            for (auto const& other : columns_.motions) {
                check_apart(other, {column, role});
            }
        }
    }

    void check_apart(PlacedColumn const& one, PlacedColumn const& other) const {
        constexpr double least_deg = 45;
        auto const& first = one.role.component;
        auto const& second = other.role.component;
        bool const both = first.direction == Direction::horizontal && second.direction == Direction::horizontal;
        double const apart = degrees_between(first, second).value_or(least_deg);
        bool const same = first.axis == second.axis || (apart < least_deg && !request_.by_place);
        if (one.column < other.column && both && same) {
            throw InputError(where_, fmt::format("columns '{}' and '{}' (two of one direction). {}", one.role.name,
                                                 other.role.name, how_to_state(request_, table_.columns())));
        }
    }

    TextTable const& table_;
    TextStatements const& statements_;
    RecordRequest const& request_;
    TableColumns& columns_;
    bool components_;  // are stated to stand there, without a time
    Location where_;
};

}  // namespace

void place_columns(TextTable const& table, TextStatements const& statements, RecordRequest const& request,
                   TableColumns& columns) {
    forget_numbered(columns.roles);
    Placing placing(table, statements, request, columns);
    if (!request.columns.empty()) {
        placing.as_stated();
    } else if (!columns.roles.empty()) {
        if (!request.by_place) {
            take_mapped_components(table, statements, columns, request.name, how_to_state(request, table.columns()));
        }
        placing.as_named();
    } else {
        placing.unnamed();
    }
}

}  // namespace overturn
