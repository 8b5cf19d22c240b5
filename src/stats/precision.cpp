#include "stats/precision.hpp"

#include <algorithm>
#include <cmath>

namespace overturn {

bool is_precise(std::span<Stripe const> stripes, double half_width, double confidence) {
    return std::all_of(stripes.begin(), stripes.end(), [&](Stripe const& stripe) {
        auto const interval = stripe.interval(confidence);
        return (interval.upper - interval.lower) / 2 <= half_width;
    });
}

bool is_precise(FragilityFit const& fit, double median_half_width) {
    if (!fit.identifiable()) {
        return false;
    }
    auto const& ends = fit.intervals().median;
    return (ends.upper - ends.lower) / 2 <= median_half_width * std::exp(fit.line->log_median());
}

std::vector<std::int64_t> looks(std::int64_t unit, std::int64_t least, std::int64_t most) {
    std::vector<std::int64_t> sizes;
    for (std::int64_t size = unit; size < most; size *= 2) {
        if (size >= least) {
            sizes.push_back(size);
        }
    }
    return sizes;
}

}  // namespace overturn
