/// Sums over waves that were drawn so and so often, of several resamples at once, in the machine's vector lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace overturn {

/// Trials of a wave in a cell.
struct CellCount {
    std::uint32_t cell = 0, trials = 0, overturned = 0;

    friend bool operator==(CellCount const&, CellCount const&) = default;
};

/// Adds to each cell its trials, and those that overturned, as often as their group was drawn.
/// \param first_of_group first entry of each group; at the end how many entries there are
/// \param times group by group, DrawnWaves::at_once numbers each \param sums cell by cell, so many of trials and so
/// many of those that overturned
void add_cell_counts(std::span<std::size_t const> first_of_group, std::span<CellCount const> entries,
                     std::span<double const> times, std::span<double> sums);

/// A trial in the order of rising intensity.
struct RankedTrial {
    double intensity = 0;
    std::uint32_t group = 0;
    std::uint32_t overturned = 0;
};

/// Pairs counted over trials in rising order: of `overturned` with what stood at less, and with half of what stood at
/// the same intensity.
struct RankSums {
    std::span<double> stood, overturned, above;  ///< DrawnWaves::at_once numbers each
};
void add_ranked(std::span<RankedTrial const> trials, std::span<double const> times, RankSums const& sums);

}  // namespace overturn
