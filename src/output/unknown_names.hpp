/// Names in a results file of another program that this one does not know, in words.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "store/results_file.hpp"

namespace overturn::output {

/// "verdict 'crushed' is not known to this program: its trials count as rocked", "model 'tether' is not known to this
/// program: its 3 trials count under no model": a line of verdicts and one of models, where there are such.
[[nodiscard]] std::vector<std::string> unknown_names_text(store::ResultsReader const& file);

/// "columns that this program does not know: trials/lift"; empty where there are none.
[[nodiscard]] std::string unknown_columns_text(store::ResultsReader const& file, CampaignSpec const& spec);

/// "it has no trials/v_wes: results that need it are not known"; empty where the file has all columns of trials and
/// waves that this program would write.
[[nodiscard]] std::string absent_columns_text(store::ResultsReader const& file, CampaignSpec const& spec);

}  // namespace overturn::output
