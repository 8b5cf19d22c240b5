/// Limit states of the user's own, and the responses per level, for the terminal.
#pragma once

#include <string>
#include <vector>

#include "results/analysis.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// P of a row of trials: "~0.0500" where undecided ones make it an estimate from part of them, "-" where none is
/// decided.
[[nodiscard]] std::string estimate_text(Stripe const& stripe);

/// Trials of a body at each level by one limit state, with what must be known of them. \param sample else without P
[[nodiscard]] std::string limit_stripes_text(CampaignSpec const& spec, BodyStatistics const& counted, std::size_t limit,
                                             bool sample);

/// Percentiles of slip and rotation of a body at each level; empty if it never moved.
[[nodiscard]] std::string quantiles_text(CampaignSpec const& spec, BodyAnalysis const& body, double confidence);

}  // namespace overturn::output
