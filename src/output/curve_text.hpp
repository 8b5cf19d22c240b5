/// Fragility curves for the terminal.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/analysis.hpp"

namespace overturn::output {

/// The curves of every body by every limit state; of waves on a grid its map.
[[nodiscard]] std::string curves_text(std::span<BodyAnalysis const> bodies, double confidence);

/// One list of fits; also of tables without a campaign.
[[nodiscard]] std::string fragility_table(std::vector<MeasuredFragility> const& fits, double confidence);

/// What the column "rank" means.
[[nodiscard]] std::string rank_text();

}  // namespace overturn::output
