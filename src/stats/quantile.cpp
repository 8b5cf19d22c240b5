#include "stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include "core/shared_draws.hpp"
#include "stats/bootstrap.hpp"

namespace overturn {

namespace {

// Between the values that a share `below` and a share `above` of all lie outside of.
Interval between_shares(std::span<double const> values, double below, double above, Interval const& widest) {
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
    auto const outside = [&](double share) {
        constexpr double slack = 1e-9;  // (1 - 0.9) / 2 * 100 is a little less than 5
        return std::min(values.size(),
                        static_cast<std::size_t>(std::floor(share * static_cast<double>(values.size() + 1) + slack)));
    };
    // So few values say nothing of so high a confidence: the widest.
    auto const under = outside(below);
    auto const over = outside(above);
    return {under == 0 ? widest.lower : lows[under - 1], over == 0 ? widest.upper : highs[highs.size() - over]};
}

// The normal score at which the estimate stands among the values that are known; 0: it halves them.
double score_among(double estimate, std::span<double const> values) {
    double below = 0;
    double known = 0;
    for (double const x : values) {
        known += std::isnan(x) ? 0 : 1;
        below += x < estimate ? 1 : x == estimate ? 0.5 : 0;
    }
    if (known == 0) {
        return 0;
    }
    double const least = 0.5 / known;  // all on one side: the limit of so many trials
    return gsl_cdf_ugaussian_Pinv(std::clamp(below / known, least, 1 - least));
}

}  // namespace

Interval middle_of(std::span<double const> values, double confidence, Interval const& widest) {
    double const tail = (1 - confidence) / 2;
    return between_shares(values, tail, tail, widest);
}

Interval middle_about(double estimate, std::span<double const> values, double confidence, Interval const& widest) {
    double const half = gsl_cdf_ugaussian_Qinv((1 - confidence) / 2);
    double const moved = 2 * score_among(estimate, values);
    return between_shares(values, gsl_cdf_ugaussian_P(moved - half), gsl_cdf_ugaussian_Q(moved + half), widest);
}

std::int64_t fewest_for_quantile(double share) {
    constexpr double rounding = 1e-9;
    return std::max(least_waves, static_cast<std::int64_t>(std::ceil(1 / std::min(share, 1 - share) - rounding)));
}

double quantile(std::span<double const> sorted, double q) {
    return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), q);
}

namespace {

// The largest r with P(Bin(n, q) < r) <= risk: X_(r) lies above the quantile no oftener than that. 0: there is none.
std::int64_t lower_rank(std::int64_t n, double q, double risk) {
    auto const at_most = [&](std::int64_t k) {
        return gsl_cdf_binomial_P(static_cast<unsigned>(k), q, static_cast<unsigned>(n));
    };
    std::int64_t rank = 0;
    for (std::int64_t beyond = n + 1; beyond - rank > 1;) {
        auto const middle = rank + (beyond - rank) / 2;
        (at_most(middle - 1) <= risk ? rank : beyond) = middle;
    }
    return rank;
}

// As quantile, where values may be infinite: half way to infinity is there already.
double between(std::span<double const> sorted, double q) {
    double const place = q * static_cast<double>(sorted.size() - 1);
    auto const below = static_cast<std::size_t>(place);
    auto const next = std::min(below + 1, sorted.size() - 1);
    if (!std::isinf(sorted[next])) {
        return quantile(sorted, q);
    }
    return static_cast<double>(below) == place ? sorted[below] : sorted[next];
}

}  // namespace

SampleQuantile sample_quantile(std::span<double const> sorted, std::int64_t unplaced, double q, double confidence,
                               double group_size) {
    std::int64_t const known = sorted.size();
    auto const n = known + unplaced;
    SampleQuantile found{q, known == 0 ? std::numeric_limits<double>::quiet_NaN() : between(sorted, q), {}, {}};
    double const risk = (1 - confidence) / 2;
    // The upper end is the lower one of the mirrored sample. The unplaced lie where they move an end furthest.
    auto const rank = [&](double share) {  // of groups, then of the outermost in its group
        auto const of_groups = lower_rank(SharedDraws::whole(static_cast<double>(n) / group_size), share, risk);
        return of_groups == 0 ? 0 : SharedDraws::whole(group_size * static_cast<double>(of_groups - 1)) + 1;
    };
    auto const low = rank(q) - unplaced;
    auto const high = n + 1 - rank(1 - q);
    if (low >= 1) {
        found.lower = sorted[low - 1];
    }
    if (high <= known) {
        found.upper = sorted[high - 1];
    }
    return found;
}

}  // namespace overturn
