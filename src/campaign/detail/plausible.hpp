/// What is not plausible of a campaign, in tables of ranges: values that are possible, hardly meant, and change
/// answers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// Of keys of the campaign that are numbers, a line each.
[[nodiscard]] std::vector<std::string> implausible_keys(CampaignSpec const& spec);

/// What the campaign states at a key [SI]; NaN: nothing, or no number.
[[nodiscard]] double stated_number(CampaignSpec const& spec, std::string_view key);

/// Of levels, limits and the design basis, a line each.
[[nodiscard]] std::vector<std::string> implausible_statements(CampaignSpec const& spec);

/// Of a drawn wave: a vertical component above the horizontal one, a step that cannot carry what was asked for.
[[nodiscard]] std::vector<std::string> implausible_wave(CampaignSpec const& spec, WaveRow const& row,
                                                        GroundMotion const& motion);

}  // namespace overturn
