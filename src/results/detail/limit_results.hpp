/// Limit states of the user's own, and the responses per level, in the results file and on the terminal.
#pragma once

#include <string>
#include <vector>

#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// What describes a column of probabilities where there can be none.
inline constexpr char const* no_chance = "NaN: the waves are a grid of frequencies and no sample";

/// /limits/<name>: its definition; stripes/<body> and fragility/<body> in it. Nothing where there are none.
void write_limits(store::ResultsWriter& file, CampaignSpec const& spec, Statistics const& statistics,
                  std::vector<BodyAnalysis> const& analysis);

/// /quantiles/<body>: median, 84 % and 95 % of peak slip and rotation per level, each with its interval.
void write_quantiles(store::ResultsWriter& file, CampaignSpec const& spec, BodyAnalysis const& body);

/// What the trials say of the limit states is what they said when the file was made. \throws InputError
void require_stored_limits(store::ResultsReader const& file, CampaignSpec const& spec, BodyStatistics const& counted);

/// The stripes of one limit state of a body, with what is to be known of them.
[[nodiscard]] std::string limit_stripes_text(CampaignSpec const& spec, BodyStatistics const& counted,
                                             std::size_t limit);

/// The responses of a body level by level; empty if it never moved.
[[nodiscard]] std::string quantiles_text(BodyAnalysis const& body, double confidence);

}  // namespace overturn
