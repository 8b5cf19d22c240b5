/// Counts level by level as tables: stripes of every limit state, the models that answered, the criterion, responses.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/table.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "stats/capacity_fit.hpp"

namespace overturn::output {

/// `stripes` of one body and limit state, a row per level. \param sample else counts without a probability (no_sample)
[[nodiscard]] Table stripe_table(CampaignSpec const& spec, BodyStatistics const& body, std::size_t limit,
                                 double confidence, bool sample);
/// `stripes` of a table without a campaign. \param unit of its amplitudes, as it states them; "1": none
[[nodiscard]] Table stripe_table(std::span<Stripe const> stripes, std::string const& unit, double confidence);
/// `capacities`: one row on a table of capacities. \param unit of them; empty: none
[[nodiscard]] Table capacities_table(std::span<Capacity const> capacities, std::string const& unit);
/// `models`: trials per model that answered them.
[[nodiscard]] Table model_table(BodyStatistics const& body);
/// `criterion_by_level`: how a criterion did against time histories. \param measure "v_wes" or "ou_v_e"
[[nodiscard]] Table criterion_level_table(CampaignSpec const& spec, BodyStatistics const& body,
                                          std::string const& measure, std::vector<Confusion> const& cells);
/// `quantiles`: one response of a body level by level. \pre rows of one quantity
[[nodiscard]] Table quantile_table(CampaignSpec const& spec, std::string const& body,
                                   std::span<LevelQuantiles const> rows, double confidence);
/// `grid`: a row per frequency, of waves that are one.
[[nodiscard]] Table grid_table(CampaignSpec const& spec, BodySpec const& body, GridMap const& map);
/// `grid_by_level`: a row per frequency and level.
[[nodiscard]] Table grid_level_table(CampaignSpec const& spec, BodySpec const& body, GridMap const& map);

}  // namespace overturn::output
