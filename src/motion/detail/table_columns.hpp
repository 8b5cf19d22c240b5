/// Columns of a table: the time, the components, and the others. They are found by names, by the user's statements, and
/// for a time by its values; never by place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/column_role.hpp"
#include "motion/record.hpp"
#include "motion/text_statements.hpp"
#include "motion/text_table.hpp"

namespace overturn {

struct PlacedColumn {
    std::size_t column = 0;
    ColumnRole role;
};

/// A component given by a line of text.
struct MappedColumn {
    std::size_t column = 0;
    int line = 0;
};

struct TableColumns {
    std::optional<std::size_t> time;
    std::vector<PlacedColumn> motions;
    std::vector<std::string> left_out;  ///< names of columns that are neither
    std::vector<ColumnRole> roles;      ///< of all, if they are named
    int names_line = 0;
    std::vector<int> names_lines = {};      ///< where names stand one below the other
    bool stated = false;                    ///< by the user
    std::vector<MappedColumn> mapped = {};  ///< by lines of text
};

/// The names above the numbers, taken out of the statements' lines; none if no line of as many names is there.
/// \throws InputError at a line of names of another number
[[nodiscard]] TableColumns named_columns(TextTable const& table, RecordRequest const& request);

/// "dt = 0.01 s" and "100 Hz" are values, no names; "090" is one.
[[nodiscard]] bool may_be_names(std::vector<std::string> const& names);

/// Does the line name columns, more or fewer than the table has?
[[nodiscard]] bool names_others(TextLine const& line, bool lowest, TextTable const& table);

/// Forgets the direction of comp1, comp2 and comp3, or BN1, BN2 and BN3: any may be the vertical.
void forget_numbered(std::vector<ColumnRole>& roles);

/// "State --columns time,h1,v, with - for what is none", for messages.
[[nodiscard]] std::string how_to_state(RecordRequest const& request, std::size_t count);

/// Fills time, motions and left_out. \throws InputError if a column cannot be identified, with what to state, or if
/// what the request states contradicts a name
void place_columns(TextTable const& table, TextStatements const& statements, RecordRequest const& request,
                   TableColumns& columns);

}  // namespace overturn
