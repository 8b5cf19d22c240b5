/// Why more waves cannot meet a target precision.
#pragma once

#include <span>
#include <string>

#include "stats/fragility.hpp"
#include "stats/stripe.hpp"

namespace overturn::output {

/// "cannot meet target_half_width = 0.05 (9 of 40 trials at one level have no verdict)": the exact interval of that
/// level stays wider. Empty: nothing prevents it.
[[nodiscard]] std::string half_width_obstacle(std::span<Stripe const> stripes, double half_width, double confidence);

/// "cannot meet target_median_half_width = 0.1 (nothing overturned)"; empty: nothing prevents it.
[[nodiscard]] std::string median_obstacle(FragilityFit const& fit, double half_width);

}  // namespace overturn::output
