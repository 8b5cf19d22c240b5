/// Waves drawn with replacement, for several resamples at once: how often each comes up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random_stream.hpp"
#include "simd/lane_values.hpp"
#include "stats/bootstrap.hpp"

namespace overturn {

/// Counts by groups: waves whose trials are equal in all that is asked of them count together. Counts are whole
/// numbers in doubles, exact in any order.
class DrawnWaves {
  public:
    static constexpr std::size_t at_once = simd::sweep_lanes;

    /// \param group_of_wave of each wave, in the order of their numbers
    DrawnWaves(std::vector<std::uint32_t> group_of_wave, std::size_t groups);

    [[nodiscard]] std::size_t waves() const { return group_of_wave_.size(); }
    /// Draws resamples from `first` on: of each as many waves as there are, from its stream (seed, resample, purpose,
    /// stream of the key).
    void draw(BootstrapKey const& key, Purpose purpose, std::int64_t first);
    /// Of each group in turn, how often its waves were drawn in each of the resamples.
    [[nodiscard]] std::span<double const> times() const { return times_; }

  private:
    std::vector<std::uint32_t> group_of_wave_;
    std::vector<std::uint32_t> counts_;          ///< of one resample
    std::array<std::uint32_t, 1024> numbers_{};  ///< of waves, some at a time
    std::vector<double> times_;
};

}  // namespace overturn
