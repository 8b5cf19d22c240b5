/// Bounds on the annual frequency where a fragility curve or a hazard curve ends.
#pragma once

#include <limits>
#include <optional>

#include "stats/hazard.hpp"

namespace overturn {

/// Intensities that were tried. A curve is known between `lowest` and `highest`; none falls up to `nothing_below`.
struct TriedRange {
    double lowest = 0, highest = 0;
    double nothing_below = 0;  ///< 0: not known
};

/// Annual frequencies by where motions lie [1/a]. P rises with the intensity; that is all they take for granted outside
/// of levels and hazard curve.
struct FrequencyBounds {
    double within = 0;  ///< between the levels and on the hazard curve: the curve's own integral
    /// Above the highest level, or the hazard curve's last point if that comes first: as often as there, or always.
    double above_least = 0, above_most = 0;
    double top = 0;  ///< the intensity from which on `above` counts
    /// Below the lowest level, on the hazard curve: never, or as often as at the lowest level.
    double below_most = 0;
    /// Weaker than the hazard curve's first point: by the curve, with the hazard continued at its steepest slope there.
    /// Hazard curves flatten towards weak motions, so that there are fewer; no more than `weaker_motions`.
    double weaker_most = 0;

    [[nodiscard]] double least() const { return within + above_least; }
    [[nodiscard]] double most() const { return within + above_most + below_most + weaker_most; }
};

/// \pre levels and hazard curve overlap: lowest <= hazard.last() and highest >= hazard.first()
[[nodiscard]] FrequencyBounds frequency_bounds(HazardCurve const& hazard, LognormalFragility const& fragility,
                                               TriedRange const& tried);

/// The hazard curve continued at its steepest slope there towards weaker motions: down to `nothing_below` where that is
/// known, else, where it begins above `lowest` or `always`, down to the motion that is exceeded once a year, or to
/// `lowest` if that is weaker. As it is where there is nothing to add.
[[nodiscard]] HazardCurve from_lower_on(HazardCurve const& hazard, TriedRange const& tried, bool always = false);

/// Motions weaker than the first point that are counted at most, down to the one exceeded once a year; as many as
/// exceed that point where these are more. A power law has motions without end towards 0, and a wide curve lets them
/// all pass (exp(k^2 beta^2 / 2) times as many: Cornell 1996), where no hazard curve holds any [1/a].
[[nodiscard]] double weaker_motions(HazardCurve const& hazard);

/// The integral with the hazard curve continued beyond both ends at the slopes it has there: an estimate [1/a]. \param
/// most_weaker of weaker motions than its first point
[[nodiscard]] double continued_frequency(HazardCurve const& hazard, LognormalFragility const& fragility,
                                         double most_weaker = std::numeric_limits<double>::infinity());

/// Effect of a straight line between two points of the hazard curve that lie far apart.
struct WidePiece {
    double from = 0, to = 0;  ///< intensities
    double decades = 0;       ///< of exceedance between them
    double share = 0;         ///< of the mean by motions between them
    double if_doubled = 0;    ///< the mean, if twice as many motions exceeded the intensity halfway [1/a]
    double halfway = 0;       ///< sqrt(from to)
};
/// The piece of more than two decades that holds most of the mean, if it holds 5 % or more. Nothing without such.
[[nodiscard]] std::optional<WidePiece> widest_piece(HazardCurve const& hazard, LognormalFragility const& fragility);

}  // namespace overturn
