/// Recorded motions that are too few for percentiles, one by one.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "output/table.hpp"

namespace overturn::output {

/// The trials of few motions as people read them: a row for each record, body and level of the answer.
struct RecordSheet {
    std::vector<std::string> head;  ///< record, body, level, verdict, slip, tilt, the same over alpha, model, and the
                                    ///< nearest other limit if any
    std::vector<std::vector<std::string>> rows;
    std::string note;  ///< meaning of the verdicts of bodies that stand
};
/// \param trials of trials_of_few_waves
[[nodiscard]] RecordSheet record_sheet(CampaignSpec const& spec, std::span<TrialRow const> trials);

/// The same for the terminal. Empty without trials.
[[nodiscard]] std::string records_text(CampaignSpec const& spec, std::span<TrialRow const> trials);

/// The same in SI.
[[nodiscard]] Table records_table(CampaignSpec const& spec, std::span<TrialRow const> trials);

}  // namespace overturn::output
