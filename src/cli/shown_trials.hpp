/// Histories of the trials that a report shows.
#pragma once

#include <cstddef>
#include <span>

#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "campaign/telling_trials.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

struct ShownTrials {
    nlohmann::ordered_json drawn;  ///< a list: history_data with `body`, `trial` and `title`
    std::size_t bodies = 0;        ///< how many bodies they are of
};

/// Of the trials worth a look, and of every body that some trial took to compliant points the nearest miss there,
/// rerun. Twelve, or as many as there are bodies up to 24, shared fairly among the bodies; of a body those of one kind
/// before the next, on points last.
[[nodiscard]] ShownTrials shown_trials(CampaignSpec const& spec, Plan const& plan,
                                       std::span<TellingTrial const> telling, store::ResultsReader const& file);

}  // namespace overturn::cli
