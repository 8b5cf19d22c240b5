/// As JSON: bodies under one wave, and curves over two measures.
#pragma once

#include <nlohmann/json.hpp>

#include "campaign/together.hpp"

namespace overturn::cli {

/// One entry per limit state and level: P that any body passes it, and phi of every pair; then the pooled ones.
[[nodiscard]] nlohmann::ordered_json together_json(CampaignSpec const& spec,
                                                   std::vector<BodiesTogether> const& together, double confidence);

[[nodiscard]] nlohmann::ordered_json two_measures_json(std::vector<TwoMeasures> const& fits, double confidence);

}  // namespace overturn::cli
