/// The values of an estimate that is no finite number.
#pragma once

#include <limits>

namespace overturn {

/// An end of an interval that nothing bounds.
inline constexpr double infinite = std::numeric_limits<double>::infinity();
/// Value that the data do not determine; `null` in JSON, NaN in files.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace overturn
