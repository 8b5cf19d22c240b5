/// Differences between the trials of two settings: verdicts, peaks and distributions.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "campaign/rows.hpp"

namespace overturn::cost {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Statistics of a set of errors; not_known where it is empty.
struct Spread {
    std::int64_t count = 0;
    double median = not_known;
    double p95 = not_known;  ///< the smallest value that 95 % do not exceed
    double worst = not_known;
};

/// Quantiles by nearest rank: each is one of the values.
[[nodiscard]] Spread spread_of(std::vector<double> values);

/// Trials of one setting against the same trials of a reference.
struct Comparison {
    std::int64_t trials = 0;             ///< with a verdict in at least one of the two
    std::int64_t flips = 0;              ///< other verdict, whichever
    std::int64_t overturning_flips = 0;  ///< other fate: overturned, stood, undecided (contact lost or failed)
    Spread peak;                         ///< |peak rotation / reference - 1| of trials that rocked in both
    double probability = not_known;      ///< overturned over decided
    double probability_error = not_known;
    double ks = not_known;  ///< of peak rotation over alpha, all trials with a verdict
};

/// \pre rows[i] and reference[i] are the same trial
[[nodiscard]] Comparison compare(std::span<TrialRow const> rows, std::span<TrialRow const> reference);

}  // namespace overturn::cost
