/// How far a body slides and rocks at each level: quantiles of its peak responses.
#pragma once

#include <cstddef>
#include <vector>

#include "results/analysis.hpp"

namespace overturn {

/// Of peak slip, unless the body cannot slip, and of peak rotation; of the trials that are held.
[[nodiscard]] std::vector<LevelQuantiles> level_quantiles(CampaignSpec const& spec, MeasuredTrials const& trials,
                                                          std::size_t body, double confidence);

}  // namespace overturn
