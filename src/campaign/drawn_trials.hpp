/// What the draws of a body say of its fragility: trials with their scores, and the part of beta that they make.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "stats/beta_split.hpp"
#include "stats/fragility_data.hpp"

namespace overturn {

/// The standard normal scores of what was drawn for one body, by wave; recomputed, as draws are pure functions.
class DrawnScores {
  public:
    DrawnScores(CampaignSpec const& spec, std::size_t body);

    /// Nothing if the body does not scatter, or the trials hold no curve.
    [[nodiscard]] std::optional<BetaSplit> split(std::span<SingleTrial const> trials) const;

  private:
    std::map<std::int64_t, std::vector<double>> scores_;
};

}  // namespace overturn
