#include "results/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/field.hpp"
#include "results/detail/criterion_verdict.hpp"
#include "results/detail/drawn_trials.hpp"
#include "results/detail/fitted_measures.hpp"
#include "results/detail/level_quantiles.hpp"
#include "results/few_waves.hpp"
#include "results/statistics.hpp"
#include "stats/quantile.hpp"
#include "stats/rank.hpp"

namespace overturn {
namespace {

std::vector<Quote> quotes_of(LevelSpec const& levels) {
    std::vector<Quote> quotes;
    auto const base = std::find_if(levels.levels.begin(), levels.levels.end(),
                                   [](Level const& l) { return l.purpose == LevelClass::design_basis; });
    if (base == levels.levels.end()) {
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

// Leaves the counts: where waves are no sample, shares have no intervals and ratios no quantiles.
void keep_counts(CriterionStudy& study) {
    study.at_overturning.reset();
    study.first_overturning.reset();
    study.highest_standing.reset();
    for (auto* share : {&study.safe_but_overturned, &study.overturned_predicted_safe, &study.unsafe_but_stood,
                        &study.stood_predicted_unsafe, &study.waves_safe_but_overturned,
                        &study.safe_uplifted_but_overturned, &study.waves_safe_uplifted_but_overturned}) {
        share->interval = {never, never};
    }
}

class Analyst {
  public:
    Analyst(CampaignSpec const& spec, Statistics const& statistics, AnalysisOptions const& options)
        : spec_(spec),
          statistics_(statistics),
          options_(options),
          no_sample_(no_sample(spec, statistics.waves().waves)) {}

    [[nodiscard]] BodyAnalysis of(std::size_t b) const {
        BodyAnalysis body;
        body.body = spec_.bodies[b].name;
        body.variability = spec_.source->about().variability;
        body.sigma = statistics_.achieved_sigma();
        body.one_spectrum = spec_.source->about().of_one_spectrum;
        body.fragility = fragility(b, 0);
        for (std::size_t limit = 1; limit < spec_.limits.size(); ++limit) {
            auto const& stated = spec_.limits[limit];
            body.limits.push_back({stated.name, definition_of(stated, spec_.limits), fragility(b, limit)});
        }
        if (no_sample_ == FragilityState::grid) {
            body.grid = map_of(b);
        } else if (!no_sample_) {
            body.quantiles = level_quantiles(spec_, statistics_.measured(), b, options_.confidence);
        }
        for (auto const* const measure : criteria_of(spec_)) {
            auto const unit =
                !measure->other_unit_of.empty() ? other(spec_.measures.radius_unit) : spec_.measures.radius_unit;
            body.criterion.push_back({measure, unit,
                                      study_criterion(statistics_.measured().criterion_trials(b, measure),
                                                      options_.confidence, group_size())});
            if (no_sample_) {
                keep_counts(body.criterion.back().study);
            }
        }
        if (spec_.measures.energy && !no_sample_) {
            body.response = response_bins(statistics_.measured().responses(b));
            body.verdict = verdict_on(body, options_.confidence);
        }
        return body;
    }

    /// At the levels' measure the trials are stripes; their waves are known for the bootstrap.
    [[nodiscard]] FragilityFit over_levels(std::size_t b, std::size_t limit) const {
        return no_sample_ ? unfitted(b, limit)
                          : over_levels(b, limit, singles(b, measure_named("level"), limit), request_of(b, limit, {}));
    }

  private:
    [[nodiscard]] GridMap map_of(std::size_t b) const {
        GridMap map{spec_.levels.measure_name(), printed_unit(spec_.levels.units(), spec_.levels), {}, {}, {}};
        std::ranges::transform(spec_.levels.levels, std::back_inserter(map.levels), &Level::value);
        std::ranges::transform(spec_.limits, std::back_inserter(map.limits), &LimitState::name);
        map.lines = statistics_.bodies()[b].grid;
        return map;
    }

    [[nodiscard]] FragilityFit over_levels(std::size_t b, std::size_t limit, std::vector<SingleTrial> trials,
                                           FragilityRequest request) const {
        auto data = FragilityData::of_stripes(statistics_.bodies()[b].stripes_of(limit));
        data.trials = std::move(trials);
        data.open = statistics_.measured().open(b, measure_named("level"), limit);
        data.waves_shared = shared();
        data.waves_left_out = statistics_.measured().passed_by() > 0;
        request.quotes = quotes_of(spec_.levels);
        request.band_at = band_over(spec_.levels, options_.band_points);
        return fit_fragility(data, request);
    }

    // Counts of recorded motions alone; a grid has its map.
    [[nodiscard]] FragilityFit unfitted(std::size_t b, std::size_t limit) const {
        FragilityFit fit;
        fit.state = *no_sample_;
        fit.passing = spec_.limits[limit].passing();
        fit.waves = spec_.wave_count;
        if (no_sample_ == FragilityState::few_records) {
            for (auto const& stripe : statistics_.bodies()[b].stripes_of(limit)) {
                fit.trials += static_cast<double>(stripe.decided());
                fit.overturned += static_cast<double>(stripe.overturned);
                fit.undecided += static_cast<double>(stripe.trials - stripe.decided());
            }
            fit.waves = statistics_.waves().waves;
            fit.isotonic_median = {never, never};
            fit.lowest = spec_.levels.levels.front().value;
            fit.highest = spec_.levels.levels.back().value;
        }
        return fit;
    }

    // Has one wave, or have waves that share a draw, several trials?
    [[nodiscard]] bool shared() const {
        return group_size() > 1 || (!spec_.levels.independent_waves && spec_.levels.levels.size() > 1);
    }
    [[nodiscard]] std::int64_t group_size() const { return spec_.source->about().shared.most; }
    [[nodiscard]] FragilityRequest request_of(std::size_t b, std::size_t limit,
                                              std::optional<BetaSplit> const& split) const {
        FragilityRequest request;
        request.confidence = options_.confidence;
        request.passing = spec_.limits[limit].passing();
        request.beta_u = options_.beta_u.value_or(spec_.beta_u);
        request.bootstrap = bootstrap_of(b);
        request.drawn = !spec_.bodies[b].scattering().empty();
        request.draws_balanced = spec_.sampling == Sampling::latin_hypercube;
        request.split = split;
        return request;
    }
    [[nodiscard]] BootstrapKey bootstrap_of(std::size_t b) const { return {spec_.seed, b, options_.replicates}; }
    [[nodiscard]] std::vector<SingleTrial> singles(std::size_t b, Measure measure, std::size_t limit) const {
        return statistics_.measured().singles(b, measure, limit);
    }

    [[nodiscard]] FragilityFit over_measure(std::size_t b, std::size_t limit, Measure measure,
                                            std::vector<SingleTrial> trials, FragilityRequest request) const {
        // V_Ereq is the limit of overturning and of nothing else.
        if (measure == measure_named("v_wes_ratio") && limit == 0) {
            request.quotes = {{1, 1}};
        }
        auto const& measured = statistics_.measured();
        std::int64_t const body = b;
        auto open = measured.open(body, measure, limit);
        auto const lost = measured.left_out(body, measure, limit) - std::ssize(open);
        auto data = FragilityData::of_trials(std::move(trials), shared(), std::move(open), lost, group_size());
        data.waves_left_out = measured.passed_by() > 0;
        return fit_fragility(data, request);
    }

    [[nodiscard]] std::vector<MeasuredFragility> fragility(std::size_t b, std::size_t limit) const {
        std::vector<MeasuredFragility> fits;
        auto const measures = measures_of(spec_);
        fits.reserve(measures.size());
        for (auto const* const measure : measures) {
            fits.push_back(fragility(b, limit, measure, measure == measures.front()));
        }
        return fits;
    }

    [[nodiscard]] MeasuredFragility fragility(std::size_t b, std::size_t limit, Measure measure, bool levels) const {
        MeasuredFragility result;
        result.limit = spec_.limits[limit].name;
        result.of_levels = levels;
        result.measure = measure;
        result.name = name_of(measure, spec_);
        result.label = label_of(measure, spec_);
        result.title = title_of(measure, spec_);
        result.units = units_of(measure, spec_.levels);
        result.shown_in = printed_unit(result.units, spec_.levels);
        if (no_sample_) {
            result.fit = unfitted(b, limit);
            return result;
        }
        // The level itself, not the scaled wave's peak, which differs from it in the last digit.
        auto trials = singles(b, levels ? measure_named("level") : measure, limit);
        result.split = split_by_draws(spec_, b, trials, bootstrap_of(b));
        result.drawn = spec_.bodies[b].scattering();
        constexpr int rank_replicates = 200;
        auto const rank = rank_area(trials, {spec_.seed, b, rank_replicates});
        result.rank_area = rank.area;
        result.rank_interval = middle_of(rank.replicates, options_.confidence, {0, 1});
        auto const request = request_of(b, limit, result.split);
        result.fit = levels ? over_levels(b, limit, std::move(trials), request)
                            : over_measure(b, limit, measure, std::move(trials), request);
        if (!result.fit.quotes.empty()) {
            result.quote_base = levels ? "design-basis" : "v_ereq";
        }
        return result;
    }

    CampaignSpec const& spec_;
    Statistics const& statistics_;
    AnalysisOptions const& options_;
    std::optional<FragilityState> no_sample_;
};

}  // namespace

std::vector<BodyAnalysis> analyse(CampaignSpec const& spec, Statistics const& statistics,
                                  AnalysisOptions const& options) {
    Analyst const analyst(spec, statistics, options);
    std::vector<BodyAnalysis> bodies;
    bodies.reserve(spec.bodies.size());
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        bodies.push_back(analyst.of(b));
    }
    return bodies;
}

void tell_velocities(std::vector<BodyAnalysis>& bodies, std::optional<IntensityUnit> const& unit) {
    auto const tell = [&](std::vector<MeasuredFragility>& fits) {
        for (auto& fit : fits) {
            fit.shown_in = unit && fit.units == "m/s" ? *unit : fit.shown_in;
        }
    };
    for (auto& body : bodies) {
        tell(body.fragility);
        for (auto& limit : body.limits) {
            tell(limit.fragility);
        }
    }
}

FragilityFit fit_over_levels(CampaignSpec const& spec, Statistics const& statistics, std::size_t body,
                             AnalysisOptions const& options, std::size_t limit) {
    return Analyst(spec, statistics, options).over_levels(body, limit);
}

}  // namespace overturn
