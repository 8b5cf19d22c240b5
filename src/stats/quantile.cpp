#include "stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_statistics_double.h>

namespace overturn {

Interval middle_of(std::span<double const> values, double confidence, Interval const& widest) {
    if (values.empty()) {
        return widest;
    }
    std::vector<double> lows(values.begin(), values.end());
    auto highs = lows;
    std::replace_if(
        lows.begin(), lows.end(), [](double x) { return std::isnan(x); }, widest.lower);
    std::replace_if(
        highs.begin(), highs.end(), [](double x) { return std::isnan(x); }, widest.upper);
    std::sort(lows.begin(), lows.end());
    std::sort(highs.begin(), highs.end());
    // Outwards to a whole replicate.
    constexpr double slack = 1e-9;  // (1 - 0.9) / 2 * 100 is a little less than 5
    auto const outside =
        static_cast<std::size_t>(std::floor((1 - confidence) / 2 * static_cast<double>(values.size() + 1) + slack));
    if (outside == 0) {
        return widest;  // so few values say nothing of so high a confidence
    }
    auto const rank = outside - 1;
    return {lows[rank], highs[highs.size() - 1 - rank]};
}

double quantile(std::span<double const> sorted, double q) {
    return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), q);
}

}  // namespace overturn
