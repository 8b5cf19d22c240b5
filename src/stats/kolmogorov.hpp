/// Distributions compared as a whole: the largest distance between two distribution functions.
#pragma once

#include <vector>

namespace overturn {

/// Largest distance between two empirical distribution functions (Kolmogorov 1933, Smirnov 1939); NaN if one is empty.
[[nodiscard]] double ks_distance(std::vector<double> a, std::vector<double> b);

}  // namespace overturn
