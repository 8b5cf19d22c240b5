/// Content of a finished file: its campaign, its trials, and its statistics counted again.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "model/failure.hpp"
#include "results/statistics.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// The campaign a results file was made from.
[[nodiscard]] CampaignInput input_of(store::ResultsReader const& file);

/// The campaign numbered as its file is: of the waves that were drawn those whose rows it holds.
[[nodiscard]] Plan plan_in(store::ResultsReader const& file, CampaignSpec const& spec);

/// One trial as stored.
[[nodiscard]] TrialRows read_trial(store::ResultsReader const& file, CampaignSpec const& spec, std::int64_t number);

/// All statistics recomputed from the stored trials. Where none are held it takes the memory of some rows, and reads
/// the columns that are counted alone.
[[nodiscard]] Statistics recount(store::ResultsReader const& file, CampaignSpec const& spec,
                                 TrialsHeld held = TrialsHeld::all);

/// Calls `take` with the number and the row of every trial, in their order, in the memory of some rows. Of the rows
/// these columns are read; what else they hold, and columns that the file does not have, is as in `unknown`.
void each_trial(store::ResultsReader const& file, CampaignSpec const& spec, std::span<std::string_view const> columns,
                TrialRow const& unknown, std::function<void(std::int64_t, TrialRow const&)> const& take);

/// Calls `take` with the number and the reason of every trial that failed, in their order.
void each_failed(store::ResultsReader const& file, CampaignSpec const& spec,
                 std::function<void(std::int64_t, FailureReason)> const& take);

/// The columns, of those that the file has, in which two trials differ in any bit; those of a model with its name:
/// "contact/peak_crush".
[[nodiscard]] std::vector<std::string> differing_columns(store::ResultsReader const& file, CampaignSpec const& spec,
                                                         TrialRows const& a, TrialRows const& b);

}  // namespace overturn
