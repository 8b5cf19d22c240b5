/// A probability estimated from counts, with its exact interval.
#pragma once

#include <cstdint>

namespace overturn {

struct Interval {
    double lower = 0, upper = 1;
};

/// The least interval that holds both.
[[nodiscard]] Interval hull(Interval const& a, Interval const& b);

/// Clopper & Pearson (1934): the exact two-sided interval of a proportion; [0, 1] where nothing was tried.
/// \pre 0 <= successes <= trials; 0 < confidence < 1
[[nodiscard]] Interval clopper_pearson(std::int64_t successes, std::int64_t trials, double confidence);

/// The same of trials in groups of `group_size`, which share what was drawn: a group counts as one trial, so that the
/// interval is that of whole groups where those of a group end together, and wider than need be where they do not
/// (a design effect of `group_size`, the largest there is: Kish 1965). Parts of a group are rounded outwards.
/// \param least, most successes that are certain, and possible
[[nodiscard]] Interval clopper_pearson_of_groups(std::int64_t least, std::int64_t most, std::int64_t trials,
                                                 double group_size, double confidence);

}  // namespace overturn
