/// Bounds on P from exact intervals, where there is no curve.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stats/fragility.hpp"

namespace overturn {

/// Stripes as they are, single trials in tenths.
[[nodiscard]] std::vector<FragilityPoint> proportions_of(FragilityData const& data);

/// Distinct waves with a trial between two intensities.
[[nodiscard]] std::int64_t waves_of(std::span<SingleTrial const> trials, double from = 0, double to = HUGE_VAL);

/// Nothing overturned: the highest stripe bounds P; everything did: the lowest. Single trials of one wave count as one.
[[nodiscard]] SeenBound tail_bound(FragilityData const& data, FragilityState state, double confidence);

/// Separated data whose step lies at the end of what was tried: the exact interval of the stripe there.
[[nodiscard]] SeenBound end_bound(FragilityData const& data, FragilityFit const& fit, double confidence);

/// If P does not fall with the intensity: the interval of the counts of several independent stripes together, whose
/// upper end bounds P at the lowest of them and whose lower end bounds it at the highest, exactly so (a sum of trials
/// that fall no less often than in p stochastically exceeds the binomial of p). Where nothing overturned, and where
/// what did holds no rise.
[[nodiscard]] std::optional<SeenBound> pooled_bound(FragilityData const& data, FragilityFit const& fit,
                                                    double confidence);

}  // namespace overturn
