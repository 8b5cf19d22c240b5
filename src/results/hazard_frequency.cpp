#include "results/hazard_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/field.hpp"
#include "results/few_waves.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

double whole(AnnualFrequency const& frequency) { return frequency.annual + frequency.beyond_least; }

// What is taken for the curve beside what it was fitted to.
struct Beside {
    double beta = 0;       ///< stated, beside what was drawn
    double log_shift = 0;  ///< of the median
};

LognormalFragility curve_of(Replicate const& refit, Beside const& beside) {
    return {std::exp(refit.log_median + beside.log_shift), std::hypot(refit.beta, beside.beta)};
}

// Of the upper end of a motion's frequency, where nothing is known of a refit's curve.
double all_motions(HazardCurve const& hazard, TriedRange const& tried) {
    return from_lower_on(hazard, tried).points().front().annual_exceedance;
}

// Refits without a curve bound nothing: neither how often it is passed nor how seldom.
Interval interval_of(std::span<Replicate const> refits, Beside const& beside, HazardCurve const& hazard,
                     TriedRange const& tried, double confidence) {
    std::vector<double> low;
    std::vector<double> high;
    double const all = all_motions(hazard, tried);
    std::size_t open = 0;
    for (auto const& refit : refits) {
        if (std::isnan(refit.log_median) || std::isnan(refit.beta)) {
            ++open;
        } else {
            auto const bounds = frequency_bounds(hazard, curve_of(refit, beside), tried);
            low.push_back(bounds.least());
            high.push_back(bounds.most());
        }
    }
    low.insert(low.end(), open, 0.0);
    high.insert(high.end(), open, all);
    return {middle_of(low, confidence, {0, all}).lower, middle_of(high, confidence, {0, all}).upper};
}

// Whatever trials without a verdict would have done.
Interval interval_of_fit(FragilityFit const& fit, Beside const& beside, HazardCurve const& hazard,
                         TriedRange const& tried, double confidence) {
    confidence = fit.waves > 0 ? resampled_confidence(confidence, fit.waves) : confidence;
    auto ends = interval_of(fit.refits, beside, hazard, tried, confidence);
    for (auto const& refits : fit.extreme_refits) {
        ends = hull(ends, refits.empty() ? Interval{0, all_motions(hazard, tried)}
                                         : interval_of(refits, beside, hazard, tried, confidence));
    }
    if (has(fit.flags, FragilityFlag::few_waves) || fit.waves_known != WavesKnown::yes
        || !fit.bootstrap) {  // refits scatter too little
        auto const& [median, beta, five, hclpf] = fit.intervals();
        bool const open = median.lower <= 0 || !std::isfinite(beta.upper);
        double const most =
            open ? all_motions(hazard, tried)
                 : frequency_bounds(hazard, curve_of({std::log(median.lower), beta.upper}, beside), tried).most();
        double const least =
            std::isfinite(median.upper) && beta.lower > 0
                ? frequency_bounds(hazard, curve_of({std::log(median.upper), beta.lower}, beside), tried).least()
                : 0;
        ends = hull(ends, {least, most});
    }
    return ends;
}

// Has any wave a component beside the horizontal one, or may it have one? Drawn waves do not differ in that.
bool has_further_components(CampaignSpec const& spec) {
    auto const& measured = spec.source->about().measured;
    if (!measured.empty()) {
        return std::ranges::any_of(measured, [](auto const& wave) { return wave.transverse || wave.vertical; });
    }
    auto const motion = spec.source->make_unjudged(spec.seed, 0).motion;
    return !motion.transverse_mps2.empty() || !motion.vertical_mps2.empty();
}

// A rigid body on its two corners moves under no peak acceleration up to that of uplift, or of slip. Elsewhere, under
// further components, on a base that gives way, of a body that scatters or leans, no level is known to be too weak.
double nothing_below(CampaignSpec const& spec, BodySpec const& body) {
    bool const rigid = !body.footing.stated && body.scattering().empty() && body.body.initial_tilt_rad() == 0;
    if (spec.levels.measure != measure_named("pga") || !rigid || has_further_components(spec)) {
        return 0;
    }
    double const slips = body.friction ? body.body.gravity_mps2() * body.friction->static_coefficient
                                       : std::numeric_limits<double>::infinity();
    return std::min(body.body.uplift_acceleration_mps2(), slips);
}

// Is it passed by a body only that moves? Friction is asked of one at rest, and what is small passes a limit from
// below.
bool needs_motion(LimitState const& limit, std::span<LimitState const> limits) {
    switch (limit.rule) {
        case LimitState::Rule::above:
            return limit.quantity.name != "friction_demand";
        case LimitState::Rule::below:
            return false;
        case LimitState::Rule::any:
        case LimitState::Rule::all:
            return std::ranges::all_of(limit.of, [&](auto part) { return needs_motion(limits[part], limits); });
        case LimitState::Rule::overturning:
            break;
    }
    return true;
}

// What follows from the curve alone, by its median, beta_R and beta_U.
void add_curve(BodyFrequency& made, LognormalFragility const& mean, HazardCurve const& hazard,
               TriedRange const& tried) {
    made.mean = annual_frequency(hazard, mean);
    made.bounds = frequency_bounds(hazard, mean, tried);
    made.continued = continued_frequency(hazard, mean, weaker_motions(hazard));
    made.wide = widest_piece(hazard, mean);
}

// No upper end where uncertain properties of the body are neither drawn nor stated.
void open_above(BodyFrequency& made) {
    made.lacks_beta_u = true;
    made.interval.upper = made.seen.upper = std::numeric_limits<double>::infinity();
}

constexpr double score_95 = 1.6448536269514722;

/// \param upper of the highest curve, by whatever else is not known
void add_fractiles(BodyFrequency& made, double median, double beta_r, double beta_u, HazardCurve const& hazard,
                   double upper) {
    auto const at = [&](double scores) {
        return whole(annual_frequency(hazard, {median * std::exp(scores * beta_u), beta_r}));
    };
    made.fractiles = {at(score_95), at(0), at(-score_95), std::max({at(-score_95), upper, made.interval.upper})};
}

}  // namespace

double BodyFrequency::extrapolated() const { return mean ? std::max(0.0, whole(*mean) - bounds.within) : 0; }

BodyFrequency frequency_of(FragilityFit const& fit, FragilityData const& stripes, HazardCurve const& hazard,
                           double confidence, double nothing_below) {
    BodyFrequency made;
    made.nothing_below = nothing_below;
    made.lowest = fit.lowest;
    made.highest = fit.highest;
    double const beta_u = fit.beta_u_stated;  // what was drawn is in the stripes
    auto const seen = [&](HazardCurve const& over, double none_up_to) {
        return hull(annual_frequency_seen(over, with_undecided(stripes, false), confidence, none_up_to, beta_u),
                    annual_frequency_seen(over, with_undecided(stripes, true), confidence, none_up_to, beta_u));
    };
    constexpr double scores =
        8;  // a body that moves under weaker motions than exp(-8 beta_U) times the median one's is none
    auto const from_lower = from_lower_on(hazard, {fit.lowest, fit.highest, nothing_below * std::exp(-scores * beta_u)},
                                          !fit.identifiable());
    auto const as_stated = seen(hazard, nothing_below);
    made.seen = {as_stated.lower, std::max(as_stated.upper, seen(from_lower, nothing_below).upper)};
    made.seen_below_curve = made.seen.upper - as_stated.upper;
    made.seen_below_levels = made.seen.upper - seen(from_lower, std::max(nothing_below, fit.lowest)).upper;
    if (!fit.identifiable()) {
        if (beta_u == 0 && !fit.drawn) {
            open_above(made);
        }
        return made;
    }
    double const median = std::exp(fit.line->log_median());
    LognormalFragility const composite{median, std::hypot(fit.beta_r(), fit.beta_u)};
    // Levels that decided anything may lie outside of the hazard curve although all of them do not.
    TriedRange const tried{std::min(fit.lowest, hazard.last()), std::max(fit.highest, hazard.first()), nothing_below};
    add_curve(made, composite, hazard, tried);
    made.interval = hull(interval_of_fit(fit, {fit.beta_u_stated, 0}, hazard, tried, confidence),
                         {made.bounds.least(), made.bounds.most()});
    made.few_waves = has(fit.flags, FragilityFlag::few_waves) ? fit.waves : 0;
    made.poor = has(fit.flags, FragilityFlag::poor_fit) || has(fit.flags, FragilityFlag::five_percent_doubtful);
    if (made.poor || fit.undecided > 0) {  // with all of them fallen, or standing, it may not describe the data
        made.interval = hull(made.interval, made.seen);
    }
    if (made.mean->annual > 0) {
        made.shares = shares_of(hazard, composite, fit.lowest, fit.highest);
    }
    auto const& mean = *made.mean;
    made.outside_seen = whole(mean) > made.seen.upper || whole(mean) < made.seen.lower;
    if (fit.beta_u_known) {
        // With what was drawn still in the beta of refits: wider.
        Beside const highest{0, -score_95 * fit.beta_u};
        auto const upper = interval_of_fit(fit, highest, hazard, tried, confidence).upper;
        add_fractiles(made, median, fit.beta_r(), fit.beta_u, hazard, upper);
    } else {
        open_above(made);
    }
    return made;
}

BodyFrequency frequency_of_stated(double median, double beta_r, double beta_u, HazardCurve const& hazard) {
    BodyFrequency made;
    made.stated = true;
    made.highest = std::numeric_limits<double>::infinity();
    add_curve(made, {median, std::hypot(beta_r, beta_u)}, hazard, {made.lowest, made.highest, 0});
    made.interval = {made.bounds.least(), made.bounds.most()};
    if (beta_u > 0) {
        LognormalFragility const highest{median * std::exp(-score_95 * beta_u), beta_r};
        add_fractiles(made, median, beta_r, beta_u, hazard,
                      frequency_bounds(hazard, highest, {made.lowest, made.highest, 0}).most());
    } else {
        open_above(made);
    }
    return made;
}

std::vector<BodyFrequency> frequencies_of(CampaignSpec const& spec, Statistics const& statistics,
                                          std::vector<BodyAnalysis> const& analysis, HazardCurve const& hazard,
                                          double confidence) {
    std::vector<BodyFrequency> all;
    bool const sample = !no_sample(spec, statistics.waves().waves);
    for (std::size_t b = 0; b < analysis.size(); ++b) {
        double const still = nothing_below(spec, spec.bodies[b]);
        for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
            auto const stripes = FragilityData::of_stripes(statistics.bodies()[b].stripes_of(limit));
            double const nothing = needs_motion(spec.limits[limit], spec.limits) ? still : 0;
            if (sample) {
                all.push_back(
                    frequency_of(analysis[b].curves_of(limit).front().fit, stripes, hazard, confidence, nothing));
            } else {
                all.emplace_back();
                all.back().seen = all.back().interval = {never, never};
            }
            all.back().body = analysis[b].body;
            all.back().limit = spec.limits[limit].name;
            all.back().full_name = full_name(spec.limits[limit], spec.limits);
        }
    }
    return all;
}

}  // namespace overturn
