/// Does the lognormal curve describe the proportions it was fitted to?
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "stats/probit.hpp"

namespace overturn {

/// More are put into ten groups, as single trials are.
inline constexpr std::size_t stripes_at_most = 40;

struct GoodnessOfFit {
    double deviance = 0;         ///< twice the log likelihood that the curve falls short of a free proportion per group
    int degrees_of_freedom = 0;  ///< groups less two; 0: nothing left to judge by
    double p_value = 1;          ///< of so large a deviance by chance (`test_shape`)
    bool chi_squared = false;    ///< few groups, in which the curve expects many: p_value is that of chi squared
    /// Chance of the stripe (or tenth of the trials) farthest from the curve: twice its exact binomial tail, times
    /// their number (Bonferroni). It finds what pooling hides, such as a single overturning where the curve holds none.
    double stripe_p_value = 1;

    /// Chance of both counts together (Bonferroni).
    [[nodiscard]] double least_p_value() const { return std::min(1.0, 2 * std::min(p_value, stripe_p_value)); }
};

/// The deviance and the exact tails; a group of trials counts as one (Rao & Scott 1984 with the largest design
/// effect there is). Single trials are put into ten groups (Hosmer & Lemeshow 1980); then neighbours are pooled until
/// the curve expects at least one to fall and one to stand in each. The chance of the deviance is that of chi squared
/// where at most twenty groups expect five or more (Cochran 1954); elsewhere 1, until `test_shape` finds it.
[[nodiscard]] GoodnessOfFit goodness_of_fit(std::span<FragilityPoint const> points, ProbitLine const& line);

/// The deviance alone, pooled likewise.
[[nodiscard]] GoodnessOfFit deviance_from(std::span<FragilityPoint const> points, ProbitLine const& line);

}  // namespace overturn
