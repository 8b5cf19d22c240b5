/// One trial that was computed again, in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"

namespace overturn::output {

/// "trial 17: wave number 3 (id 7), body cask, pga 600 gal", then its verdict and its peak. \param wave its number
[[nodiscard]] std::string trial_text(CampaignSpec const& spec, TrialRow const& row, std::int64_t trial,
                                     std::int64_t wave);

/// Title of a figure: "cask, trial 17 (nearest-miss): wave 3, KOBE at 600 gal, overturned". \param words why it is
/// shown \param record name of its wave; both may be empty
/// \param record name of its wave; both may be empty
[[nodiscard]] std::string trial_title(CampaignSpec const& spec, TrialRow const& row, std::int64_t trial,
                                      std::int64_t wave, std::string const& words = {}, std::string const& record = {});

/// "bit-equal to the stored row", or the columns that differ.
[[nodiscard]] std::string difference_text(std::vector<std::string> const& different);

}  // namespace overturn::output
