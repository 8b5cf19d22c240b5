/// Cumulative absolute velocity of a ground motion, and its standardised form.
#pragma once

#include <span>

#include "core/units.hpp"

namespace overturn {

/// Peak acceleration that a window of one second must reach to count [m/s2].
inline constexpr double standardised_cav_threshold_mps2 = 0.025 * g0;

/// Cumulative absolute velocity, the integral of |a| over the whole record [m/s]. Exact for acceleration that is linear
/// between samples.
/// Source: EPRI NP-5930 (1988), "A Criterion for Determining Exceedance of the Operating Basis Earthquake"; Reed and
/// Kassawara present it under the same title. \pre time_step_s > 0
[[nodiscard]] double cav_mps(std::span<double const> acceleration_mps2, double time_step_s);

/// Standardised CAV of the motion times `scale` [m/s]: the integral of |a| over those of the windows of one second, one
/// behind the other from the first sample, in which |a| reaches 0.025 g. A last window that the record does not fill
/// counts like one that ends in silence. It is not linear in the scale: a stronger motion has more windows that count.
/// Source: the rule of EPRI TR-100082 (1991) as Campbell and Bozorgnia (2011, Nucl. Eng. Des. 241, 2558-2569) restate
/// it. Number and title of the report are from recollection; programs of others that apply the rule were read, the
/// report and the article were not.
/// \pre time_step_s > 0
[[nodiscard]] double standardised_cav_mps(std::span<double const> acceleration_mps2, double time_step_s,
                                          double scale = 1);

}  // namespace overturn
