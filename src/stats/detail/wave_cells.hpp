/// Counts of each wave's trials in the cells of a trial list: all that resampling by waves needs, however many there
/// are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random_stream.hpp"
#include "stats/fragility_data.hpp"

namespace overturn {

/// Counts are whole numbers, so that sums over waves are exact in any order. Holds 12 bytes for each cell of a wave.
class WaveCells {
  public:
    /// \param most cells, as cells_of
    WaveCells(std::span<SingleTrial const> trials, std::size_t most);

    [[nodiscard]] std::vector<FragilityPoint> const& points() const { return points_; }
    [[nodiscard]] std::size_t waves() const { return first_of_wave_.size() - 1; }
    /// Points of a resample: as many waves drawn with replacement, each with all its trials.
    [[nodiscard]] std::vector<FragilityPoint> draw(RandomStream& stream) const;

  private:
    struct Entry {
        std::uint32_t cell = 0, trials = 0, overturned = 0;
    };
    void add(std::size_t cell, bool overturned);

    std::vector<FragilityPoint> points_;
    std::vector<Entry> entries_;              ///< wave by wave, in the order of their numbers
    std::vector<std::size_t> first_of_wave_;  ///< its first entry; at the end how many there are
};

}  // namespace overturn
