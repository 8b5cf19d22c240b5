/// The statistics of a campaign as JSON: its tables, and what they mean in words. What is not known is null, never 0.
#pragma once

#include <span>

#include "output/json.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// Units in the sentences of `warnings`: all numbers beside them are SI, a page shows them as levels are written.
enum class WarningUnits { si, as_written };

/// `warnings` of curves: a sentence each, with its body, limit state and measure.
[[nodiscard]] Json warnings_json(std::string const& body, std::span<MeasuredFragility const> fits, double confidence,
                                 WarningUnits units = WarningUnits::si);

/// All tables of the campaign (campaign_tables), `variability`, `verdict` and `warnings`.
[[nodiscard]] Json fit_json(CampaignSpec const& spec, Statistics const& statistics,
                            std::span<BodyAnalysis const> analysis, double confidence,
                            WarningUnits units = WarningUnits::si);

}  // namespace overturn::output
