/// Columns called by the axes of a program, "u,v,w".
#pragma once

#include <string_view>

#include "core/error.hpp"
#include "motion/detail/table_columns.hpp"

namespace overturn {

/// \throws InputError at "u,v,w" and two of them: of a program's axes, of which any may be up; but "n,w,u" are north,
/// west and up \param advice how to state the columns
void check_program_axes(TableColumns const& columns, Location const& names, std::string_view advice);

}  // namespace overturn
