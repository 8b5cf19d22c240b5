/// Bounds on P from trials near an intensity, since P does not fall with the intensity.
#pragma once

#include <optional>
#include <span>

#include "stats/fragility.hpp"

namespace overturn {

/// Bound from one stripe.
[[nodiscard]] SeenBound seen_in(FragilityPoint const& point, double confidence);

/// Bound from several together: its upper end bounds P at the first, its lower end P at the last. \pre rising, not
/// empty
[[nodiscard]] SeenBound seen_together(std::span<FragilityPoint const> points, double confidence);

/// Bound from the nearest intensities at or above this one, whose upper end bounds P: the next stripe, or a tenth of
/// the single trials. Nothing where none were tried there. \param pools where nothing overturned in that stripe, take
/// those next above it in which nothing did either: P is so small that a run of K stripes holds none with a chance of
/// no more than the first alone would, had it had all their trials. Their waves must not be the same.
[[nodiscard]] std::optional<SeenBound> seen_from(double intensity, FragilityData const& data, bool pools,
                                                 double confidence);

/// The same at or below, whose lower end bounds P, of stripes in which everything overturned.
[[nodiscard]] std::optional<SeenBound> seen_up_to(double intensity, FragilityData const& data, bool pools,
                                                  double confidence);

}  // namespace overturn
