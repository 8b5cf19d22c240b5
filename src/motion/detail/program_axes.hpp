/// Columns called by the axes of a program, "u,v,w", or by a letter that may be a velocity.
#pragma once

#include <string_view>

#include "core/error.hpp"
#include "motion/detail/table_columns.hpp"

namespace overturn {

/// Checks columns that no line of text describes. \throws InputError at "v" beside "a" or "d", or alone; at "u,v,w" and
/// two of them: of a program's axes, of which any may be up; but "n,w,u" are north, west and up \param advice how to
/// state the columns
void check_program_axes(TableColumns const& columns, Location const& names, std::string_view advice);

}  // namespace overturn
