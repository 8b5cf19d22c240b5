/// How large chance makes the distance of two distribution functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "stats/detail/extended_real.hpp"
#include "stats/kolmogorov.hpp"

namespace overturn::testing {

using overturn::ks_distance;  // between two empirical ones

struct KolmogorovTest {
    double distance = 0;  ///< largest |F - G|; NaN where a sample is empty
    double p_value = 1;   ///< of so large a distance by chance; NaN likewise
    double band = 0;      ///< half width of the 95 % band about a distribution function: larger distances are no chance
};

/// Between the empirical distribution function and a continuous one; NaN if there is no value.
inline double ks_distance(std::vector<double> values, std::function<double(double)> const& distribution) {
    if (values.empty()) {
        return unknown;
    }
    std::sort(values.begin(), values.end());
    auto const count = static_cast<double>(values.size());
    double distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto const below = static_cast<double>(i);
        double const at = distribution(values[i]);
        distance = std::max({distance, (below + 1) / count - at, at - below / count});
    }
    return distance;
}

inline double stretch(double size) {
    double const root = std::sqrt(size);
    return root + 0.12 + 0.11 / root;  // Stephens (1970)
}

/// P(distance > d) for `size` values, asymptotic with Stephens' (1970) correction, good to 1 % from 8 values on.
/// Of two samples of n and m the size is n m / (n + m). Ties make it larger than the truth.
inline double ks_p_value(double distance, double size) {
    if (std::isnan(distance) || !(size > 0)) {
        return unknown;
    }
    double const x = stretch(size) * distance;
    constexpr double nothing_beyond = 0.2;  // below it the series needs many terms and is 1 to 12 digits
    if (x < nothing_beyond) {
        return 1;
    }
    double sum = 0;
    double sign = 1;
    constexpr int most_terms = 100;
    for (int k = 1; k <= most_terms; ++k) {
        double const term = std::exp(-2 * x * x * k * k);
        sum += sign * term;
        sign = -sign;
        if (term < 1e-17) {
            break;
        }
    }
    return std::clamp(2 * sum, 0.0, 1.0);
}

inline KolmogorovTest test_of(double distance, double size) {
    constexpr double critical = 1.3580986393225505;  // 5 % of the Kolmogorov distribution lies beyond
    return {distance, ks_p_value(distance, size), critical / stretch(size)};
}

inline KolmogorovTest ks_test(std::vector<double> const& a, std::vector<double> const& b) {
    auto const n = static_cast<double>(a.size());
    auto const m = static_cast<double>(b.size());
    return test_of(ks_distance(a, b), n * m / (n + m));
}

inline KolmogorovTest ks_test(std::vector<double> const& values, std::function<double(double)> const& distribution) {
    return test_of(ks_distance(values, distribution), static_cast<double>(values.size()));
}

}  // namespace overturn::testing
