/// Settings of a campaign, as a report lists them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "results/statistics.hpp"

namespace overturn::cli {

/// Pairs of a label and the value that was requested, or run.
[[nodiscard]] nlohmann::ordered_json facts_of(CampaignSpec const& spec, Plan const& plan, Statistics const& statistics);

/// Pairs of a label and a setting of the method: effects, validated range, integration.
[[nodiscard]] nlohmann::ordered_json method_of(CampaignSpec const& spec);

}  // namespace overturn::cli
