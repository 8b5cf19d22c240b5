#include "results/curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "results/detail/curve_parts.hpp"
#include "results/detail/drawn_trials.hpp"
#include "results/detail/fitted_measures.hpp"
#include "results/few_waves.hpp"
#include "stats/quantile.hpp"
#include "stats/rank.hpp"

namespace overturn {
namespace {

std::vector<Quote> quotes_of(LevelSpec const& levels) {
    std::vector<Quote> quotes;
    auto const* const base = levels.design_basis();
    if (base == nullptr) {
        return quotes;
    }
    for (double const multiple : quoted_multiples) {
        quotes.push_back({multiple * base->value, multiple});
    }
    for (auto const& level : levels.levels) {
        auto const known = std::any_of(quotes.begin(), quotes.end(), [&](Quote const& q) {
            constexpr double same = 1e-9;
            return std::abs(q.intensity / level.value - 1) < same;
        });
        if (level.purpose == LevelClass::beyond_design && !known) {
            quotes.push_back({level.value, level.value / base->value});
        }
    }
    return quotes;
}

// From half the lowest level to 1.6 times the highest: what a figure shows beside the data.
std::vector<double> band_over(LevelSpec const& levels, int points) {
    constexpr double below = 0.5;
    constexpr double above = 1.6;
    std::vector<double> at;
    at.reserve(points);
    double const low = std::log(below * levels.levels.front().value);
    double const high = std::log(above * levels.levels.back().value);
    for (int i = 0; i < points; ++i) {
        at.push_back(std::exp(low + (high - low) * i / (points - 1)));
    }
    return at;
}

}  // namespace

std::int64_t count_curves(CampaignSpec const& spec) {
    return std::ssize(spec.bodies) * std::ssize(spec.limits) * std::ssize(measures_of(spec));
}

CampaignCurves::CampaignCurves(CampaignSpec const& spec, Statistics const& statistics, AnalysisOptions const& options)
    : spec_(spec), statistics_(statistics), options_(options), no_sample_(no_sample(spec, statistics.waves().waves)) {}

std::int64_t CampaignCurves::body_of(std::int64_t number) const { return std::int64_t(of(number).body); }

MeasuredFragility CampaignCurves::fit(std::int64_t number) const {
    auto const what = of(number);
    auto const& [b, limit, measure, levels] = what;
    auto curve = described(what);
    if (no_sample_) {
        curve.fit = unfitted(b, limit);
        return curve;
    }
    // The level itself, not the scaled wave's peak, which differs from it in the last digit.
    auto trials = statistics_.measured().singles(b, levels ? measure_named("level") : measure, limit);
    curve.split = split_by_draws(spec_, b, trials, bootstrap_of(b));
    constexpr int rank_replicates = 200;
    auto const rank = rank_area(trials, {spec_.seed, b, rank_replicates});
    curve.rank_area = rank.area;
    curve.rank_interval = middle_of(rank.replicates, options_.confidence, {0, 1});
    auto const request = request_of(b, limit, curve.split);
    curve.fit =
        levels ? over_levels(b, limit, std::move(trials), request) : over_measure(what, std::move(trials), request);
    add_quote_base(curve);
    return curve;
}

void CampaignCurves::give(std::int64_t number, BytesOut& bytes) const {
    auto const curve = fit(number);
    bytes(curve.fit, curve.split, curve.rank_area, curve.rank_interval);
}

MeasuredFragility CampaignCurves::take(std::int64_t number, BytesIn& bytes) const {
    auto curve = described(of(number));
    bytes(curve.fit, curve.split, curve.rank_area, curve.rank_interval);
    add_quote_base(curve);
    return curve;
}

CampaignCurves::Of CampaignCurves::of(std::int64_t number) const {
    auto const measures = measures_of(spec_);
    auto const place = static_cast<std::size_t>(number);
    auto const measure = place % measures.size();
    auto const of_bodies = place / measures.size();
    return {of_bodies / spec_.limits.size(), of_bodies % spec_.limits.size(), measures[measure], measure == 0};
}

MeasuredFragility CampaignCurves::described(Of const& of) const {
    MeasuredFragility curve;
    curve.limit = spec_.limits[of.limit].name;
    curve.of_levels = of.levels;
    curve.measure = of.measure;
    curve.name = name_of(of.measure, spec_);
    curve.label = label_of(of.measure, spec_);
    curve.title = title_of(of.measure, spec_);
    curve.units = units_of(of.measure, spec_.levels);
    curve.shown_in = printed_unit(curve.units, spec_.levels);
    if (!no_sample_) {
        curve.drawn = spec_.bodies[of.body].scattering();
    }
    return curve;
}

void CampaignCurves::add_quote_base(MeasuredFragility& curve) const {
    if (!no_sample_ && !curve.fit.quotes.empty()) {
        curve.quote_base = curve.of_levels ? "design-basis" : "v_ereq";
    }
}

// At the levels' measure the trials are stripes; their waves are known for the bootstrap.
FragilityFit CampaignCurves::over_levels(std::size_t body, std::size_t limit) const {
    return no_sample_ ? unfitted(body, limit)
                      : over_levels(body, limit, statistics_.measured().singles(body, measure_named("level"), limit),
                                    request_of(body, limit, {}));
}

FragilityFit CampaignCurves::over_levels(std::size_t body, std::size_t limit, std::vector<SingleTrial> trials,
                                         FragilityRequest request) const {
    auto data = FragilityData::of_stripes(statistics_.bodies()[body].stripes_of(limit));
    data.trials = std::move(trials);
    data.open = statistics_.measured().open(body, measure_named("level"), limit);
    data.waves_shared = shared();
    data.waves_left_out = statistics_.measured().passed_by() > 0;
    request.quotes = quotes_of(spec_.levels);
    request.band_at = band_over(spec_.levels, options_.band_points);
    return fit_fragility(data, request);
}

FragilityFit CampaignCurves::over_measure(Of const& of, std::vector<SingleTrial> trials,
                                          FragilityRequest request) const {
    // V_Ereq is the limit of overturning and of nothing else.
    if (of.measure == measure_named("v_wes_ratio") && of.limit == 0) {
        request.quotes = {{1, 1}};
    }
    auto const& measured = statistics_.measured();
    auto open = measured.open(of.body, of.measure, of.limit);
    auto const lost = measured.left_out(of.body, of.measure, of.limit) - std::ssize(open);
    auto data = FragilityData::of_trials(std::move(trials), shared(), std::move(open), lost, group_size());
    data.waves_left_out = measured.passed_by() > 0;
    return fit_fragility(data, request);
}

// Counts of recorded motions alone; a grid has its map.
FragilityFit CampaignCurves::unfitted(std::size_t body, std::size_t limit) const {
    FragilityFit fit;
    fit.state = *no_sample_;
    fit.passing = spec_.limits[limit].passing();
    fit.waves = spec_.wave_count;
    if (no_sample_ == FragilityState::few_records) {
        for (auto const& stripe : statistics_.bodies()[body].stripes_of(limit)) {
            fit.trials += static_cast<double>(stripe.decided());
            fit.overturned += static_cast<double>(stripe.overturned);
            fit.undecided += static_cast<double>(stripe.trials - stripe.decided());
        }
        fit.waves = spec_.source->about().shared.among(statistics_.waves().waves);
        fit.isotonic_median = {never, never};
        fit.lowest = spec_.levels.levels.front().value;
        fit.highest = spec_.levels.levels.back().value;
    }
    return fit;
}

// Has one wave, or have waves that share a draw, several trials?
bool CampaignCurves::shared() const {
    return group_size() > 1 || (!spec_.levels.independent_waves && spec_.levels.levels.size() > 1);
}

FragilityRequest CampaignCurves::request_of(std::size_t body, std::size_t limit,
                                            std::optional<BetaSplit> const& split) const {
    FragilityRequest request;
    request.confidence = options_.confidence;
    request.passing = spec_.limits[limit].passing();
    request.beta_u = options_.beta_u.value_or(spec_.beta_u);
    request.bootstrap = bootstrap_of(body);
    request.drawn = !spec_.bodies[body].scattering().empty();
    request.draws_balanced = spec_.sampling == Sampling::latin_hypercube;
    request.split = split;
    return request;
}

}  // namespace overturn
