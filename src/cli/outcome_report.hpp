/// Real outcomes as the report's scripts take them.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

/// The table at `path` (parse_outcomes) beside the campaign: `motions`, `names` of records, `specimens` with `name`,
/// `bodies` and `outcomes` (-1 not tested, 0 stood, 1 fell), all by wave; `level` at which waves are as measured, of so
/// many `levels`; `histories` (history_data) of trials that stood though their test fell. Null where `path` is empty.
/// \throws InputError as parse_outcomes; if the file cannot be read
[[nodiscard]] nlohmann::ordered_json outcomes_data(std::string const& path, CampaignSpec const& spec, Plan const& plan,
                                                   store::ResultsReader const& file);

}  // namespace overturn::cli
