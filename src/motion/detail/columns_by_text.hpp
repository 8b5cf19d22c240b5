/// Columns of a table by its text and by the user's statements.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/text_statements.hpp"

namespace overturn {

/// All that the text of the table says, and whether its names say accelerations.
[[nodiscard]] TextStatements statements_of(TextTable const& table, TableColumns const& columns);

/// The one motion of a table takes the one direction that the text names. \throws InputError at the line if the
/// column's own name says another, or if it says none and another line holds a word of the vertical \param advice how
/// to state the columns
void take_stated_component(TableColumns& columns, TextStatements const& statements, std::string const& file,
                           std::string_view advice);

/// SI value of one unit of the times, where their name or the text says it. \throws InputError at one that is not
/// known, at a factor in the name, or if name and text contradict each other
[[nodiscard]] std::optional<double> unit_of_times(TableColumns const& columns, TextStatements const& statements,
                                                  std::string const& file);

/// "line 1: 'acc error [g]'": names of motions that say more of them than is understood.
[[nodiscard]] std::vector<std::string> telling_names(TableColumns const& columns);

/// \throws InputError at 1, 2, 3, ... without a step in the text: rows are counted so, too
void check_seconds(std::vector<double> const& values, TextStatements const& statements, Location const& where,
                   std::string const& how);

/// \param words stated, one for each column \param how to state them \throws InputError if two columns are the same
void check_each_once(std::vector<std::string> const& words, Location const& where, std::string const& how);

}  // namespace overturn
