#include "stats/hazard.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/normal_tail.hpp"
#include "stats/detail/quotes.hpp"

namespace overturn {

void check_hazard_point(HazardPoint const& point, HazardPoint const* before) {
    auto const& [intensity, annual] = point;
    validate(intensity != 0, "intensity 0 with annual exceedance {} (no motion at all is no hazard). Leave the row out",
             annual);
    validate(annual != 0, "annual exceedance 0 at intensity {} (the curve ends at the row before). Leave the row out",
             intensity);
    validate(intensity > 0 && std::isfinite(intensity) && annual > 0 && std::isfinite(annual),
             "intensity {}, annual exceedance {} (both must be positive and finite). Mend the row", intensity, annual);
    if (before == nullptr) {
        return;
    }
    validate(intensity > before->intensity, "intensity {} after {} (must rise). Sort the table", intensity,
             before->intensity);
    validate(annual <= before->annual_exceedance, "annual exceedance {} after {} (stronger motions are rarer). Mend it",
             annual, before->annual_exceedance);
}

HazardCurve::HazardCurve(std::vector<HazardPoint> points, IntensityUnit stated, std::vector<std::string> remarks)
    : points_(std::move(points)), stated_(std::move(stated)), remarks_(std::move(remarks)) {
    validate(points_.size() >= 2, "hazard curve of {} points (at least two). Add some", points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        check_hazard_point(points_[i], i == 0 ? nullptr : &points_[i - 1]);
    }
}

double HazardCurve::annual_exceedance(double intensity) const {
    OVERTURN_EXPECT(intensity >= first() && intensity <= last());
    auto const above = std::upper_bound(points_.begin() + 1, points_.end() - 1, intensity,
                                        [](double at, HazardPoint const& point) { return at < point.intensity; });
    auto const& [a0, n0] = *(above - 1);
    auto const& [a1, n1] = *above;
    return n0 * std::pow(n1 / n0, std::log(intensity / a0) / std::log(a1 / a0));
}

double LognormalFragility::probability(double intensity) const {
    if (!std::isfinite(median) || beta == 0) {
        return intensity >= median ? 1 : 0;
    }
    return gsl_cdf_ugaussian_P(std::log(intensity / median) / beta);
}

namespace {

// Phi(b) - Phi(a). \pre a <= b, a not above 0: no cancellation
double normal_between(double a, double b) { return gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a); }

// The integral over a piece on which exceedance is n0 (a / a0)^-k.
double over_piece(double a0, double n0, double a1, double n1, LognormalFragility const& fragility) {
    double const median = fragility.median;
    double const beta = fragility.beta;
    double const p0 = fragility.probability(a0);
    double const p1 = fragility.probability(a1);
    double const k = std::log(n0 / n1) / std::log(a1 / a0);
    if (!std::isfinite(median) || n0 == n1) {
        return 0;  // nothing happens along a flat piece
    }
    if (beta == 0) {
        double const at_step = n0 * std::pow(median / a0, -k);
        return p0 > 0 ? n0 - n1 : p1 > 0 ? at_step - n1 : 0;
    }
    double const z0 = std::log(a0 / median) / beta + k * beta;
    double const z1 = std::log(a1 / median) / beta + k * beta;
    // n exp(k x + k^2 beta^2 / 2) Q(z), x = ln(a / median), without the overflow of a steep piece.
    auto const tail = [&](double a, double n, double z) {
        double const x = std::log(a / median) / beta;
        return n * std::exp(-x * x / 2) * scaled_upper_tail(z);
    };
    double const moved =
        z0 > 0 ? tail(a0, n0, z0) - tail(a1, n1, z1)
               : n0 * std::exp(k * std::log(a0 / median) + k * k * beta * beta / 2) * normal_between(z0, z1);
    // By parts; what is left of two large numbers is never below nothing.
    return std::max(0.0, p0 * n0 - p1 * n1 + moved);
}

}  // namespace

AnnualFrequency annual_frequency(HazardCurve const& hazard, LognormalFragility const& fragility) {
    AnnualFrequency frequency;
    auto const& points = hazard.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
        auto const& [a0, n0] = points[i - 1];
        auto const& [a1, n1] = points[i];
        frequency.parts.push_back({a0, a1, over_piece(a0, n0, a1, n1, fragility)});
        frequency.annual += frequency.parts.back().annual;
    }
    frequency.beyond_most = points.back().annual_exceedance;
    frequency.beyond_least = frequency.beyond_most * fragility.probability(hazard.last());
    frequency.at_first = fragility.probability(hazard.first());
    return frequency;
}

double annual_between(HazardCurve const& hazard, LognormalFragility const& fragility, double from, double to) {
    double const a0 = std::max(from, hazard.first());
    double const a1 = std::min(to, hazard.last());
    if (!(a0 < a1)) {
        return 0;
    }
    std::vector<HazardPoint> points{{a0, hazard.annual_exceedance(a0)}};
    for (auto const& point : hazard.points()) {
        if (point.intensity > a0 && point.intensity < a1) {
            points.push_back(point);
        }
    }
    points.push_back({a1, hazard.annual_exceedance(a1)});
    return annual_frequency(HazardCurve(std::move(points)), fragility).annual;
}

FrequencyShares shares_of(HazardCurve const& hazard, LognormalFragility const& fragility, double lowest,
                          double highest) {
    double const below = annual_between(hazard, fragility, 0, lowest);
    double const between = annual_between(hazard, fragility, lowest, highest);
    double const above = annual_between(hazard, fragility, highest, infinite);
    double const all = below + between + above;
    OVERTURN_EXPECT(all > 0);
    return {below / all, between / all, above / all};
}

Interval annual_frequency_seen(HazardCurve const& hazard, std::span<FragilityPoint const> stripes, double confidence,
                               double nothing_below, double beta_u) {
    std::vector<Interval> seen;
    for (auto const& stripe : stripes) {
        seen.push_back(interval_of(stripe, confidence));
    }
    // P is at least what any stripe below shows, and at most what any above does.
    for (std::size_t i = 1; i < seen.size(); ++i) {
        seen[i].lower = std::max(seen[i].lower, seen[i - 1].lower);
    }
    for (std::size_t i = seen.size(); i-- > 1;) {
        seen[i - 1].upper = std::min(seen[i - 1].upper, seen[i].upper);
    }
    // Both bounds are stairs. A step at an intensity that scatters is a lognormal curve.
    double const motions = hazard.points().front().annual_exceedance - hazard.points().back().annual_exceedance;
    auto const passed_from = [&](double at) {
        return at > 0 ? annual_frequency(hazard, {at, beta_u}) : AnnualFrequency{.annual = motions, .parts = {}};
    };
    Interval bounds{0, hazard.points().back().annual_exceedance};
    double shown = 0;    // by the stripes so far
    double allowed = 0;  // up to the next stripe
    auto last = passed_from(nothing_below);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        double const at = std::exp(stripes[i].log_intensity);
        auto const passed = passed_from(at);
        bounds.lower += (seen[i].lower - shown) * (passed.annual + passed.beyond_least);
        shown = seen[i].lower;
        if (at > nothing_below) {
            bounds.upper += (seen[i].upper - allowed) * last.annual;
            allowed = seen[i].upper;
            last = passed;
        }
    }
    bounds.upper += (1 - allowed) * last.annual;
    return bounds;
}

}  // namespace overturn
