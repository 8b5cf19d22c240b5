/// Effect of a body's draws on its fragility: trials with their scores, and the part of beta that they make.
#pragma once

#include <optional>
#include <span>

#include "campaign/campaign_spec.hpp"
#include "stats/beta_split.hpp"
#include "stats/fragility_data.hpp"

namespace overturn {

/// beta_R and beta_U of one body from its trials; the draws are recomputed, as they are pure functions of the wave.
/// Nothing if the body does not scatter, or the trials hold no curve. \param key of the split's replicates
[[nodiscard]] std::optional<BetaSplit> split_by_draws(CampaignSpec const& spec, std::size_t body,
                                                      std::span<SingleTrial const> trials, BootstrapKey const& key);

}  // namespace overturn
