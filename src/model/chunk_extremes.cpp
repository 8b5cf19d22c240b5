#include "model/chunk_extremes.hpp"

#include <algorithm>
#include <cmath>

namespace overturn {

ChunkExtremes::ChunkExtremes(std::span<double const> horizontal, std::span<double const> vertical)
    : chunks_(horizontal.size() / samples) {
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
        auto& extremes = chunks_[i];
        for (double const a : horizontal.subspan(i * samples, samples)) {
            extremes.strongest = std::max(extremes.strongest, std::abs(a));
        }
        if (!vertical.empty()) {
            auto const [lowest, highest] = std::ranges::minmax(vertical.subspan(i * samples, samples));
            extremes.lowest = lowest;
            extremes.highest = highest;
        }
    }
}

}  // namespace overturn
