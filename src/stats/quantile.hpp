/// Quantiles of plain lists.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "stats/proportion.hpp"

namespace overturn {

/// Ends of the middle `confidence` of the values, NaN counting as whatever widens them; `widest` itself where that
/// middle would have to reach beyond the outermost values.
[[nodiscard]] Interval middle_of(std::span<double const> values, double confidence, Interval const& widest);

/// The same about an estimate that its replicates do not halve: the middle in normal scores, moved by twice the score
/// at which the estimate stands among them (bias-corrected percentiles: Efron 1981; Efron & Tibshirani 1993, 14.3 with
/// a = 0). Misses come as often on either side then, where those of the plain middle gather on one.
[[nodiscard]] Interval middle_about(double estimate, std::span<double const> values, double confidence,
                                    Interval const& widest);

/// The value that a share `q` of the sorted values does not exceed, linear between them (Hyndman & Fan 1996, type 7).
/// \pre sorted, not empty
[[nodiscard]] double quantile(std::span<double const> sorted, double q);

/// Independent values that a quantile needs: of fewer none is expected beyond it, and of fewer than five nothing is
/// known of the scatter. 20 for 5 and 95 %, 7 for 16 and 84 %.
[[nodiscard]] std::int64_t fewest_for_quantile(double share);

/// A quantile of what a sample was drawn from: the sample's own, and the distribution-free interval between two of its
/// order statistics, exact or wider (David & Nagaraja 2003, 7.1).
struct SampleQuantile {
    double share = 0;                    ///< q
    double value = 0;                    ///< of type 7, of the known values; NaN: there are none
    std::optional<double> lower, upper;  ///< empty: no value of the sample bounds it from that side
};

/// \param sorted known values, the last ones perhaps infinite \param unplaced further ones that may lie anywhere: they
/// widen the interval \param group_size so many of the sample share what was drawn, and count as one value in the
/// interval
[[nodiscard]] SampleQuantile sample_quantile(std::span<double const> sorted, std::int64_t unplaced, double q,
                                             double confidence, double group_size = 1);

}  // namespace overturn
