#include "motion/detail/table_checks.hpp"

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/detail/motion_look.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/text_lines.hpp"

namespace overturn {

void check_look(std::span<double const> values, ColumnRole const& role, std::size_t columns,
                TextStatements const& statements, RecordRequest const& request, Location const& where) {
    bool const named = role.quantity == Quantity::acceleration || role.component.direction != Direction::unknown
                       || statements.accelerations();
    auto const why = named ? no_named_motion(values, lowered(role.name).starts_with("a_")) : no_motion(values);
    if (!why.empty() && request.columns.empty() && !(named && request.by_place)) {
        throw InputError(
            where, fmt::format("{} in column '{}' (no motion looks like that{}). If it is one: {}", why, role.name,
                               named ? "" : ", and nothing calls it an acceleration", how_to_state(request, columns)));
    }
}

void check_gaps(TextTable const& table, std::size_t column, RecordRequest const& request) {
    if (request.by_place) {
        return;
    }
    if (auto const row = gap_in(table.column[column])) {
        throw InputError({request.name, table.line[*row]},
                         fmt::format("{:g} in column {}, far above all others (a mark of a gap, by its look). Fill the "
                                     "gap, or cut the record there",
                                     table.column[column][*row], column + 1));
    }
}

void check_are_packed(TextTable const& table, RecordRequest const& request) {
    if (!request.by_place && request.format != "list" && are_side_by_side(table.column)) {
        throw InputError({request.name, table.line.front()},
                         fmt::format("{} numbers to a line without names (packed values of one component, or as many "
                                     "columns? By their look each column swings on its own). State the format list, "
                                     "or: {}",
                                     table.columns(), how_to_state(request, table.columns())));
    }
}

}  // namespace overturn
