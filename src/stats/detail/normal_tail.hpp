/// Tails of the normal distribution where they underflow.
#pragma once

#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_erf.h>

namespace overturn {

/// exp(z^2 / 2) times the upper tail Q(z): Mills' ratio over sqrt(2 pi). \pre z >= 0
[[nodiscard]] inline double scaled_upper_tail(double z) {
    return 1 / (std::sqrt(2 * std::numbers::pi) * gsl_sf_hazard(z));
}

}  // namespace overturn
