/// All tables of a campaign: what its results file holds and `fit --json` prints, by the same names.
#pragma once

#include <span>
#include <vector>

#include "output/table.hpp"
#include "results/analysis.hpp"
#include "results/rare_rows.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// Bodies, stripes, models, curves, criterion, quantiles or grid, responses, bodies together, limit states, sigma:
/// those of overturning first. \param analysis of these statistics, at this confidence
[[nodiscard]] std::vector<Table> campaign_tables(CampaignSpec const& spec, Statistics const& statistics,
                                                 std::span<BodyAnalysis const> analysis, double confidence);
/// Tables of rare events, for all bodies and limit states.
[[nodiscard]] std::vector<Table> rare_tables(CampaignSpec const& spec, std::span<RareBody const> bodies);

}  // namespace overturn::output
