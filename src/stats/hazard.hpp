/// From fragility to frequency: how often a limit state is passed in a year, where a hazard curve says how often
/// motions exceed an intensity.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "stats/bootstrap.hpp"
#include "stats/fragility.hpp"
#include "stats/fragility_data.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

struct HazardPoint {
    double intensity = 0;          ///< SI
    double annual_exceedance = 0;  ///< mean number of exceedances in a year [1/a]
};

/// Checks one point and the one before it, if there is one; exceedances may stay the same from one to the next.
/// \throws InputError with the point's own numbers
/// \throws InputError with the point's own numbers
void check_hazard_point(HazardPoint const& point, HazardPoint const* before);

/// Straight in log-log between points.
class HazardCurve {
  public:
    /// \param stated the unit that intensities were stated in; no symbol: in none \param remarks what a reader must
    /// know of the table that it came from \throws InputError if there are fewer than two, an intensity does not rise
    /// or a frequency rises
    explicit HazardCurve(std::vector<HazardPoint> points, IntensityUnit stated = {},
                         std::vector<std::string> remarks = {});
    [[nodiscard]] std::vector<HazardPoint> const& points() const { return points_; }
    [[nodiscard]] IntensityUnit const& stated() const { return stated_; }
    [[nodiscard]] std::vector<std::string> const& remarks() const { return remarks_; }
    /// \pre intensity within the points
    [[nodiscard]] double annual_exceedance(double intensity) const;
    [[nodiscard]] double first() const { return points_.front().intensity; }
    [[nodiscard]] double last() const { return points_.back().intensity; }

  private:
    std::vector<HazardPoint> points_;
    IntensityUnit stated_;
    std::vector<std::string> remarks_;
};

/// Phi(ln(a / median) / beta).
struct LognormalFragility {
    double median = 0;  ///< may be infinite: never passed
    double beta = 0;    ///< 0: a step

    [[nodiscard]] double probability(double intensity) const;
};

/// A part of the integral, from one intensity to the next.
struct HazardPart {
    double from = 0, to = 0;  ///< `to` of the last one is infinite
    double annual = 0;        ///< times passed in a year by motions between them [1/a]
};

struct AnnualFrequency {
    /// Motions between the first and the last point of the hazard curve [1/a]
    double annual = 0;
    std::vector<HazardPart> parts;  ///< between the points of the curve, which it is the sum of
    /// Motions beyond the last point add between P(last) and all of its exceedances [1/a].
    double beyond_least = 0, beyond_most = 0;
    double at_first = 0;  ///< P at the first point: weaker motions, which the curve does not cover, pass no more often
};

/// The integral of P(a) |d exceedance / da|, exact for a lognormal fragility over each straight piece (by parts, the
/// rest is a normal integral with a shifted mean: the closed form of Cornell (1996) where one power law holds for all).
[[nodiscard]] AnnualFrequency annual_frequency(HazardCurve const& hazard, LognormalFragility const& fragility);

/// The part of `annual` by motions between two intensities; what lies outside of the hazard curve adds nothing [1/a].
[[nodiscard]] double annual_between(HazardCurve const& hazard, LognormalFragility const& fragility, double from,
                                    double to);

/// Bounds on it from stripes alone, if P rises with intensity: it is at least the lower end of the exact interval of
/// any stripe below, and at most the upper end of any above (Clopper & Pearson 1934); below all at least 0, above all
/// at most 1. Each stripe holds with this confidence; all of them together hold with less, and what they add up to
/// with more. \param nothing_below intensity up to which P is known to be 0 \param beta_u of what is not known and not
/// in the stripes: all intensities in them are then those of the median body, and the bounds are means over bodies
/// whose intensities are exp(beta_u z) times as high, z standard normal \return [1/a], beyond the last point of the
/// curve included in the upper end
[[nodiscard]] Interval annual_frequency_seen(HazardCurve const& hazard, std::span<FragilityPoint const> stripes,
                                             double confidence, double nothing_below = 0, double beta_u = 0);

/// The parts of the integral by where motions lie: below `lowest`, above `highest` and between, 1 in sum. \pre annual >
/// 0
struct FrequencyShares {
    double below = 0, between = 0, above = 0;
};
[[nodiscard]] FrequencyShares shares_of(HazardCurve const& hazard, LognormalFragility const& fragility, double lowest,
                                        double highest);

}  // namespace overturn
