#include "rocking/page_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace overturn::rocking {

PagePeaks::PagePeaks(std::span<double const> horizontal, std::span<double const> vertical)
    : pages_(horizontal.size() / page) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        auto& peaks = pages_[i];
        for (double const a : horizontal.subspan(i * page, page)) {
            peaks.strongest = std::max(peaks.strongest, std::abs(a));
        }
        if (!vertical.empty()) {
            auto const [lowest, highest] = std::ranges::minmax(vertical.subspan(i * page, page));
            peaks.lowest = lowest;
            peaks.highest = highest;
        }
    }
}

}  // namespace overturn::rocking
