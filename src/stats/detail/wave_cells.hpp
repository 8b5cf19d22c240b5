/// Counts of each wave's trials in the cells of a trial list: all that resampling by waves needs, however many there
/// are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random_stream.hpp"
#include "stats/detail/drawn_waves.hpp"
#include "stats/detail/wave_sums.hpp"
#include "stats/fragility_data.hpp"

namespace overturn {

/// Counts are whole numbers, so that sums over waves are exact in any order. Waves with the same counts in every cell
/// are held once: 12 bytes for each cell of such a pattern.
class WaveCells {
  public:
    /// \param most cells, as cells_of
    WaveCells(std::span<SingleTrial const> trials, std::size_t most);

    [[nodiscard]] std::vector<FragilityPoint> const& points() const { return points_; }
    [[nodiscard]] std::size_t waves() const { return pattern_of_wave_.size(); }
    /// Distinct patterns of counts.
    [[nodiscard]] std::size_t patterns() const { return first_of_pattern_.size() - 1; }

  private:
    friend class WaveResamples;
    void add(std::size_t cell, bool overturned);
    void close_wave();

    std::vector<FragilityPoint> points_;
    std::vector<CellCount> entries_;               ///< pattern by pattern
    std::vector<std::uint32_t> pattern_of_wave_;   ///< in the order of their numbers
    std::vector<std::size_t> first_of_pattern_;    ///< its first entry; at the end how many there are
    std::vector<std::uint32_t> patterns_by_hash_;  ///< while patterns are found: 1 + number of one; 0: none
};

/// Resamples of a trial list: as many waves drawn with replacement, each with all its trials.
class WaveResamples {
  public:
    /// \param cells outlive it; resample r is drawn from the stream (seed, r, purpose, stream of the key)
    WaveResamples(WaveCells const& cells, BootstrapKey const& key, Purpose purpose);

    /// Points of a resample; several are drawn together, so ask for them in their order.
    [[nodiscard]] std::vector<FragilityPoint> const& points(int resample);

  private:
    WaveCells const& cells_;
    BootstrapKey key_;
    Purpose purpose_;
    DrawnWaves draws_;
    std::vector<double> sums_;
    std::int64_t drawn_from_ = -1;  ///< the first of those that are at hand
    std::vector<FragilityPoint> points_;
};

}  // namespace overturn
