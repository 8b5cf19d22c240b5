/// Rare events, the hand calculation and trials to inspect, for the terminal.
#pragma once

#include <span>
#include <string>

#include "results/hand_check.hpp"
#include "results/rare_results.hpp"
#include "results/telling_trials.hpp"

namespace overturn::output {

/// Empty without bodies.
[[nodiscard]] std::string rare_text(CampaignSpec const& spec, std::span<RareBody const> bodies);

/// Empty without checks.
[[nodiscard]] std::string hand_check_text(CampaignSpec const& spec, std::span<HandCheck const> checks);

/// With the way to replay one; empty if there are none. \param file as the user names it
[[nodiscard]] std::string telling_text(CampaignSpec const& spec, std::span<TellingTrial const> trials,
                                       std::string const& file);

}  // namespace overturn::output
