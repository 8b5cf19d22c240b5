/// Rare events in the results file: what was estimated, and every draw behind it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "results/rare_rows.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// "rare/<body>" of overturning, "limits/<limit>/rare/<body>" of another limit state.
[[nodiscard]] std::string rare_group(CampaignSpec const& spec, std::size_t body, std::size_t limit,
                                     std::string const& table = "rare");

/// Between estimators in the text of those that were tried.
inline constexpr std::string_view between_tries = "; then ";

/// Beside the estimates in /rare/<body>: rows, every trial; mixture-N/stage-S, the pulses that its trials were drawn
/// from, of all replicates; subset-N, the factor.
void write_rare_record(store::ResultsWriter& file, CampaignSpec const& spec, std::span<RareBody const> bodies);

/// The estimates alone. Empty where the campaign has no rare events.
[[nodiscard]] std::vector<RareBody> read_rare_estimates(store::ResultsReader const& file, CampaignSpec const& spec);

}  // namespace overturn
