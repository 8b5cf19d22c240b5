/// Histories of the trials that a report shows.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "campaign/telling_trials.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

/// Of the trials worth a look, and of every body that some trial took to compliant points the nearest miss there:
/// rerun, as history_data with `body`, `trial` and `title`. At most twelve: those of one kind before the next, on
/// points last.
[[nodiscard]] nlohmann::ordered_json shown_trials(CampaignSpec const& spec, Plan const& plan,
                                                  std::span<TellingTrial const> telling,
                                                  store::ResultsReader const& file);

}  // namespace overturn::cli
