#include "stats/detail/few_capacities.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>

#include "stats/detail/extended_real.hpp"

namespace overturn {

FewCapacities::FewCapacities(ProbitLine const& line, std::int64_t waves, double confidence)
    : mean_(line.log_median()),
      deviation_(line.beta() * std::sqrt(static_cast<double>(waves) / static_cast<double>(waves - 1))),
      n_(static_cast<double>(waves)),
      confidence_(confidence),
      z_(gsl_cdf_ugaussian_Pinv((1 + confidence) / 2)) {}

Interval FewCapacities::median() const {
    double const half = gsl_cdf_tdist_Pinv((1 + confidence_) / 2, n_ - 1) * deviation_ / std::sqrt(n_);
    return {std::exp(mean_ - half), std::exp(mean_ + half)};
}

Interval FewCapacities::beta() const {
    auto const end = [&](double share) { return deviation_ * std::sqrt((n_ - 1) / gsl_cdf_chisq_Pinv(share, n_ - 1)); };
    return {end((1 + confidence_) / 2), end((1 - confidence_) / 2)};
}

Interval FewCapacities::intensity(double probability) const {
    double const q = gsl_cdf_ugaussian_Pinv(probability);
    double const a = 1 - z_ * z_ / (2 * (n_ - 1));
    double const b = q * q - z_ * z_ / n_;
    if (a <= 0) {
        return {0, infinite};
    }
    double const root = std::sqrt(std::max(0.0, q * q - a * b));
    return {std::exp(mean_ + deviation_ * (q - root) / a), std::exp(mean_ + deviation_ * (q + root) / a)};
}

Interval FewCapacities::probability(double intensity) const {
    double const q = (std::log(intensity) - mean_) / deviation_;
    double const half = z_ * std::sqrt(1 / n_ + q * q / (2 * (n_ - 1)));
    return {gsl_cdf_ugaussian_P(q - half), gsl_cdf_ugaussian_P(q + half)};
}

}  // namespace overturn
