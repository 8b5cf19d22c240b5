/// Distributions compared as a whole: the largest distance between two distribution functions, and how large chance
/// makes it.
#pragma once

#include <functional>
#include <vector>

namespace overturn {

struct KolmogorovTest {
    double distance = 0;  ///< largest |F - G|; NaN where a sample is empty
    double p_value = 1;   ///< of so large a distance by chance; NaN likewise
    double band = 0;      ///< half width of the 95 % band about a distribution function: larger distances are no chance
};

/// Largest distance between two empirical distribution functions (Kolmogorov 1933, Smirnov 1939); NaN if one is empty.
[[nodiscard]] double ks_distance(std::vector<double> a, std::vector<double> b);
/// Between the empirical distribution function and a continuous one; NaN if there is no value.
[[nodiscard]] double ks_distance(std::vector<double> values, std::function<double(double)> const& distribution);

/// P(distance > d) for `size` values, asymptotic with Stephens' (1970) correction, good to 1 % from 8 values on.
/// Of two samples of n and m the size is n m / (n + m). Ties make it larger than the truth.
[[nodiscard]] double ks_p_value(double distance, double size);

[[nodiscard]] KolmogorovTest ks_test(std::vector<double> const& a, std::vector<double> const& b);
[[nodiscard]] KolmogorovTest ks_test(std::vector<double> const& values,
                                     std::function<double(double)> const& distribution);

}  // namespace overturn
