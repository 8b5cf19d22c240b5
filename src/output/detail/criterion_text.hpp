/// The energy criterion on trial, for the terminal.
#pragma once

#include <span>
#include <string>

#include "results/analysis.hpp"

namespace overturn::output {

/// How often the criterion of each body was false, V_resp over V_WES, and what speaks for and against it.
[[nodiscard]] std::string criteria_text(std::span<BodyAnalysis const> bodies, double confidence);

}  // namespace overturn::output
