/// The statistics of a campaign as JSON: its tables, and what they mean in words. What is not known is null, never 0.
#pragma once

#include <span>
#include <vector>

#include "output/json.hpp"
#include "output/sections.hpp"
#include "output/table.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// Units in the sentences of `warnings`: all numbers beside them are SI, a page shows them as levels are written.
enum class WarningUnits { si, as_written };

/// `warnings` of curves: a sentence each, with its body, limit state and measure.
[[nodiscard]] Json warnings_json(std::string const& body, std::span<MeasuredFragility const> fits, double confidence,
                                 WarningUnits units = WarningUnits::si);

/// All tables of the campaign (campaign_tables), `variability`, `verdict`, `warnings`, and `cautions` of the answer.
[[nodiscard]] Json fit_json(CampaignSpec const& spec, Statistics const& statistics,
                            std::span<BodyAnalysis const> analysis, double confidence,
                            WarningUnits units = WarningUnits::si);

/// Tables of `fit --json` that are in no file.
[[nodiscard]] std::vector<Table> json_tables(Printed const& of);
/// The same of a campaign without results, and those of tables and stated curves: their columns.
[[nodiscard]] std::vector<Table> empty_json_tables(CampaignSpec const& spec);

}  // namespace overturn::output
