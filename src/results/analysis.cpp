#include "results/analysis.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "core/error.hpp"
#include "core/field.hpp"
#include "results/detail/criterion_verdict.hpp"
#include "results/detail/fitted_measures.hpp"
#include "results/detail/level_quantiles.hpp"
#include "results/few_waves.hpp"

namespace overturn {
namespace {

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

std::vector<MeasuredFragility> fitted_alone(CampaignCurves const& curves) {
    std::vector<MeasuredFragility> fits;
    for (std::int64_t number = 0; number < curves.count(); ++number) {
        fits.push_back(curves.fit(number));
    }
    return fits;
}

class Analyst {
  public:
    Analyst(CampaignSpec const& spec, Statistics const& statistics, AnalysisOptions const& options)
        : spec_(spec),
          statistics_(statistics),
          options_(options),
          no_sample_(no_sample(spec, statistics.waves().waves)) {}

    /// \param curves all of the body, which takes them
    [[nodiscard]] BodyAnalysis of(std::size_t b, std::span<MeasuredFragility> curves) const {
        auto const measures = curves.size() / spec_.limits.size();
        auto const curves_of = [&](std::size_t limit) {
            auto const own = curves.subspan(limit * measures, measures);
            return std::vector(std::move_iterator(own.begin()), std::move_iterator(own.end()));
        };
        BodyAnalysis body;
        body.body = spec_.bodies[b].name;
        body.variability = spec_.source->about().variability;
        body.sigma = statistics_.achieved_sigma();
        body.one_spectrum = spec_.source->about().of_one_spectrum;
        body.fragility = curves_of(0);
        for (std::size_t limit = 1; limit < spec_.limits.size(); ++limit) {
            auto const& stated = spec_.limits[limit];
            body.limits.push_back({stated.name, definition_of(stated, spec_.limits), curves_of(limit)});
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
                                                      options_.confidence, spec_.source->about().shared.effect())});
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

  private:
    [[nodiscard]] GridMap map_of(std::size_t b) const {
        GridMap map{spec_.levels.measure_name(), printed_unit(spec_.levels.units(), spec_.levels), {}, {}, {}};
        std::ranges::transform(spec_.levels.levels, std::back_inserter(map.levels), &Level::value);
        std::ranges::transform(spec_.limits, std::back_inserter(map.limits), &LimitState::name);
        map.lines = statistics_.bodies()[b].grid;
        return map;
    }

    CampaignSpec const& spec_;
    Statistics const& statistics_;
    AnalysisOptions const& options_;
    std::optional<FragilityState> no_sample_;
};

}  // namespace

std::vector<BodyAnalysis> analyse(CampaignSpec const& spec, Statistics const& statistics,
                                  AnalysisOptions const& options, FitCurves const& fit) {
    CampaignCurves const curves(spec, statistics, options);
    auto fits = fit ? fit(curves) : fitted_alone(curves);
    OVERTURN_ENSURE(std::ssize(fits) == curves.count());
    Analyst const analyst(spec, statistics, options);
    auto const of_body = fits.size() / spec.bodies.size();
    std::vector<BodyAnalysis> bodies;
    bodies.reserve(spec.bodies.size());
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        bodies.push_back(analyst.of(b, std::span(fits).subspan(b * of_body, of_body)));
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
    return CampaignCurves(spec, statistics, options).over_levels(body, limit);
}

}  // namespace overturn
