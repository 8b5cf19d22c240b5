/// Counts of a campaign's waves, in words.
#pragma once

#include <string>

#include "results/achieved_sigma.hpp"
#include "results/missed_clauses.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// "200 waves that meet srp-3.7.1; 31 of 231 drawn were refused, 13.4 % [9.3 %, 18.5 %]"; empty if there is nothing
/// to say.
[[nodiscard]] std::string waves_text(WaveCounts const& counts, Acceptance const& acceptance, double confidence);

/// A line for each: "lowest ratio, vertical: missed by 81 waves, worst 0.78 (at 0.031 s to 0.12 s)".
[[nodiscard]] std::string missed_clauses_text(MissedClauses const& missed);

/// "achieved sd of ln (stated of Sa), over 40 targets: pga 0.49 +- 0.06 (0.6 at 0.02 s, the shortest matched), ..."
[[nodiscard]] std::string sigma_text(AchievedSigma const& sigma);

}  // namespace overturn::output
