/// As JSON: bodies under one wave, curves over two measures, and what is reckoned by hand.
#pragma once

#include <nlohmann/json.hpp>

#include "results/hand_check.hpp"
#include "results/together.hpp"

namespace overturn::cli {

/// One entry per limit state and level: P that any body passes it, and phi of every pair; then the pooled ones.
[[nodiscard]] nlohmann::ordered_json together_json(CampaignSpec const& spec,
                                                   std::vector<BodiesTogether> const& together, double confidence);

/// \param spec whose bodies they are of, in its order
[[nodiscard]] nlohmann::ordered_json hand_check_json(CampaignSpec const& spec, std::vector<HandCheck> const& checks);

[[nodiscard]] nlohmann::ordered_json two_measures_json(std::vector<TwoMeasures> const& fits, double confidence);

}  // namespace overturn::cli
