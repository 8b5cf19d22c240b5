/// The hazard curve of a results file: that of --hazard, else that of its campaign; and what a report says with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "results/analysis.hpp"
#include "results/hazard_frequency.hpp"
#include "results/statistics.hpp"
#include "stats/hazard.hpp"

namespace overturn::cli {

/// Reads it over the campaign's levels. \param path of --hazard; empty: none \return none where there is none \throws
/// InputError also for waves on a grid of frequencies, which are no sample
[[nodiscard]] std::optional<HazardCurve> hazard_of_campaign(std::string const& path, CampaignInput const& input,
                                                            CampaignSpec const& spec);

/// Adds to a report's data `fit.frequency` and `fit.frequency_parts`, the notes on each row, and the curve as a fact.
/// \param path as hazard_of_campaign \param analysis of the same confidence \return the frequencies; none: no curve
std::vector<BodyFrequency> add_frequencies(std::string const& path, CampaignInput const& input,
                                           CampaignSpec const& spec, Statistics const& statistics,
                                           std::vector<BodyAnalysis> const& analysis, double confidence,
                                           nlohmann::ordered_json& data);

}  // namespace overturn::cli
