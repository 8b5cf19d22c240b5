/// Annual frequencies as JSON.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "results/hazard_frequency.hpp"

namespace overturn::cli {

/// One object per body and limit state: mean, its interval, fractiles by confidence, bounds from stripes, parts of the
/// integral between the points of the curve, what lies beyond it. All in 1/a; null where there is none.
[[nodiscard]] nlohmann::ordered_json frequency_json(std::vector<BodyFrequency> const& frequencies,
                                                    HazardCurve const& hazard);

}  // namespace overturn::cli
