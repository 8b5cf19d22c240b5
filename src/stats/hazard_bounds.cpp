#include "stats/hazard_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "stats/detail/normal_tail.hpp"

namespace overturn {
namespace {

double slope_between(HazardPoint const& a, HazardPoint const& b) {
    return std::log(a.annual_exceedance / b.annual_exceedance) / std::log(b.intensity / a.intensity);
}

// A slope that the hazard of motions weaker than the first point does not exceed. Hazard curves grow steeper with
// intensity, so the steepest piece that begins within a factor of 2 bounds it, also where the first one is flat or
// short. A curve that ends within that factor has none: then motions twice as strong are taken as ten times as seldom.
double weak_slope(HazardCurve const& hazard) {
    constexpr double near = 2;
    auto const& points = hazard.points();
    double const far = near * points[0].intensity;
    double k = points.back().intensity < far ? 1 / std::log10(near) : 0;
    for (std::size_t i = 1; i < points.size() && points[i - 1].intensity < far; ++i) {
        k = std::max(k, slope_between(points[i - 1], points[i]));
    }
    return k;
}

// Of a power law of slope k through a point: the normal integral that is left by parts, over all weaker motions or all
// stronger ones (Cornell 1996 for both together). May be infinite.
enum class Side { weaker, stronger };
double moved(HazardPoint const& at, double k, LognormalFragility const& fragility, Side side) {
    auto const& [median, beta] = fragility;
    double const x = std::log(at.intensity / median);
    double const z = x / beta + k * beta;
    if (side == Side::stronger && z > 0) {
        return at.annual_exceedance * std::exp(-x * x / (2 * beta * beta)) * scaled_upper_tail(z);
    }
    return at.annual_exceedance * std::exp(k * x + k * k * beta * beta / 2)
           * (side == Side::weaker ? gsl_cdf_ugaussian_P(z) : gsl_cdf_ugaussian_Q(z));
}

// Motions weaker than the first point and above `from`, the hazard continued at slope k.
double weaker(HazardCurve const& hazard, LognormalFragility const& fragility, double from, double k) {
    auto const& [median, beta] = fragility;
    auto const& first = hazard.points()[0];
    if (!std::isfinite(median) || !(first.intensity > from) || k == 0) {
        return 0;
    }
    if (beta == 0) {
        double const step = std::max(median, from);
        double const motions = first.annual_exceedance * (std::pow(step / first.intensity, -k) - 1);
        return step < first.intensity ? motions : 0;
    }
    // Of what is weaker than an intensity, whatever else.
    auto const below = [&](HazardPoint const& point) {
        return std::max(0.0, moved(point, k, fragility, Side::weaker)
                                 - point.annual_exceedance * fragility.probability(point.intensity));
    };
    HazardPoint const start{from, from > 0 ? first.annual_exceedance * std::pow(from / first.intensity, -k) : 0};
    return below(first) - (from > 0 ? below(start) : 0);
}

double stronger(HazardCurve const& hazard, LognormalFragility const& fragility) {
    auto const& [median, beta] = fragility;
    auto const& points = hazard.points();
    auto const& last = points.back();
    double const k = slope_between(points[points.size() - 2], last);
    double const there = last.annual_exceedance * fragility.probability(last.intensity);
    if (!std::isfinite(median) || k == 0) {
        return there;
    }
    if (beta == 0) {
        return last.annual_exceedance * std::pow(std::max(1.0, median / last.intensity), -k);
    }
    return there + moved(last, k, fragility, Side::stronger);
}

}  // namespace

FrequencyBounds frequency_bounds(HazardCurve const& hazard, LognormalFragility const& fragility,
                                 TriedRange const& tried) {
    OVERTURN_EXPECT(tried.lowest <= hazard.last() && tried.highest >= hazard.first());
    FrequencyBounds bounds;
    bounds.top = std::min(tried.highest, hazard.last());
    double const bottom = std::max(tried.lowest, hazard.first());
    bounds.within = annual_between(hazard, fragility, bottom, bounds.top);
    bounds.above_most = hazard.annual_exceedance(bounds.top);
    bounds.above_least = bounds.above_most * fragility.probability(bounds.top);
    double const start = std::max(hazard.first(), std::min(tried.nothing_below, bottom));
    bounds.below_most =
        fragility.probability(bottom) * (hazard.annual_exceedance(start) - hazard.annual_exceedance(bottom));
    bounds.weaker_most =
        std::min(weaker(hazard, fragility, tried.nothing_below, weak_slope(hazard)), weaker_motions(hazard));
    return bounds;
}

HazardCurve from_lower_on(HazardCurve const& hazard, TriedRange const& tried, bool always) {
    auto const& first = hazard.points()[0];
    double const k = weak_slope(hazard);
    constexpr double weak = 1e-3;
    double from = tried.nothing_below;
    if (from == 0 && (always || tried.lowest < first.intensity)) {
        double const yearly = k > 0 ? first.intensity * std::pow(first.annual_exceedance, 1 / k) : 0;
        from = std::min(std::max(yearly, weak * tried.lowest), tried.lowest);
    }
    if (!(from > 0 && from < first.intensity)) {
        return hazard;
    }
    auto points = hazard.points();
    points.insert(points.begin(), {from, first.annual_exceedance * std::pow(from / first.intensity, -k)});
    return HazardCurve(std::move(points), hazard.stated(), hazard.remarks());
}

double weaker_motions(HazardCurve const& hazard) {
    double const first = hazard.points()[0].annual_exceedance;
    return std::max(1 - first, first);
}

double continued_frequency(HazardCurve const& hazard, LognormalFragility const& fragility, double most_weaker) {
    double const first_slope = slope_between(hazard.points()[0], hazard.points()[1]);
    return std::min(weaker(hazard, fragility, 0, first_slope), most_weaker) + annual_frequency(hazard, fragility).annual
           + stronger(hazard, fragility);
}

std::optional<WidePiece> widest_piece(HazardCurve const& hazard, LognormalFragility const& fragility) {
    constexpr double wide = 2;
    constexpr double much = 0.05;
    auto const found = annual_frequency(hazard, fragility);
    double const mean = found.annual + found.beyond_least;
    auto const& points = hazard.points();
    std::optional<WidePiece> widest;
    std::size_t at = 0;
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
        auto const& part = found.parts[i];
        double const decades = std::log10(points[i].annual_exceedance / points[i + 1].annual_exceedance);
        if (decades > wide && part.annual > much * mean && (!widest || part.annual > widest->share * mean)) {
            widest = WidePiece{part.from, part.to, decades, part.annual / mean, 0, std::sqrt(part.from * part.to)};
            at = i;
        }
    }
    if (widest) {
        auto bent = points;
        double const doubled = 2 * hazard.annual_exceedance(widest->halfway);
        bent.insert(bent.begin() + at + 1, {widest->halfway, doubled});
        auto const other = annual_frequency(HazardCurve(std::move(bent)), fragility);
        widest->if_doubled = other.annual + other.beyond_least;
    }
    return widest;
}

}  // namespace overturn
