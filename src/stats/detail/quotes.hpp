/// P where it is asked for: of the curve, of the stripe right there, or a bound.
#pragma once

#include "stats/detail/curve_fit.hpp"
#include "stats/fragility.hpp"

namespace overturn {

/// Two intensities this near [relative] are one.
inline constexpr double same_intensity = 1e-9;

/// Clopper-Pearson of counts, groups of alike trials as one, undecided trials standing for the lower end and fallen for
/// the upper one.
[[nodiscard]] Interval interval_of(FragilityPoint const& point, double confidence);

/// What the stripes say of it, before any curve.
[[nodiscard]] QuotedProbability seen_at(Quote const& quote, FragilityFit const& fit, FragilityData const& data,
                                        double confidence);

/// What the curve adds, and where it is not believed: outside the exact interval of the stripe right there, or of what
/// the stripes on both sides leave; where it describes the data poorly; and below what so few trials can hold.
/// \param poor it fits poorly
void quote_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data, CurveFit const& curve,
                 bool poor, double confidence);

/// Where there is no curve after all, what was seen is all there is.
void quote_without_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data,
                         double confidence);

}  // namespace overturn
