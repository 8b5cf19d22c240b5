/// Names of columns that stand one below the other, each with its number: "Column 2: acceleration EW (gal)".
#pragma once

#include <string>
#include <vector>

#include "motion/text_table.hpp"

namespace overturn {

struct NumberedNames {
    std::vector<std::string> names;  ///< of columns 1, 2, 3, ...; empty if not each has one
    std::vector<int> lines;          ///< on which they stand
};

/// "Column 1: time (s)", "col 2 = NS", "Spalte 3: UD", each on a line or between commas. Empty if a number is missing
/// or stands twice with different names.
[[nodiscard]] NumberedNames numbered_names(TextTable const& table);

}  // namespace overturn
