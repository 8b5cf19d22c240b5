/// Slip and rotation of a body at each level: quantiles of its peak responses.
#pragma once

#include <cstddef>
#include <vector>

#include "results/analysis.hpp"

namespace overturn {

/// Quantiles of peak slip, unless the body cannot slip, and of peak rotation; over the trials that are held.
[[nodiscard]] std::vector<LevelQuantiles> level_quantiles(CampaignSpec const& spec, MeasuredTrials const& trials,
                                                          std::size_t body, double confidence);

}  // namespace overturn
