/// Rank of a measure: how well it puts trials that overturned above trials that stood, whatever curve describes it.
#pragma once

#include <span>
#include <vector>

#include "stats/bootstrap.hpp"

namespace overturn {

/// The chance that a trial that overturned has the larger measure than one that stood, ties counting half: the area
/// under the receiver operating characteristic, Mann & Whitney's (1947) U over n m. NaN where one kind is missing.
[[nodiscard]] double rank_area(std::span<SingleTrial const> trials);
[[nodiscard]] double rank_area(std::span<FragilityPoint const> points);

/// rank_area, and the same of the data with waves resampled; replicates of one key drew the same waves, so that
/// measures on the same trials can be compared replicate by replicate. NaN where a replicate lacks one kind.
struct ResampledRank {
    double area = 0;
    std::vector<double> replicates;
};
[[nodiscard]] ResampledRank rank_area(std::span<SingleTrial const> trials, BootstrapKey const& key);

}  // namespace overturn
