#include "stats/detail/quotes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>

#include <gsl/gsl_cdf.h>

#include "stats/detail/seen_bound.hpp"

namespace overturn {
namespace {

constexpr double decade = 0.1;
void quote_stripe(QuotedProbability& quoted) {
    quoted.source = QuotedProbability::Source::stripe;
    quoted.bounds = quoted.seen;
}

void quote_neighbours(QuotedProbability& quoted) {
    quoted.source = QuotedProbability::Source::neighbours;
    quoted.bounds = quoted.neighbours->bounds();
}

// The nearest points on both sides; nothing at a point, and outside all. \param points rising
std::optional<Neighbours> neighbours_of(double log_intensity, std::span<FragilityPoint const> points,
                                        double confidence) {
    auto const above = std::ranges::find_if(
        points, [&](auto const& point) { return point.log_intensity > log_intensity - same_intensity; });
    if (above == points.begin() || above == points.end() || above->log_intensity < log_intensity + same_intensity) {
        return std::nullopt;
    }
    return Neighbours{seen_in(*std::prev(above), confidence), seen_in(*above, confidence)};
}

// A tenth of one in the trials right there, or at the nearest intensities from there on; in all where there are none.
double least_share(QuotedProbability const& quoted, FragilityFit const& fit, std::optional<SeenBound> const& from) {
    double const trials = quoted.trials > 0 ? quoted.trials : from && from->units > 0 ? from->units : fit.trials;
    return decade / trials;
}

}  // namespace

Interval interval_of(FragilityPoint const& point, double confidence) {
    auto const passed = static_cast<std::int64_t>(point.overturned);
    auto const open = static_cast<std::int64_t>(point.undecided);
    auto const trials = static_cast<std::int64_t>(point.trials) + open;
    return {clopper_pearson(passed, trials, confidence).lower,
            clopper_pearson(passed + open, trials, confidence).upper};
}

QuotedProbability seen_at(Quote const& quote, FragilityFit const& fit, FragilityData const& data, double confidence) {
    QuotedProbability quoted;
    quoted.quote = quote;
    quoted.outside_data =
        quote.intensity < fit.lowest * (1 - same_intensity) || quote.intensity > fit.highest * (1 + same_intensity);
    if (data.kind != FragilityData::Kind::stripes) {
        return quoted;
    }
    for (auto const& point : data.points) {
        if (std::abs(point.log_intensity - std::log(quote.intensity)) > same_intensity) {
            continue;
        }
        quoted.trials = point.trials;
        quoted.overturned = point.overturned;
        quoted.seen = interval_of(point, confidence);
        bool const alike = point.overturned == 0 || point.overturned == point.trials;
        if (alike || fit.state != FragilityState::fitted) {
            quote_stripe(quoted);
        }
    }
    quoted.neighbours = neighbours_of(std::log(quote.intensity), data.points, confidence);
    if (quoted.neighbours && (quoted.neighbours->alike() || fit.state != FragilityState::fitted)) {
        quote_neighbours(quoted);
    }
    return quoted;
}

void quote_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data, CurveFit const& curve,
                 bool poor, double confidence) {
    double const at = quoted.quote.intensity;
    double const p = gsl_cdf_ugaussian_P(curve.line.at(std::log(at)));
    quoted.curve = quoted.probability = p;
    quoted.in_tail = p < decade * fit.lowest_proportion;
    if (quoted.trials > 0 && (poor || p < quoted.seen.lower || p > quoted.seen.upper)) {
        quote_stripe(quoted);
        quoted.probability = quoted.overturned / quoted.trials;
        quoted.in_tail = false;
    }
    auto const from = seen_from(at, data, confidence);
    quoted.least = least_share(quoted, fit, from);
    if (quoted.neighbours) {
        auto const ends = quoted.neighbours->bounds();
        bool const excluded = p < ends.lower || p > ends.upper;
        if (poor || excluded) {
            quote_neighbours(quoted);
            quoted.probability.reset();
            quoted.in_tail = false;
            return;
        }
    }
    if (*quoted.probability < quoted.least) {
        quoted.bound = from;
        quoted.probability.reset();
        quoted.in_tail = false;
        quoted.source = from ? QuotedProbability::Source::stripe : QuotedProbability::Source::none;
        quoted.bounds = {0, from ? from->probability.upper : 1};
    } else if (quoted.source == QuotedProbability::Source::none) {
        quoted.source = QuotedProbability::Source::curve;
        quoted.bounds = curve.probability(at, fit.method, confidence);
    }
}

}  // namespace overturn
