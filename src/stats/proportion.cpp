#include "stats/proportion.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "core/shared_draws.hpp"

namespace overturn {
namespace {

// P(X >= k) of a binomial, for 0 < k and p <= k/n: from k on the terms only fall.
double upper_tail(std::int64_t k, std::int64_t n, double p) {
    double const odds = p / (1 - p);
    double term = gsl_ran_binomial_pdf(static_cast<unsigned>(k), p, static_cast<unsigned>(n));
    double sum = 0;
    for (auto j = static_cast<double>(k); sum + term > sum; ++j) {
        sum += term;
        term *= odds * (static_cast<double>(n) - j) / (j + 1);
    }
    return sum;
}

// The p below k/n at which k or more successes have the probability `tail`. By bisection to the last bit: GSL's own
// inverse (gsl_cdf_beta_Pinv) does not converge for some of the counts a campaign has.
double lower_bound(std::int64_t k, std::int64_t n, double tail) {
    if (k == 0) {
        return 0;
    }
    double low = 0;
    double high = static_cast<double>(k) / static_cast<double>(n);
    for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high)) {
        (upper_tail(k, n, middle) < tail ? low : high) = middle;
    }
    return high;
}

}  // namespace

Interval hull(Interval const& a, Interval const& b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

Interval clopper_pearson(std::int64_t successes, std::int64_t trials, double confidence) {
    OVERTURN_EXPECT(successes >= 0 && successes <= trials);
    OVERTURN_EXPECT(confidence > 0 && confidence < 1);
    if (trials == 0) {
        return {};
    }
    double const tail = 0.5 * (1 - confidence);
    return {.lower = lower_bound(successes, trials, tail), .upper = 1 - lower_bound(trials - successes, trials, tail)};
}

Interval clopper_pearson_of_groups(std::int64_t least, std::int64_t most, std::int64_t trials, double group_size,
                                   double confidence) {
    OVERTURN_EXPECT(group_size >= 1 && least <= most);
    constexpr double rounding = 1e-9;
    auto const whole = [&](std::int64_t count) { return SharedDraws::whole(static_cast<double>(count) / group_size); };
    auto const begun = static_cast<std::int64_t>(std::ceil(static_cast<double>(most) / group_size - rounding));
    auto const groups = trials > 0 ? std::max<std::int64_t>(1, whole(trials)) : 0;
    return {clopper_pearson(std::min(whole(least), groups), groups, confidence).lower,
            clopper_pearson(std::min(begun, groups), groups, confidence).upper};
}

}  // namespace overturn
