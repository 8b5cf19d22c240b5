#include "stats/distribution.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr double ulp = 0x1p-53;

// What lies outside (0, 1) by rounding comes back to its edge.
double inside(double u) { return std::clamp(u, ulp, 1 - ulp); }

}  // namespace

Distribution Distribution::fixed(double value) { return normal(value, 0); }

Distribution Distribution::normal(double mean, double deviation) {
    validate(std::isfinite(mean) && std::isfinite(deviation) && deviation >= 0,
             "mean {} with standard deviation {} (no normal distribution). Give finite numbers, deviation >= 0", mean,
             deviation);
    return {Shape::normal, mean, deviation};
}

Distribution Distribution::lognormal(double median, double beta) {
    validate(std::isfinite(median) && median > 0 && std::isfinite(beta) && beta >= 0,
             "median {} with beta {} (no lognormal distribution). Give finite numbers, median > 0, beta >= 0", median,
             beta);
    return {Shape::lognormal, median, beta};
}

Distribution Distribution::uniform(double low, double high) {
    validate(std::isfinite(low) && std::isfinite(high) && low <= high,
             "from {} to {} (no interval). Give finite numbers, the lower one first", low, high);
    return {Shape::uniform, 0.5 * (low + high), 0.5 * (high - low)};
}

Distribution Distribution::truncated(double low, double high) const {
    constexpr double least_share = 0.01;
    auto bounded = *this;
    bounded.low_ = std::max(low, low_);
    bounded.high_ = std::min(high, high_);
    if (!scatters()) {
        validate(centre_ >= bounded.low_ && centre_ <= bounded.high_, "{} (not between {} and {})", centre_,
                 bounded.low_, bounded.high_);
        return bounded;
    }
    bounded.share_low_ = share_below(bounded.low_);
    bounded.share_high_ = share_below(bounded.high_);
    validate(bounded.share_high_ - bounded.share_low_ >= least_share,
             "only {:.2g} of it lies between {} and {} (what is left is another distribution). State that one",
             std::max(0.0, bounded.share_high_ - bounded.share_low_), bounded.low_, bounded.high_);
    return bounded;
}

double Distribution::share_below(double value) const {
    switch (shape_) {
        case Shape::normal:
            return gsl_cdf_ugaussian_P((value - centre_) / spread_);
        case Shape::lognormal:
            return value > 0 ? gsl_cdf_ugaussian_P(std::log(value / centre_) / spread_) : 0;
        case Shape::uniform:
            break;
    }
    return std::clamp(0.5 * (1 + (value - centre_) / spread_), 0.0, 1.0);
}

double Distribution::quantile(double u) const {
    OVERTURN_EXPECT(u > 0 && u < 1);
    if (!scatters()) {
        return centre_;
    }
    double const share = inside(share_low_ + u * (share_high_ - share_low_));
    double value = 0;
    switch (shape_) {
        case Shape::normal:
            value = centre_ + spread_ * gsl_cdf_ugaussian_Pinv(share);
            break;
        case Shape::lognormal:
            value = centre_ * std::exp(spread_ * gsl_cdf_ugaussian_Pinv(share));
            break;
        case Shape::uniform:
            value = centre_ + spread_ * (2 * share - 1);
            break;
    }
    return std::clamp(value, low_, high_);
}

double Distribution::score(double value) const {
    if (!scatters()) {
        return 0;
    }
    return gsl_cdf_ugaussian_Pinv(inside((share_below(value) - share_low_) / (share_high_ - share_low_)));
}

double Distribution::centre() const { return std::clamp(centre_, low_, high_); }
double Distribution::lowest() const { return quantile(ulp); }
double Distribution::highest() const { return quantile(1 - ulp); }

}  // namespace overturn
