/// Components of a table's columns by its text: "x = NS, y = UD", "y is vertical", "Channel 2: EW", "column 3 UD".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/detail/table_columns.hpp"

namespace overturn {

/// Columns take the components that lines of text give them in so many words, where their names are no points of the
/// compass ("x", "ch1", "a2"); a vertical one may be turned downwards so. \param advice how to state the columns
/// \throws InputError at the line that gives a column another component than its name, or another line; that may do so
/// among other words; that leaves it open which of the axes is vertical; or that lists
/// components in another order than these axes
void take_mapped_components(TextTable const& table, TextStatements const& statements, TableColumns& columns,
                            std::string const& file, std::string_view advice);

/// Lines that give a column its component are statements that are used, and no longer unread.
void tell_mapped(TableColumns const& columns, std::vector<std::string>& statements, std::vector<std::string>& unread);

}  // namespace overturn
