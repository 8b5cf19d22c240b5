/// The estimate that assumes only that P does not fall with intensity, and whether the data allow even that.
#pragma once

#include <span>
#include <vector>

#include "stats/fragility_data.hpp"

namespace overturn {

/// Neighbouring intensities that share one estimate.
struct PooledPoints {
    double from = 0, to = 0;  ///< intensities, SI
    double trials = 0, overturned = 0;
    std::size_t points = 0;  ///< number of pooled points

    [[nodiscard]] double probability() const { return overturned / trials; }
};

/// Pool adjacent violators (Ayer, Brunk, Ewing, Reid & Silverman 1955): the maximum likelihood among all rising
/// estimates. \param points rising
[[nodiscard]] std::vector<PooledPoints> isotonic_estimate(std::span<FragilityPoint const> points);

/// Interval in which the isotonic estimate passes 1/2: [highest intensity with P < 1/2, lowest with P >= 1/2], open
/// ends 0 and infinity.
[[nodiscard]] Interval isotonic_median(std::span<PooledPoints const> pools);

/// Test whether the points rise.
struct MonotoneTest {
    double deviance = 0;  ///< of the isotonic estimate against a free one for every point; a group of trials as one
    int degrees_of_freedom = 0;  ///< points less pools; 0: the proportions rise throughout
    double p_value = 1;          ///< of so much by chance (`test_shape`)
};
/// Without its chance.
[[nodiscard]] MonotoneTest test_monotone(std::span<FragilityPoint const> points);

}  // namespace overturn
