/// Stripes: all trials of one body at one level, counted. Counts are integers, so their order cannot matter.
#pragma once

#include <cstdint>

#include "stats/proportion.hpp"

namespace overturn {

/// Failed trials have no verdict, and some ends are beyond the model that saw them: both are undecided. They are left
/// out of the estimate and widen its interval, which holds whatever they would have done.
struct Stripe {
    double amplitude = 0;  ///< SI value of the level's measure
    std::int64_t trials = 0;
    std::int64_t overturned = 0;
    std::int64_t failed = 0;
    std::int64_t undecided = 0;  ///< besides those
    double group_size = 1;       ///< so many trials share what was drawn, and count as one in the interval

    [[nodiscard]] std::int64_t decided() const { return trials - failed - undecided; }
    /// Overturned over decided; NaN where nothing is decided.
    [[nodiscard]] double probability() const;
    /// Clopper-Pearson bounds over all trials: the lower one as if every undecided body stood, the upper one as if it
    /// fell. Of trials in groups: clopper_pearson_of_groups.
    [[nodiscard]] Interval interval(double confidence) const;
};

/// Predictions of a criterion "measure < limit: safe" against time histories.
struct Confusion {
    std::int64_t false_safe = 0;     ///< predicted safe, overturned: the count that matters
    std::int64_t false_alarm = 0;    ///< predicted unsafe, did not overturn
    std::int64_t true_safe = 0;      ///< predicted safe, stood
    std::int64_t true_overturn = 0;  ///< predicted unsafe, overturned

    std::int64_t undecided_safe = 0;    ///< predicted safe, no verdict
    std::int64_t undecided_unsafe = 0;  ///< predicted unsafe, no verdict

    void add(bool predicted_safe, bool overturned);
    void add_undecided(bool predicted_safe) { ++(predicted_safe ? undecided_safe : undecided_unsafe); }
};

}  // namespace overturn
