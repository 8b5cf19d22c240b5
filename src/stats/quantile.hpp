/// Quantiles of plain lists.
#pragma once

#include <span>

#include "stats/proportion.hpp"

namespace overturn {

/// Ends of the middle `confidence` of the values, NaN counting as whatever widens them; `widest` itself where that
/// middle would have to reach beyond the outermost values.
[[nodiscard]] Interval middle_of(std::span<double const> values, double confidence, Interval const& widest);

/// The value that a share `q` of the sorted values does not exceed, linear between them (Hyndman & Fan 1996, type 7).
/// \pre sorted, not empty
[[nodiscard]] double quantile(std::span<double const> sorted, double q);

}  // namespace overturn
