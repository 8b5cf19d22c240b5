/// Does the lognormal curve describe the proportions it was fitted to?
#pragma once

#include <span>

#include "stats/probit.hpp"

namespace overturn {

struct GoodnessOfFit {
    double deviance = 0;         ///< twice the log likelihood that the curve falls short of a free proportion per group
    int degrees_of_freedom = 0;  ///< groups less two; 0: nothing left to judge by
    double p_value = 1;          ///< of so large a deviance by chance (chi squared); trials taken as independent
};

/// The deviance test. Single trials are put into ten groups (Hosmer & Lemeshow 1980); then neighbours are pooled until
/// the curve expects at least one to fall and one to stand in each (Cochran 1954), since chi squared fails below.
[[nodiscard]] GoodnessOfFit goodness_of_fit(std::span<FragilityPoint const> points, ProbitLine const& line);

}  // namespace overturn
