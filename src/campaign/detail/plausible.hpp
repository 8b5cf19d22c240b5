/// Implausible values of a campaign, found by tables of ranges: possible, hardly meant, and able to change answers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// Implausible numbers among the campaign's keys, a line each.
[[nodiscard]] std::vector<std::string> implausible_keys(CampaignSpec const& spec);

/// The number stated at a key [SI]; NaN: nothing is stated, or no number.
[[nodiscard]] double stated_number(CampaignSpec const& spec, std::string_view key);

/// Implausible levels, limits and design basis, a line each.
[[nodiscard]] std::vector<std::string> implausible_statements(CampaignSpec const& spec);

/// Implausible properties of a drawn wave: a vertical component above the horizontal one, a step too long for the
/// frequencies asked for.
[[nodiscard]] std::vector<std::string> implausible_wave(CampaignSpec const& spec, WaveRow const& row,
                                                        GroundMotion const& motion);

}  // namespace overturn
