/// What is not plausible of a campaign, in tables of ranges: values that are possible, hardly meant, and change
/// answers.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// Of levels, limits and the design basis, a line each.
[[nodiscard]] std::vector<std::string> implausible_statements(CampaignSpec const& spec);

/// Of a drawn wave: a vertical component above the horizontal one, a step that cannot carry what was asked for.
[[nodiscard]] std::vector<std::string> implausible_wave(CampaignSpec const& spec, WaveRow const& row,
                                                        GroundMotion const& motion);

}  // namespace overturn
