#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {

// EarthScope (IRIS) ASCII: one line of name, count, rate, begin, layout, type and unit, then values, or times and
// values.
constinit TableFormat const earthscope_table{.marks = {"timeseries ", " samples, ", " sps, "}};

}  // namespace overturn
