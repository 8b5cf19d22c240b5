#include "stats/detail/quotes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gsl/gsl_cdf.h>

#include "stats/detail/seen_bound.hpp"

namespace overturn {
namespace {

constexpr double decade = 0.1;

// Where P falls beyond chance, what was seen elsewhere bounds nothing.
bool may_rise(FragilityFit const& fit) { return !has(fit.flags, FragilityFlag::non_monotone); }

// Stripes of levels that share no waves.
bool may_pool(FragilityFit const& fit, FragilityData const& data) {
    return data.kind == FragilityData::Kind::stripes && !data.waves_shared && may_rise(fit);
}

// The curve is not believed here, and nothing else gives P.
void withhold(QuotedProbability& quoted) {
    quoted.probability.reset();
    quoted.in_tail = false;
}

void quote_stripe(QuotedProbability& quoted) {
    quoted.source = QuotedProbability::Source::stripe;
    quoted.bounds = quoted.seen;
    quoted.bounds.upper = quoted.pooled ? quoted.pooled->probability.upper : quoted.bounds.upper;
}

void quote_neighbours(QuotedProbability& quoted) {
    quoted.source = QuotedProbability::Source::neighbours;
    quoted.bounds = quoted.neighbours->bounds();
}

// What was seen on either side, if anything was. Nothing where P falls beyond chance, or these two say so by
// themselves.
std::optional<Neighbours> neighbours_of(double intensity, FragilityFit const& fit, FragilityData const& data,
                                        double confidence) {
    bool const pools = may_pool(fit, data);
    Neighbours const near{seen_up_to(intensity, data, pools, confidence).value_or(SeenBound{}),
                          seen_from(intensity, data, pools, confidence).value_or(SeenBound{})};
    bool const rises = may_rise(fit) && near.bounds().lower <= near.bounds().upper;
    bool const any = near.below.units + near.above.units > 0;
    return rises && any ? std::optional(near) : std::nullopt;
}

// A tenth of one in the independent trials right there, or at the nearest intensities from there on; in all where there
// are none.
double least_share(QuotedProbability const& quoted, FragilityFit const& fit, std::optional<SeenBound> const& from) {
    bool const nearest = quoted.trials == 0 && from && from->units > 0;
    double const groups =
        nearest ? from->units / from->group_size : (quoted.trials > 0 ? quoted.trials : fit.trials) / fit.group_size;
    return decade / groups;
}

}  // namespace

Interval interval_of(FragilityPoint const& point, double confidence) {
    auto const passed = static_cast<std::int64_t>(point.overturned);
    auto const open = static_cast<std::int64_t>(point.undecided);
    auto const trials = static_cast<std::int64_t>(point.trials) + open;
    return clopper_pearson_of_groups(passed, passed + open, trials, point.group_size, confidence);
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
        auto const from = seen_from(quote.intensity, data, may_pool(fit, data), confidence);
        quoted.pooled = from && from->units > point.trials ? from : std::nullopt;
        bool const same = point.overturned == 0 || point.overturned == point.trials;
        if (same || fit.state != FragilityState::fitted) {
            quote_stripe(quoted);
        }
    }
    if (quoted.trials == 0 && !quoted.outside_data) {
        quoted.neighbours = neighbours_of(quote.intensity, fit, data, confidence);
        if (quoted.neighbours && (quoted.neighbours->same_end() || fit.state != FragilityState::fitted)) {
            quote_neighbours(quoted);
        }
    }
    return quoted;
}

void quote_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data, CurveFit const& curve,
                 bool poor, double confidence) {
    double const at = quoted.quote.intensity;
    double const p = gsl_cdf_ugaussian_P(curve.line.at(std::log(at)));
    quoted.curve = quoted.probability = p;
    quoted.in_tail = p < decade * fit.lowest_proportion;
    double const most = quoted.pooled ? quoted.pooled->probability.upper : quoted.seen.upper;
    if (quoted.trials > 0 && (poor || p < quoted.seen.lower || p > most)) {
        quote_stripe(quoted);
        quoted.probability = quoted.overturned / quoted.trials;
        quoted.in_tail = false;
    }
    auto from = seen_from(at, data, may_pool(fit, data), confidence);
    quoted.least = least_share(quoted, fit, from);
    if (!may_rise(fit) && quoted.trials == 0) {
        from.reset();
    }
    bool const nothing_near = quoted.trials == 0 && !quoted.neighbours;
    if (nothing_near && poor && p >= quoted.least) {
        quoted.neighbours = neighbours_of(at, fit, data, confidence);
        if (!quoted.neighbours) {
            withhold(quoted);
            return;
        }
    }
    if (quoted.neighbours) {
        auto const ends = quoted.neighbours->bounds();
        bool const excluded = p < ends.lower || p > ends.upper;
        if (poor || excluded) {
            quote_neighbours(quoted);
            withhold(quoted);
            return;
        }
    }
    if (*quoted.probability < quoted.least) {
        quoted.bound = from;
        withhold(quoted);
        quoted.source = from ? QuotedProbability::Source::stripe : QuotedProbability::Source::none;
        quoted.bounds = {0, from ? from->probability.upper : 1};
    } else if (quoted.source == QuotedProbability::Source::none) {
        quoted.source = QuotedProbability::Source::curve;
        quoted.bounds = curve.probability(at, fit.method);
    }
}

void quote_without_curve(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data,
                         double confidence) {
    if (quoted.trials > 0) {
        quote_stripe(quoted);
        return;
    }
    quoted.neighbours = neighbours_of(quoted.quote.intensity, fit, data, confidence);
    if (quoted.neighbours) {
        quote_neighbours(quoted);
    }
}

}  // namespace overturn
