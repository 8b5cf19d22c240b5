/// The step of a time column, which is printed to so many digits or was kept in single precision.
#pragma once

#include <cstddef>

#include "motion/record.hpp"
#include "motion/text_table.hpp"

namespace overturn {

/// The mean step of a column, one of the first three, or the step that the request states where the printed times allow
/// it. [s] \throws InputError at the row concerned if the times are not uniform to their printed digits, or if these
/// are too few to show a lost row and no step is stated
[[nodiscard]] double time_step_of(TextTable const& table, std::size_t column, RecordRequest const& request);

}  // namespace overturn
