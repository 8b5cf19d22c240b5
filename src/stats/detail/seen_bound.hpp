/// What is left to say where a curve speaks of less than the trials can hold.
#pragma once

#include <optional>

#include "stats/fragility.hpp"

namespace overturn {

/// What one stripe saw.
[[nodiscard]] SeenBound seen_in(FragilityPoint const& point, double confidence);

/// What was seen at the nearest intensities at or above this one: the next stripe, or a tenth of the single trials.
/// Nothing where none were tried there.
[[nodiscard]] std::optional<SeenBound> seen_from(double intensity, FragilityData const& data, double confidence);

}  // namespace overturn
