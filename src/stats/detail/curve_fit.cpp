#include "stats/detail/curve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gsl/gsl_cdf.h>

#include "stats/detail/extended_real.hpp"
#include "stats/detail/tail_bounds.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

using Intervals = FragilityFit::Intervals;

Interval lowered(Interval const& interval, double by) { return {interval.lower * by, interval.upper * by}; }

// Every replicate with the split of its own waves: what it says of ln HCLPF.
Interval resampled_hclpf(Bootstrap const& refits, ProbitLine const& line, FragilityRequest const& request,
                         double confidence) {
    auto const& splits = request.split->replicates;
    auto const log_hclpf = [&](Replicate const& curve, double drawn) {
        double const waves = std::sqrt(std::max(0.0, curve.beta * curve.beta - drawn * drawn));
        return curve.log_median - hclpf_score * (waves + std::hypot(drawn, request.beta_u));
    };
    std::vector<double> logs;
    for (std::size_t r = 0; r < refits.size(); ++r) {
        auto const& curve = refits.replicates()[r];
        if (std::isinf(curve.log_median)) {
            logs.push_back(curve.log_median);
            continue;
        }
        logs.push_back(log_hclpf(curve, splits.at(r).beta_u));
    }
    auto const ends = middle_about(log_hclpf({line.log_median(), line.beta()}, request.split->beta_u), logs, confidence,
                                   {-infinite, infinite});
    return {std::exp(ends.lower), std::exp(ends.upper)};
}

void add_hclpf(CurveFit& fit, FragilityRequest const& request) {
    if (request.split && !request.split->replicates.empty()) {
        // The likelihood of one curve knows nothing of the split.
        fit.bootstrap.hclpf = fit.profile.hclpf =
            resampled_hclpf(fit.refits, fit.line, request, fit.resampled_confidence);
    } else if (!request.drawn && request.beta_u > 0) {
        double const margin = std::exp(-hclpf_score * request.beta_u);
        fit.profile.hclpf = lowered(fit.profile.five_percent_point, margin);
        fit.bootstrap.hclpf = lowered(fit.bootstrap.five_percent_point, margin);
    }
    if (fit.of_capacities && fit.bootstrap.hclpf) {  // as much wider as the 5 % point
        auto const& five = fit.bootstrap.five_percent_point;
        auto const& few = fit.of_capacities->five_percent_point;
        fit.of_capacities->hclpf =
            Interval{five.lower > 0 ? fit.bootstrap.hclpf->lower * few.lower / five.lower : 0,
                     fit.bootstrap.hclpf->upper * (std::isfinite(five.upper) ? few.upper / five.upper : 1)};
    }
}

Bootstrap resample(std::span<FragilityPoint const> points, std::span<SingleTrial const> trials, ProbitLine const& line,
                   FragilityRequest const& request) {
    if (trials.empty()) {
        return bootstrap_trials(points, line, request.bootstrap);
    }
    auto refits = bootstrap_waves(trials, line, request.bootstrap);
    if (request.draws_balanced && request.split && request.split->replicates.size() == refits.size()) {
        std::vector<double> imbalances;
        for (auto const& replicate : request.split->replicates) {
            imbalances.push_back(replicate.imbalance);
        }
        refits.lower_medians(imbalances);
    }
    return refits;
}

// An extreme that holds no curve leaves every end open.
constexpr Intervals all_open{{0, infinite}, {0, infinite}, {0, infinite}, std::nullopt};

// Undecided trials as `overturned` of all, per stripe or tenth of the trials.
std::vector<FragilityPoint> undecided_shares(FragilityData const& data) {
    constexpr std::size_t groups = 10;
    auto points = with_undecided(data, false);
    for (auto& point : points) {
        point.overturned = 0;
    }
    for (auto const& open : data.open_points) {
        std::ranges::find(points, open.log_intensity, &FragilityPoint::log_intensity)->overturned = open.undecided;
    }
    return data.kind == FragilityData::Kind::stripes ? points : grouped(points, groups);
}

}  // namespace

bool is_nested(FragilityData const& data, FragilityRequest const& request, std::int64_t waves) {
    constexpr std::int64_t most_of_levels = 10'000, most_of_measure = 200;
    auto const most = data.kind == FragilityData::Kind::stripes ? most_of_levels : most_of_measure;
    return data.waves_shared && waves > 1 && waves <= most && !(request.draws_balanced && request.split);
}

void widen(Intervals& to, Intervals const& by) {
    to.median = hull(to.median, by.median);
    to.beta = hull(to.beta, by.beta);
    to.five_percent_point = hull(to.five_percent_point, by.five_percent_point);
    if (to.hclpf) {
        to.hclpf = hull(*to.hclpf, by.hclpf.value_or(Interval{0, infinite}));
    }
}

FragilityFit::Intervals CurveFit::ends(FragilityFit::Method method) const {
    auto made = method == FragilityFit::Method::profile_likelihood ? profile : bootstrap;
    if (method == FragilityFit::Method::widest) {
        widen(made, profile);
        widen(made, of_capacities.value_or(made));
    }
    return made;
}

Interval CurveFit::probability(double intensity, FragilityFit::Method method) const {
    if (method == FragilityFit::Method::profile_likelihood) {
        return likelihood.probability(intensity);
    }
    auto ends = refits.probability(intensity, resampled_confidence);
    if (method == FragilityFit::Method::widest) {
        ends = hull(ends, likelihood.probability(intensity));
        ends = few ? hull(ends, few->probability(intensity)) : ends;
        ends = nested ? hull(ends, nested->probability(intensity)) : ends;
    }
    return ends;
}

CurveAttempt fit_curve(FragilityData const& data, FragilityRequest const& request) {
    auto const& points = data.points;
    auto const& trials = data.trials;
    auto const line = fit_probit(points);
    if (!line) {
        return {FragilityState::not_converged, std::nullopt};
    }
    if (!(line->slope > 0)) {
        return {FragilityState::not_rising, std::nullopt};
    }
    ProfileLikelihood const profile(points, *line, request.confidence);
    if (!profile.rises()) {
        return {FragilityState::not_rising, std::nullopt};
    }
    auto refits = resample(points, trials, *line, request);
    double const five_percent = gsl_cdf_ugaussian_P(-hclpf_score);
    auto const waves = trials.empty() ? data.fewest_waves : waves_of(trials);
    double const resampled = trials.empty() ? request.confidence : resampled_confidence(request.confidence, waves);
    bool const resamples = !trials.empty() || sum_of(points).trials >= 2 * static_cast<double>(points.size());
    CurveFit fit{*line, profile, std::move(refits), {}, {}, {}, {}, {}, resamples, resampled};
    fit.profile = {profile.intensity(0.5), profile.beta(), profile.intensity(five_percent), std::nullopt};
    fit.bootstrap = {fit.refits.intensity(0.5, resampled), fit.refits.beta(resampled),
                     fit.refits.intensity(five_percent, resampled), std::nullopt};
    if (waves > 1 && (waves < waves_enough_to_resample || trials.empty())) {
        fit.few.emplace(*line, waves, request.confidence);
    }
    // Of trials alone at their levels no running share says where a capacity lies.
    if (is_nested(data, request, waves) && resamples) {
        fit.nested.emplace(trials.empty() ? ranges_of(points, static_cast<double>(waves)) : ranges_of(trials), *line,
                           request.confidence);
    }
    auto const take = [&](auto const& capacities) {
        Intervals const ends{capacities.median(), capacities.beta(), capacities.intensity(five_percent), std::nullopt};
        if (fit.of_capacities) {
            widen(*fit.of_capacities, ends);
        } else {
            fit.of_capacities = ends;
        }
    };
    if (fit.few) {
        take(*fit.few);
    }
    if (fit.nested) {
        take(*fit.nested);
    }
    add_hclpf(fit, request);
    return {FragilityState::fitted, std::move(fit)};
}

UndecidedExtremes weigh_undecided(FragilityData const& data, CurveFit const& decided, FragilityRequest const& request,
                                  FragilityFit::Method method) {
    UndecidedExtremes extremes{false, decided.ends(method), {}};
    double highest = decided.line.log_median();
    auto extreme = data;
    extreme.trials.insert(extreme.trials.end(), data.open.begin(), data.open.end());
    for (bool const fallen : {false, true}) {
        extreme.points = with_undecided(data, fallen);
        for (auto& trial : std::span(extreme.trials).subspan(data.trials.size())) {
            trial.overturned = fallen;
        }
        auto const attempt =
            state_of(extreme.points) == FragilityState::fitted ? fit_curve(extreme, request) : CurveAttempt{};
        widen(extremes.ends, attempt.curve ? attempt.curve->ends(method) : all_open);
        extremes.refits.push_back(attempt.curve ? attempt.curve->refits.replicates() : std::vector<Replicate>{});
        double const median = attempt.curve ? attempt.curve->line.log_median() : infinite;
        highest = std::max(highest, median);
    }
    constexpr double most = 0.05;
    extremes.hide_median = std::ranges::any_of(undecided_shares(data), [&](FragilityPoint const& share) {
        return share.log_intensity <= highest && share.probability() > most;
    });
    return extremes;
}

}  // namespace overturn
