/// Does the lognormal curve describe the proportions it was fitted to?
#pragma once

#include <algorithm>
#include <span>

#include "stats/probit.hpp"

namespace overturn {

struct GoodnessOfFit {
    double deviance = 0;         ///< twice the log likelihood that the curve falls short of a free proportion per group
    int degrees_of_freedom = 0;  ///< groups less two; 0: nothing left to judge by
    double p_value = 1;          ///< of so large a deviance by chance (chi squared)
    /// Of the stripe (or tenth of the trials) farthest from the curve: twice its exact binomial tail, times their
    /// number (Bonferroni). What pooling hides, a single overturning where the curve holds none, it finds.
    double stripe_p_value = 1;

    /// The smaller of both counts.
    [[nodiscard]] double least_p_value() const { return std::min(p_value, stripe_p_value); }
};

/// The deviance test; trials count as independent, groups of alike ones as one each (Rao & Scott 1984 with the largest
/// design effect there is). Single trials are put into ten groups (Hosmer & Lemeshow 1980); then neighbours are pooled
/// until the curve expects at least one to fall and one to stand in each (Cochran 1954), since chi squared fails below.
[[nodiscard]] GoodnessOfFit goodness_of_fit(std::span<FragilityPoint const> points, ProbitLine const& line);

}  // namespace overturn
