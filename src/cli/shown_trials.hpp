/// Histories of the trials that a report shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "results/telling_trials.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

struct ShownTrials {
    nlohmann::ordered_json drawn;                      ///< a list: history_data with `body`, `trial` and `title`
    std::size_t bodies = 0;                            ///< number of their bodies
    std::vector<std::string> at_rest_at_design_basis;  ///< bodies that did not move there under any wave
};

/// A trial to be drawn, and the words for why to inspect it.
struct ChosenTrial {
    std::int64_t trial = 0;
    std::string words;
};

/// Histories of chosen trials, rerun. Trials that have no history (at rest) are left out.
[[nodiscard]] ShownTrials histories_of(CampaignSpec const& spec, Plan const& plan, std::span<ChosenTrial const> chosen);

/// Histories of the trials to inspect, and of each body's nearest miss among trials on compliant points, rerun. At most
/// twelve, or as many as there are bodies up to 24, shared fairly among the bodies. Of one body, those of one kind come
/// before the next, trials on points last.
[[nodiscard]] ShownTrials shown_trials(CampaignSpec const& spec, Plan const& plan,
                                       std::span<TellingTrial const> telling, store::ResultsReader const& file);

}  // namespace overturn::cli
