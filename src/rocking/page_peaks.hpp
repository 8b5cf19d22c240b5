/// Extremes of a wave by pages of samples: rest is skipped a page at a time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overturn::rocking {

class PagePeaks {
  public:
    static constexpr std::size_t page = 64;  ///< samples

    PagePeaks() = default;
    /// \param vertical may be empty
    PagePeaks(std::span<double const> horizontal, std::span<double const> vertical);

    struct Page {
        double strongest = 0;            ///< largest |horizontal|
        double lowest = 0, highest = 0;  ///< vertical
    };
    /// Of the whole page that begins at `sample`, if one does.
    [[nodiscard]] Page const* at(std::size_t sample) const {
        return sample % page == 0 && sample / page < pages_.size() ? &pages_[sample / page] : nullptr;
    }

  private:
    std::vector<Page> pages_;
};

}  // namespace overturn::rocking
