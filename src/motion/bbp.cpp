#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {

// SCEC Broadband Platform: comments, the last with the names, then four columns.
constinit TableFormat const bbp_table{.marks = {"time(sec)", "n-s(cm/s", "e-w(cm/s"}};

}  // namespace overturn
