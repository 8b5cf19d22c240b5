/// Time that a campaign took, for its report.
#pragma once

#include <filesystem>

#include "cli/json_values.hpp"

namespace overturn::cli {

/// Lines from FILE.runtime.json beside the results file; empty without it, or where it cannot be read. Times are no
/// part of the results.
[[nodiscard]] Json cost_of(std::filesystem::path path);

}  // namespace overturn::cli
