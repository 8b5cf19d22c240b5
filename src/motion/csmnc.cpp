#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {

// China Strong Motion Network Center: one component, eight values to a line, under 15 or 16 lines of text.
constinit TableFormat const csmnc_table{.marks = {"no. of points", "equally spaced intervals of", "acceleration"}};

}  // namespace overturn
