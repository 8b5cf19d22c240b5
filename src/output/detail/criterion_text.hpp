/// The energy criterion on trial, for the terminal.
#pragma once

#include <span>
#include <string>

#include "results/analysis.hpp"

namespace overturn::output {

/// False predictions of each body's criterion, V_resp over V_WES, and the findings for and against it.
[[nodiscard]] std::string criteria_text(std::span<BodyAnalysis const> bodies, double confidence);

}  // namespace overturn::output
