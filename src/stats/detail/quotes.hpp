/// P at requested intensities: of the curve, of the stripe right there, or a bound.
#pragma once

#include "stats/detail/curve_fit.hpp"
#include "stats/fragility.hpp"

namespace overturn {

/// Two intensities this near [relative] are one.
inline constexpr double same_intensity = 1e-9;

/// Clopper-Pearson of counts, a group of trials as one, undecided trials standing for the lower end and fallen for
/// the upper one.
[[nodiscard]] Interval interval_of(FragilityPoint const& point, double confidence);

/// P at the quote by the stripes alone, before any curve.
[[nodiscard]] QuotedProbability seen_at(Quote const& quote, FragilityFit const& fit, FragilityData const& data,
                                        double confidence);

/// Adds P of the curve. It is not believed outside the exact interval of the stripe right there, or of the bounds by
/// the stripes on both sides; where it describes the data poorly; and below the least P that so few trials can show.
/// \param poor it fits poorly
/// \param poor it fits poorly
void quote_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data, CurveFit const& curve,
                 bool poor, double confidence);

/// Completes a quote where there is no curve: only the trials count.
void quote_without_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data,
                         double confidence);

}  // namespace overturn
