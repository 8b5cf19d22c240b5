/// Checks of a column's numbers against the quantity that they are taken for. Old results files were run already, so
/// nothing new is asked of their named columns and lists (RecordRequest::by_place).
#pragma once

#include <cstddef>
#include <span>

#include "core/error.hpp"
#include "motion/column_role.hpp"
#include "motion/record.hpp"
#include "motion/text_statements.hpp"
#include "motion/text_table.hpp"

namespace overturn {

/// \param columns of the table \throws InputError if the numbers look like no motion, unless the user states columns
void check_look(std::span<double const> values, ColumnRole const& role, std::size_t columns,
                TextStatements const& statements, RecordRequest const& request, Location const& where);

/// \throws InputError at the row where a column holds a mark of what is missing: -999 or 9999 far above all others
void check_gaps(TextTable const& table, std::size_t column, RecordRequest const& request);

/// \throws InputError if rows without names look like columns rather than one series, unless the user says a list
void check_are_packed(TextTable const& table, RecordRequest const& request);

}  // namespace overturn
