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

}  // namespace overturn
