/// Curves, criteria and verdicts for the terminal.
#pragma once

#include <string>
#include <vector>

#include "results/analysis.hpp"

namespace overturn {

/// Fragility, criterion and verdict for the terminal.
[[nodiscard]] std::string analysis_table(std::vector<BodyAnalysis> const& bodies, double confidence);

/// The fragility part of it, for one list of fits; also for tables that are nobody's campaign.
[[nodiscard]] std::string fragility_table(std::vector<MeasuredFragility> const& fits, double confidence);

}  // namespace overturn
