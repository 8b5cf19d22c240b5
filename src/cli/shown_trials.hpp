/// Histories of the trials that a report shows.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

/// Of every body that some trial took to compliant points: the trial that came nearest to overturning and stood, rerun;
/// its history thinned to what a figure can show, and the outline of its base. At most twelve.
[[nodiscard]] nlohmann::ordered_json shown_trials(CampaignSpec const& spec, Plan const& plan,
                                                  store::ResultsReader const& file);

}  // namespace overturn::cli
