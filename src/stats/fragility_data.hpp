/// Trials against an intensity measure: what a fragility is fitted to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stats/stripe.hpp"

namespace overturn {

/// One decided trial at its own value of a continuous measure.
struct SingleTrial {
    double intensity = 0;   ///< > 0, SI unit of the measure
    std::int64_t wave = 0;  ///< trials of one are resampled together
    bool overturned = false;
    std::int64_t id = 0;  ///< identity of its wave, where waves that share a draw count as one above
};

/// Trials at one intensity, or so near to each other that it makes no difference. Counts, exact in a double.
struct FragilityPoint {
    double log_intensity = 0;  ///< ln of the SI value; the mean of the trials'
    double trials = 0;         ///< decided ones
    double overturned = 0;
    double undecided = 0;   ///< tried there without a verdict
    double group_size = 1;  ///< so many trials share what was drawn, and count as one

    [[nodiscard]] double probability() const { return overturned / trials; }
    /// Trials that are independent, at least.
    [[nodiscard]] double groups() const { return trials / group_size; }
};

/// Stripes that decided anything, rising.
/// \pre every amplitude is above 0
[[nodiscard]] std::vector<FragilityPoint> points_of(std::span<Stripe const> stripes);

/// Trials sorted by intensity, equal ones together; more than `most` distinct values go into that many cells of equal
/// width in ln intensity. The error of beta^2 is (width / beta)^2 / 24 of it (Sheppard 1898).
/// \pre every intensity is above 0
[[nodiscard]] std::vector<FragilityPoint> points_of(std::span<SingleTrial const> trials, std::size_t most);

/// Points of a trial list, and the cell of every trial, in the trials' order.
struct Cells {
    std::vector<FragilityPoint> points;
    std::vector<std::size_t> cell_of_trial;
};
[[nodiscard]] Cells cells_of(std::span<SingleTrial const> trials, std::size_t most);

/// Neighbouring points put together into at most `most` groups of about equally many trials.
[[nodiscard]] std::vector<FragilityPoint> grouped(std::span<FragilityPoint const> points, std::size_t most);

[[nodiscard]] FragilityPoint sum_of(std::span<FragilityPoint const> points);

/// Why there is, or is not, a lognormal curve in the data.
enum class FragilityState : std::uint8_t {
    fitted = 0,
    no_trials = 1,
    none_overturned = 2,
    all_overturned = 3,
    one_level = 4,      ///< one intensity only
    separated = 5,      ///< all that stood below all that overturned: the likelihood grows for ever as beta -> 0
    not_rising = 6,     ///< the most likely curve falls, or its rise may be chance
    not_converged = 7,  ///< the solver gave up: ours to mend
    grid = 8,           ///< the waves are points of a grid and no sample: nothing was fitted
    undecided = 9,      ///< too many trials have no verdict: the median depends on what they would have done
    few_records = 10,   ///< recorded motions that are too few for a probability: nothing was fitted
    few_waves = 11,     ///< independent waves that are too few for a curve
};

/// State by the data alone, before any fit: fitted and not_rising are not yet distinguished.
/// Albert & Anderson (1984): the maximum is finite if and only if the outcomes overlap.
[[nodiscard]] FragilityState state_of(std::span<FragilityPoint const> points);

/// The step that separated data tend to: between the highest that stood and the lowest that overturned.
/// \pre state_of(points) is separated
[[nodiscard]] double separating_log_intensity(std::span<FragilityPoint const> points);

}  // namespace overturn
