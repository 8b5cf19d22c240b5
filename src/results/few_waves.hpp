/// Recorded motions that are too few for percentiles: what became of each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "stats/bootstrap.hpp"
#include "stats/fragility_data.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Are these recorded motions, and so few that each is shown by itself? Of more, percentiles say enough.
[[nodiscard]] bool are_few_records(CampaignSpec const& spec, std::int64_t waves);

/// Recorded motions from which a probability is stated.
inline constexpr std::int64_t least_records = least_waves;
/// Are these recorded motions, and too few for a probability, a curve and all that follows from one?
[[nodiscard]] bool are_too_few_records(CampaignSpec const& spec, std::int64_t waves);

/// Why these waves are no sample, of which probabilities, curves and percentiles are stated: `grid` or `few_records`;
/// nothing where they are one.
[[nodiscard]] std::optional<FragilityState> no_sample(CampaignSpec const& spec, std::int64_t waves);

/// All trials of a campaign of few recorded motions, in the order of /trials; none of any other.
[[nodiscard]] std::vector<TrialRow> trials_of_few_waves(CampaignSpec const& spec, store::ResultsReader const& file);

}  // namespace overturn
