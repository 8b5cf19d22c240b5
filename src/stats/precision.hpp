/// Targets for the precision of a campaign's results.
#pragma once

#include <optional>
#include <span>

#include "stats/fragility.hpp"

namespace overturn {

/// Half widths at the campaign's confidence; empty: no target.
struct PrecisionTarget {
    std::optional<double> half_width;         ///< of P, at every stripe: (upper - lower) / 2 of its exact interval
    std::optional<double> median_half_width;  ///< of the fitted median: (upper - lower) / 2 over the median

    [[nodiscard]] bool enabled() const { return half_width || median_half_width; }
};

[[nodiscard]] bool is_precise(std::span<Stripe const> stripes, double half_width, double confidence);
/// False as long as there is no curve.
[[nodiscard]] bool is_precise(FragilityFit const& fit, double median_half_width);

/// The sample sizes at which a target may be looked at: `unit` times 1, 2, 4, ... from `least` on, below `most`. Few,
/// since all ranks wait at each. Over P from 0.5 % to 50 % exact 95 % intervals hold P at the end of at least 93.8 % of
/// all campaigns (94.6 % if one looked after every wave): the rule goes by their width, which hardly favours either
/// side.
[[nodiscard]] std::vector<std::int64_t> looks(std::int64_t unit, std::int64_t least, std::int64_t most);

}  // namespace overturn
