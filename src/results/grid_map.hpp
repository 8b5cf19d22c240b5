/// Outcome of a body over a grid of frequencies and levels. It replaces a fragility curve where waves are points of a
/// grid and no random sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "body/rigid_body.hpp"
#include "campaign/level_spec.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/rows.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// One frequency of the grid, over all levels; places of levels count from the lowest.
struct GridLine {
    GridLine(std::int64_t wave_number, double wave_period_s, std::size_t levels, std::size_t limits);

    /// Counts a trial of this wave; in any order.
    void add(TrialRow const& row, LimitOutcomes const& limits);

    std::int64_t wave;
    double period_s;
    std::vector<Verdict> ends;                      ///< by level
    std::optional<std::size_t> uplift;              ///< least level that lifted it off
    std::vector<std::optional<std::size_t>> least;  ///< by limit state, overturning first: least level that passed it
    std::optional<std::size_t>
        standing;                ///< highest level at which it stood: above the least that overturned it, maybe
    std::int64_t undecided = 0;  ///< levels without a verdict
};

/// All of them of one body.
struct GridMap {
    std::string measure;              ///< of the levels
    IntensityUnit shown_in;           ///< in which levels were written
    std::vector<double> levels;       ///< [SI]
    std::vector<std::string> limits;  ///< names of the limit states, overturning first
    std::vector<GridLine> lines;      ///< in the order of the waves

    /// The value of a level; NaN: none.
    [[nodiscard]] double value(std::optional<std::size_t> level) const;
};

/// The steady rotation over alpha of a body under a sinusoid whose level is this, by the paper's Eq. 1 (Spanos & Koh
/// 1984, linearised; at its central restitution). NaN where the level is no amplitude of a sinusoid (pga, pgv and pgd
/// are), does not lift the body off, or has no such steady state; of a body whose corners differ.
[[nodiscard]] double steady_rotation_ratio(LevelSpec const& levels, double level, double period_s,
                                           RigidBody const& body);

}  // namespace overturn
