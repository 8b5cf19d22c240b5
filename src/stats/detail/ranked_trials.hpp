/// Trials in rising order of a measure, to count pairs in them and in resamples of their waves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "stats/detail/drawn_waves.hpp"
#include "stats/detail/wave_sums.hpp"

namespace overturn {

/// Counts are whole numbers and halves, exact in any order. Only trials whose order counts are sorted.
class RankedTrials {
  public:
    explicit RankedTrials(std::span<SingleTrial const> trials);
    /// As rank_area.
    [[nodiscard]] double area() const;
    /// The same of the waves resampled, so many times.
    [[nodiscard]] std::vector<double> replicates(BootstrapKey const& key) const;

  private:
    void add_areas(std::span<double const> times, std::size_t most, std::vector<double>& areas) const;

    std::size_t waves_ = 0;
    std::vector<double> below_,
        above_;  ///< trials of each wave that stood below, or overturned above, all of the others
    std::vector<RankedTrial> between_;
};

}  // namespace overturn
