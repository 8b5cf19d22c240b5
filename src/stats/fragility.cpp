#include "stats/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gsl/gsl_cdf.h>

#include "stats/detail/profile_likelihood.hpp"
#include "stats/detail/seen_bound.hpp"

namespace overturn {
namespace {

constexpr std::size_t most_cells = 2048;       // width / beta is far below what any sample resolves
constexpr std::size_t groups_of_singles = 10;  // for what needs proportions
constexpr double hclpf_score = 1.645;          // 5 % of a normal variable, as HCLPF is defined
constexpr double one_percent_score = 2.326347874040841;
constexpr double decade = 0.1;
constexpr double chance = 0.05;  // below it a misfit is called one

std::vector<FragilityPoint> proportions_of(FragilityData const& data) {
    return data.kind == FragilityData::Kind::stripes ? data.points : grouped(data.points, groups_of_singles);
}

std::int64_t waves_of(std::span<SingleTrial const> trials, double from = 0, double to = HUGE_VAL) {
    std::set<std::int64_t> waves;
    for (auto const& trial : trials) {
        if (trial.intensity >= from && trial.intensity <= to) {
            waves.insert(trial.wave);
        }
    }
    return static_cast<std::int64_t>(waves.size());
}

Interval interval_of(double overturned, double trials, double undecided, double confidence) {
    auto const k = static_cast<std::int64_t>(overturned);
    auto const more = static_cast<std::int64_t>(undecided);
    auto const n = static_cast<std::int64_t>(trials) + more;
    return {clopper_pearson(k, n, confidence).lower, clopper_pearson(k + more, n, confidence).upper};
}

// Nothing overturned: the highest stripe bounds P best; everything did: the lowest. Single trials of one wave tell no
// more than one.
TailBound tail_bound(FragilityData const& data, FragilityState state, double confidence) {
    auto const groups = proportions_of(data);
    bool const none = state == FragilityState::none_overturned;
    auto const& group = none ? groups.back() : groups.front();
    TailBound bound{std::exp(group.log_intensity), std::exp(group.log_intensity), group.trials, {}};
    if (data.kind == FragilityData::Kind::singles) {
        double const edge = (none ? data.points.back() : data.points.front()).log_intensity;
        // The group's mean halves it, near enough to say where it lies.
        bound.from = std::exp(std::min(edge, group.log_intensity));
        bound.to = std::exp(std::max(edge, group.log_intensity));
        bound.units = static_cast<double>(waves_of(data.trials, bound.from, bound.to * (1 + 1e-12)));
    }
    bound.probability = interval_of(none ? 0 : bound.units, bound.units,
                                    data.kind == FragilityData::Kind::stripes ? group.undecided : 0, confidence);
    return bound;
}

double lowest_proportion(std::span<FragilityPoint const> points) {
    auto const found = std::find_if(points.begin(), points.end(), [](auto const& p) { return p.overturned > 0; });
    return found == points.end() ? 0 : found->probability();
}

void raise_if(FragilityFit& fit, bool condition, FragilityFlag flag) { fit.flags |= condition ? bit(flag) : 0; }

void describe(FragilityFit& fit, FragilityData const& data) {
    auto const sum = sum_of(data.points);
    fit.trials = sum.trials;
    fit.overturned = sum.overturned;
    fit.undecided = sum.undecided;
    fit.waves = waves_of(data.trials);
    fit.method =
        data.waves_shared ? FragilityFit::Method::bootstrap_by_waves : FragilityFit::Method::profile_likelihood;
    raise_if(fit, fit.undecided > 0, FragilityFlag::undecided_trials);
    raise_if(fit, data.waves_left_out, FragilityFlag::waves_left_out);
    constexpr std::int64_t few = 30;
    raise_if(fit, fit.waves > 0 && fit.waves < few, FragilityFlag::few_waves);
    raise_if(fit, fit.overturned == 1 && fit.trials > 1, FragilityFlag::one_overturned);
    if (data.points.empty()) {
        return;
    }
    fit.lowest = std::exp(data.points.front().log_intensity);
    fit.highest = std::exp(data.points.back().log_intensity);
    raise_if(fit, data.points.size() == 2, FragilityFlag::two_levels);
    auto const proportions = proportions_of(data);
    fit.lowest_proportion = lowest_proportion(proportions);
    fit.isotonic = isotonic_estimate(data.points);
    fit.isotonic_median = isotonic_median(fit.isotonic);
    fit.monotone = test_monotone(proportions);
    raise_if(fit, fit.monotone.p_value < chance, FragilityFlag::non_monotone);
}

// Where the stripe's own interval is quoted, a curve outside it is no estimate of P there.
void believe_what_was_seen(QuotedProbability& quoted) {
    if (*quoted.curve < quoted.seen.lower || *quoted.curve > quoted.seen.upper) {
        quoted.probability = quoted.overturned / quoted.trials;
        quoted.in_tail = false;
    }
}

void bound_what_none_can_hold(QuotedProbability& quoted, FragilityFit const& fit, FragilityData const& data,
                              double confidence) {
    if (!quoted.probability || *quoted.probability >= least_share(fit)) {
        return;
    }
    quoted.bound = seen_from(quoted.quote.intensity, data, confidence);
    quoted.probability.reset();
    quoted.in_tail = false;
    quoted.source = quoted.bound ? QuotedProbability::Source::stripe : QuotedProbability::Source::none;
    quoted.bounds = {0, quoted.bound ? quoted.bound->probability.upper : 1};
}

void fit_line(FragilityFit& fit, FragilityData const& data, FragilityRequest const& request) {
    auto const line = ProbitSolver().fit(data.points);
    if (!line) {
        fit.state = FragilityState::not_converged;
        return;
    }
    if (!(line->slope > 0)) {
        fit.state = FragilityState::not_rising;
        return;
    }
    ProfileLikelihood const profile(data.points, *line, request.confidence);
    if (!profile.rises()) {
        fit.state = FragilityState::not_rising;
        return;
    }
    fit.line = line;
    double const five_percent = gsl_cdf_ugaussian_P(-hclpf_score);
    // Beside the curve's own 5 % point, which holds beta, what beta_R + beta_U exceeds it by.
    double const margin = std::exp(-hclpf_score * (fit.beta_r() + fit.beta_u - line->beta()));
    auto const lowered = [margin](Interval const& i) { return Interval{i.lower * margin, i.upper * margin}; };
    fit.profile = {profile.intensity(0.5), profile.beta(), lowered(profile.intensity(five_percent))};
    auto const bootstrap = data.trials.empty() ? bootstrap_trials(data.points, *line, request.bootstrap)
                                               : bootstrap_waves(data.trials, *line, request.bootstrap);
    fit.bootstrap = {bootstrap.intensity(0.5, request.confidence), bootstrap.beta(request.confidence),
                     lowered(bootstrap.intensity(five_percent, request.confidence))};
    fit.replicates = bootstrap.size();
    fit.refits = bootstrap.replicates();
    fit.replicates_without_curve = bootstrap.without_curve();
    fit.goodness = goodness_of_fit(data.points, *line);
    for (double const at : request.band_at) {
        fit.band.push_back(
            {at, gsl_cdf_ugaussian_P(line->at(std::log(at))),
             data.waves_shared ? bootstrap.probability(at, request.confidence) : profile.probability(at)});
    }
    for (auto& quoted : fit.quotes) {
        double const at = quoted.quote.intensity;
        quoted.curve = gsl_cdf_ugaussian_P(line->at(std::log(at)));
        quoted.probability = quoted.curve;
        quoted.in_tail = *quoted.probability < decade * fit.lowest_proportion;
        if (quoted.source == QuotedProbability::Source::stripe) {
            believe_what_was_seen(quoted);
        } else {
            // A curve that does not describe the proportions is sure of what is not so.
            bool const trusted = fit.goodness->p_value >= chance || quoted.trials == 0;
            quoted.source = trusted ? QuotedProbability::Source::curve : QuotedProbability::Source::stripe;
            quoted.bounds = !trusted            ? quoted.seen
                            : data.waves_shared ? bootstrap.probability(at, request.confidence)
                                                : profile.probability(at);
            if (!trusted) {
                believe_what_was_seen(quoted);
            }
        }
        bound_what_none_can_hold(quoted, fit, data, request.confidence);
    }
}

QuotedProbability seen_at(Quote const& quote, FragilityFit const& fit, FragilityData const& data, double confidence) {
    QuotedProbability quoted;
    quoted.quote = quote;
    constexpr double same = 1e-9;
    quoted.outside_data = quote.intensity < fit.lowest * (1 - same) || quote.intensity > fit.highest * (1 + same);
    if (data.kind != FragilityData::Kind::stripes) {
        return quoted;
    }
    for (auto const& point : data.points) {
        if (std::abs(point.log_intensity - std::log(quote.intensity)) > same) {
            continue;
        }
        quoted.trials = point.trials;
        quoted.overturned = point.overturned;
        quoted.seen = interval_of(point.overturned, point.trials, point.undecided, confidence);
        bool const alike = point.overturned == 0 || point.overturned == point.trials;
        if (alike || fit.state != FragilityState::fitted) {
            quoted.source = QuotedProbability::Source::stripe;
            quoted.bounds = quoted.seen;
        }
    }
    return quoted;
}

void judge(FragilityFit& fit) {
    switch (fit.state) {
        case FragilityState::no_trials:
            fit.flags |= bit(FragilityFlag::no_trials);
            break;
        case FragilityState::none_overturned:
            fit.flags |= bit(FragilityFlag::nothing_overturned);
            break;
        case FragilityState::all_overturned:
            fit.flags |= bit(FragilityFlag::all_overturned);
            break;
        case FragilityState::one_level:
            fit.flags |= bit(FragilityFlag::one_level);
            break;
        case FragilityState::separated:
            fit.flags |= bit(FragilityFlag::separated);
            break;
        case FragilityState::not_rising:
            fit.flags |= bit(FragilityFlag::not_rising);
            break;
        case FragilityState::not_converged:
            fit.flags |= bit(FragilityFlag::not_converged);
            break;
        case FragilityState::grid:  // says itself why there is nothing
            break;
        case FragilityState::fitted: {
            double const median = std::exp(fit.line->log_median());
            raise_if(fit, fit.goodness->p_value < chance, FragilityFlag::poor_fit);
            raise_if(fit, median < fit.lowest || median > fit.highest, FragilityFlag::median_outside_data);
            raise_if(fit, fit.hclpf() < fit.lowest, FragilityFlag::hclpf_outside_data);
            auto const& ends = fit.intervals();
            raise_if(fit,
                     !std::isfinite(ends.median.upper) || !std::isfinite(ends.beta.upper) || ends.median.lower <= 0,
                     FragilityFlag::interval_unbounded);
            break;
        }
    }
}

}  // namespace

FragilityData FragilityData::of_stripes(std::span<Stripe const> stripes) {
    return {Kind::stripes, points_of(stripes), {}, false, false};
}

FragilityData FragilityData::of_trials(std::vector<SingleTrial> trials, bool waves_shared, std::int64_t undecided) {
    FragilityData data{Kind::singles, points_of(trials, most_cells), std::move(trials), waves_shared, false};
    if (!data.points.empty()) {
        data.points.back().undecided = static_cast<double>(undecided);
    }
    return data;
}

double FragilityFit::beta_r() const {
    double const beta = line->beta();
    return beta_u_in_trials ? std::sqrt(std::max(0.0, beta * beta - beta_u * beta_u)) : beta;
}

double FragilityFit::hclpf() const { return std::exp(line->log_median() - hclpf_score * (beta_r() + beta_u)); }

double FragilityFit::one_percent_point() const {
    return std::exp(line->log_median() - one_percent_score * std::hypot(beta_r(), beta_u));
}

FragilityFit fit_fragility(FragilityData const& data, FragilityRequest const& request) {
    FragilityFit fit;
    fit.passing = request.passing;
    fit.beta_u = request.beta_u;
    fit.beta_u_in_trials = request.beta_u_in_trials;
    describe(fit, data);
    fit.state = state_of(data.points);
    for (auto const& quote : request.quotes) {
        fit.quotes.push_back(seen_at(quote, fit, data, request.confidence));
    }
    if (fit.state == FragilityState::none_overturned || fit.state == FragilityState::all_overturned) {
        fit.bound = tail_bound(data, fit.state, request.confidence);
    }
    if (fit.state == FragilityState::separated) {
        fit.penalised = fit_penalised(data.points);
    }
    if (fit.state == FragilityState::fitted) {
        fit_line(fit, data, request);
    }
    for (auto& quoted : fit.quotes) {  // no curve after all: what was seen is all there is
        if (!fit.identifiable() && quoted.trials > 0) {
            quoted.source = QuotedProbability::Source::stripe;
            quoted.bounds = quoted.seen;
        }
    }
    judge(fit);
    return fit;
}

}  // namespace overturn
