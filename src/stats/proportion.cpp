#include "stats/proportion.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"

namespace overturn {

Interval clopper_pearson(std::int64_t successes, std::int64_t trials, double confidence) {
    OVERTURN_EXPECT(successes >= 0 && successes <= trials);
    OVERTURN_EXPECT(confidence > 0 && confidence < 1);
    if (trials == 0) {
        return {};
    }
    double const tail = 0.5 * (1 - confidence);
    auto const k = static_cast<double>(successes);
    auto const misses = static_cast<double>(trials - successes);
    Interval interval;
    if (successes > 0) {
        interval.lower = gsl_cdf_beta_Pinv(tail, k, misses + 1);
    }
    if (successes < trials) {
        interval.upper = gsl_cdf_beta_Qinv(tail, k + 1, misses);
    }
    return interval;
}

}  // namespace overturn
