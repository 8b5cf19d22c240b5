/// Settings of a campaign, as a report lists them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "results/statistics.hpp"

namespace overturn::cli {

/// Pairs of what is meant and what was asked for, or run of it.
[[nodiscard]] nlohmann::ordered_json facts_of(CampaignSpec const& spec, Plan const& plan, Statistics const& statistics);

/// Pairs of what belongs to the method and how it was set: effects, validated range, integration.
[[nodiscard]] nlohmann::ordered_json method_of(CampaignSpec const& spec);

}  // namespace overturn::cli
