/// Recorded motions one by one, for the terminal.
#pragma once

#include <span>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"

namespace overturn::output {

/// A line for each record, body and level of the answer: verdict, slip, tilt, the response nearest to its limit over
/// that limit, the model. Empty without trials. \param trials of trials_of_few_waves
[[nodiscard]] std::string few_waves_text(CampaignSpec const& spec, std::span<TrialRow const> trials);

}  // namespace overturn::output
