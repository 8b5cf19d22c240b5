/// Tables of the waves' acceptance by the rule.
#pragma once

#include <vector>

#include "campaign/campaign_spec.hpp"
#include "output/table.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// `acceptance` (one row: how many were drawn and refused) and `missed_clauses` (what they missed, by component and
/// period). Without rows where there is no rule.
[[nodiscard]] std::vector<Table> acceptance_tables(CampaignSpec const& spec, Statistics const& statistics,
                                                   double confidence);

}  // namespace overturn::output
