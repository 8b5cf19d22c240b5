/// What the rare events of a campaign will take, by a look at each of its limit states.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "rare/effort.hpp"

namespace overturn {

struct RareForecast {
    rare::Effort trials;   ///< waves at one factor each, of all bodies and limit states
    rare::Effort seconds;  ///< of one rank
};

/// Sounds each limit state of each body at each level until some seconds are over: the rest is taken to be like what
/// was sounded so far. Nothing without rare events.
[[nodiscard]] RareForecast forecast_rare(CampaignSpec const& spec);

}  // namespace overturn
