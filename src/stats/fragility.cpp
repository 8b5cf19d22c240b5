#include "stats/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gsl/gsl_cdf.h>

#include "stats/detail/curve_fit.hpp"
#include "stats/detail/quotes.hpp"
#include "stats/detail/seen_bound.hpp"
#include "stats/detail/shape_tests.hpp"
#include "stats/detail/tail_bounds.hpp"

namespace overturn {
namespace {

constexpr std::size_t most_cells = 2048;  // width / beta is far below what any sample resolves
constexpr double chance = 0.05;           // below it a misfit is called one

double lowest_proportion(std::span<FragilityPoint const> points) {
    auto const found = std::find_if(points.begin(), points.end(), [](auto const& p) { return p.overturned > 0; });
    return found == points.end() ? 0 : found->probability();
}

void raise_if(FragilityFit& fit, bool condition, FragilityFlag flag) { fit.flags |= condition ? bit(flag) : 0; }

void describe(FragilityFit& fit, FragilityData const& data, FragilityRequest const& request) {
    auto const sum = sum_of(data.points);
    fit.trials = sum.trials;
    fit.overturned = sum.overturned;
    // Stripes without any verdict are no points.
    fit.undecided = data.kind == FragilityData::Kind::stripes ? sum_of(data.open_points).undecided : sum.undecided;
    fit.waves = data.trials.empty() ? data.fewest_waves : waves_of(data.trials);
    fit.waves_known = data.waves_known;
    raise_if(fit, fit.undecided > 0, FragilityFlag::undecided_trials);
    raise_if(fit, data.waves_left_out, FragilityFlag::waves_left_out);
    raise_if(fit, fit.waves > 0 && fit.waves < waves_enough_to_resample, FragilityFlag::few_waves);
    using enum FragilityFit::Method;
    bool const few = has(fit.flags, FragilityFlag::few_waves) || data.waves_known != WavesKnown::yes
                     || is_nested(data, request, fit.waves);
    fit.method = !data.waves_shared ? profile_likelihood : few ? widest : bootstrap_by_waves;
    raise_if(fit, fit.overturned == 1 && fit.trials > 1, FragilityFlag::one_overturned);
    if (data.points.empty()) {
        return;
    }
    fit.group_size = data.points.front().group_size;
    fit.lowest = std::exp(data.points.front().log_intensity);
    fit.highest = std::exp(data.points.back().log_intensity);
    raise_if(fit, data.points.size() == 2, FragilityFlag::two_levels);
    auto const proportions = proportions_of(data);
    fit.lowest_proportion = lowest_proportion(proportions);
    fit.isotonic = isotonic_estimate(data.points);
    fit.isotonic_median = isotonic_median(fit.isotonic);
}

// Before anything is quoted: where P falls beyond chance, no trial elsewhere bounds it.
void test_shape_of(FragilityFit& fit, FragilityData const& data, FragilityRequest const& request) {
    if (data.points.empty()) {
        return;
    }
    auto const line = fit.state == FragilityState::fitted ? fit_probit(data.points) : std::nullopt;
    auto tests = test_shape(data, line && line->slope > 0 ? line : std::nullopt, request.bootstrap);
    fit.monotone = tests.monotone;
    fit.goodness = tests.goodness;
    raise_if(fit, fit.monotone.p_value < chance, FragilityFlag::non_monotone);
}

// Beyond the data on either side: what Firth's penalty says there is made up.
bool lies_outside(FragilityFit const& fit, ProbitLine const& line) {
    constexpr double rounding = 1e-6;
    double const median = std::exp(line.log_median());
    return median < fit.lowest * (1 - rounding) || median > fit.highest * (1 + rounding);
}

void add_betas(FragilityFit& fit, FragilityRequest const& request) {
    fit.beta_u_drawn = request.split ? request.split->beta_u : 0;
    fit.beta_u_stated = request.beta_u;
    fit.beta_u = std::hypot(fit.beta_u_drawn, request.beta_u);
    fit.drawn = request.drawn;
    // What was drawn and moves nothing, a mass, says nothing of what is not known.
    bool const separated = request.split && (request.split->moves_median() || request.beta_u > 0);
    fit.beta_u_known = fit.beta_u > 0 && (!request.drawn || separated);
}

void fit_line(FragilityFit& fit, FragilityData const& data, FragilityRequest const& request) {
    auto const attempt = fit_curve(data, request);
    fit.state = attempt.state;
    if (!attempt.curve) {
        return;
    }
    auto const& curve = *attempt.curve;
    auto ends = curve.ends(fit.method);
    if (fit.undecided > 0) {
        auto const extremes = weigh_undecided(data, curve, request, fit.method);
        if (extremes.hide_median) {
            fit.state = FragilityState::undecided;
            return;
        }
        ends = extremes.ends;
        fit.extreme_refits = extremes.refits;
    }
    fit.line = curve.line;
    fit.profile = curve.profile;
    if (curve.resampled) {
        fit.bootstrap = curve.bootstrap;
    }
    fit.ends = ends;
    fit.replicates = curve.refits.size();
    fit.refits = curve.refits.replicates();
    fit.replicates_without_curve = curve.refits.without_curve();
    for (double const at : request.band_at) {
        fit.band.push_back({at, gsl_cdf_ugaussian_P(curve.line.at(std::log(at))), curve.probability(at, fit.method)});
    }
    for (auto& quoted : fit.quotes) {
        quote_curve(quoted, fit, data, curve, fit.goodness->least_p_value() < chance, request.confidence);
    }
}

// Do the proportions contradict the 5 % point? Where they fall beyond chance; where a stripe at or below it passes 5 %
// for sure, or one at or above it stays below; where the curve misses a stripe by more than 5 % beyond its interval,
// or, being a poor fit, by anything beyond it within the point's own interval. All stripes together hold with the
// confidence (Bonferroni), unless the fit is poor anyway.
bool contradicted(FragilityFit const& fit, FragilityData const& data, double confidence) {
    if (has(fit.flags, FragilityFlag::non_monotone)) {
        return true;
    }
    constexpr double share = 0.05;
    double const at = fit.line->log_median() - hclpf_score * fit.line->beta();
    bool const poor = has(fit.flags, FragilityFlag::poor_fit);
    auto const& near = fit.intervals().five_percent_point;
    auto const proportions = proportions_of(data);
    double const each = poor ? confidence : 1 - (1 - confidence) / static_cast<double>(proportions.size());
    return std::ranges::any_of(proportions, [&](FragilityPoint const& point) {
        auto const seen = interval_of(point, each);
        double const p = gsl_cdf_ugaussian_P(fit.line->at(point.log_intensity));
        bool const other_side = point.log_intensity <= at ? seen.lower > share : seen.upper < share;
        double const intensity = std::exp(point.log_intensity);
        double const excess = poor && intensity >= near.lower && intensity <= near.upper ? 0 : share;
        return other_side || p < seen.lower - excess || p > seen.upper + excess;
    });
}

// What the stripes on either side of the 5 % point hold, whatever the curve says.
Neighbours at_five_percent(FragilityFit const& fit, FragilityData const& data, double confidence) {
    double const at = std::exp(fit.line->log_median() - hclpf_score * fit.line->beta());
    return {seen_up_to(at, data, false, confidence).value_or(SeenBound{}),
            seen_from(at, data, false, confidence).value_or(SeenBound{})};
}

void judge(FragilityFit& fit, FragilityData const& data, double confidence) {
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
        case FragilityState::grid:  // these say themselves why there is nothing
        case FragilityState::few_records:
        case FragilityState::few_waves:
        case FragilityState::undecided:
            break;
        case FragilityState::fitted: {
            double const median = std::exp(fit.line->log_median());
            raise_if(fit, fit.goodness->least_p_value() < chance, FragilityFlag::poor_fit);
            raise_if(fit, median < fit.lowest || median > fit.highest, FragilityFlag::median_outside_data);
            if (contradicted(fit, data, confidence)) {
                fit.flags |= bit(FragilityFlag::five_percent_doubtful);
                fit.beside_five_percent = at_five_percent(fit, data, confidence);
            }
            raise_if(fit, !fit.beta_u_known, FragilityFlag::no_beta_u);
            raise_if(fit, fit.hclpf() && *fit.hclpf() < fit.lowest, FragilityFlag::hclpf_outside_data);
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
    FragilityData data;
    data.points = points_of(stripes);
    for (auto const& stripe : stripes) {
        if (auto const open = stripe.trials - stripe.decided(); open > 0) {
            data.open_points.push_back(
                {std::log(stripe.amplitude), 0, 0, static_cast<double>(open), stripe.group_size});
        }
    }
    return data;
}

FragilityData FragilityData::of_trials(std::vector<SingleTrial> trials, bool waves_shared,
                                       std::vector<SingleTrial> open, std::int64_t lost, double group_size) {
    FragilityData data;
    data.kind = Kind::singles;
    data.points = points_of(trials, most_cells);
    for (auto& point : data.points) {
        point.group_size = group_size;
    }
    data.open_points = points_of(open, most_cells);
    for (auto& point : data.open_points) {
        point = {point.log_intensity, 0, 0, point.trials, group_size};
    }
    if (!data.points.empty()) {
        data.points.back().undecided = static_cast<double>(lost) + static_cast<double>(open.size());
    }
    data.trials = std::move(trials);
    data.open = std::move(open);
    data.waves_shared = waves_shared;
    return data;
}

double FragilityFit::beta_r() const {
    double const beta = line->beta();
    return std::sqrt(std::max(0.0, beta * beta - beta_u_drawn * beta_u_drawn));
}

std::optional<double> FragilityFit::five_percent_point() const {
    return line ? std::optional(std::exp(line->log_median() - hclpf_score * line->beta())) : std::nullopt;
}

std::optional<double> FragilityFit::hclpf() const {
    bool const limited = beta_u_known && !(ends && ends->hclpf && ends->hclpf->lower <= 0);
    return limited ? std::optional(std::exp(line->log_median() - hclpf_score * (beta_r() + beta_u))) : std::nullopt;
}

std::optional<double> FragilityFit::one_percent_point() const {
    return hclpf() ? std::optional(std::exp(line->log_median() - one_percent_score * std::hypot(beta_r(), beta_u)))
                   : std::nullopt;
}

std::optional<double> FragilityFit::median_at(double confidence) const {
    return beta_u_known ? std::optional(std::exp(line->log_median() - beta_u * gsl_cdf_ugaussian_Pinv(confidence)))
                        : std::nullopt;
}

std::vector<FragilityPoint> with_undecided(FragilityData const& data, bool fallen) {
    auto points = data.points;
    for (auto const& open : data.open_points) {
        auto at = std::ranges::find(points, open.log_intensity, &FragilityPoint::log_intensity);
        if (at == points.end()) {
            at = points.insert(at, {open.log_intensity, 0, 0, 0, open.group_size});
        }
        at->trials += open.undecided;
        at->overturned += fallen ? open.undecided : 0;
        at->undecided = 0;
    }
    std::ranges::sort(points, {}, &FragilityPoint::log_intensity);
    return points;
}

FragilityFit fit_fragility(FragilityData const& data, FragilityRequest const& request) {
    FragilityFit fit;
    fit.passing = request.passing;
    add_betas(fit, request);
    describe(fit, data, request);
    fit.state = state_of(data.points);
    if (fit.state == FragilityState::fitted && fit.waves > 0 && fit.waves < least_waves) {
        fit.state = FragilityState::few_waves;
    }
    test_shape_of(fit, data, request);
    for (auto const& quote : request.quotes) {
        fit.quotes.push_back(seen_at(quote, fit, data, request.confidence));
    }
    if (fit.state == FragilityState::none_overturned || fit.state == FragilityState::all_overturned) {
        fit.bound = tail_bound(data, fit.state, request.confidence);
    }
    if (fit.state == FragilityState::separated) {
        fit.penalised = fit_penalised(data.points);
        if (fit.penalised && lies_outside(fit, *fit.penalised)) {
            fit.penalised.reset();
            fit.bound = end_bound(data, fit, request.confidence);
        }
    }
    if (fit.state == FragilityState::fitted) {
        fit_line(fit, data, request);
    }
    fit.pooled = pooled_bound(data, fit, request.confidence);
    for (auto& quoted : fit.quotes) {
        if (!fit.identifiable()) {
            quote_without_curve(quoted, fit, data, request.confidence);
        }
    }
    if (!fit.identifiable()) {
        fit.goodness.reset();
    }
    judge(fit, data, request.confidence);
    return fit;
}

}  // namespace overturn
