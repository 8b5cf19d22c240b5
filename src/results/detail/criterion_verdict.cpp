#include "results/detail/criterion_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "stats/quantile.hpp"

namespace overturn {
namespace {

Safety safety_of(CriterionStudy const& study) {
    constexpr double most = 0.1;  // share of waves: a bound above it shows little
    if (study.safe_but_overturned.of == 0) {
        return Safety::none_predicted_safe;
    }
    if (study.safe_uplifted_but_overturned.of == 0) {
        return Safety::none_uplifted;
    }
    if (study.safe_uplifted_but_overturned.count > 0) {
        return Safety::false_safe;
    }
    if (!study.at_overturning) {
        return Safety::nothing_overturned;
    }
    return study.waves_safe_uplifted_but_overturned.interval.upper <= most ? Safety::conservative : Safety::few_waves;
}

Speaks by_false_alarms(CriterionStudy const& study) {
    constexpr double half = 0.5;
    auto const& share = study.unsafe_but_stood.interval;
    return share.lower > half ? Speaks::against : share.upper < half ? Speaks::in_favour : Speaks::neither;
}

// Of two measures' dispersions, the same resampled waves for both: nothing where no pair of replicates holds both.
std::optional<Interval> ratio_of_betas(FragilityFit const& a, FragilityFit const& b, double confidence) {
    if (a.refits.size() != b.refits.size()) {
        return std::nullopt;
    }
    std::vector<double> ratios;
    for (std::size_t r = 0; r < a.refits.size(); ++r) {
        double const ratio = a.refits[r].beta / b.refits[r].beta;
        ratios.push_back(b.refits[r].beta > 0 ? ratio : std::numeric_limits<double>::quiet_NaN());
    }
    return middle_of(ratios, confidence, {0, std::numeric_limits<double>::infinity()});
}

Speaks by_dispersion(std::optional<Interval> const& ratio) {
    return ratio && ratio->upper < 1   ? Speaks::in_favour
           : ratio && ratio->lower > 1 ? Speaks::against
                                       : Speaks::neither;
}

Speaks by_rank(MeasuredFragility const& v_wes, MeasuredFragility const& other) {
    return v_wes.rank_interval.lower > other.rank_area   ? Speaks::in_favour
           : other.rank_interval.lower > v_wes.rank_area ? Speaks::against
                                                         : Speaks::neither;
}

// V_WES against PGA, PGV and ouV_E: is anything simpler at least as good?
std::vector<MeasureBeside> others_beside(BodyAnalysis const& body, double confidence) {
    std::vector<MeasureBeside> beside;
    auto const v_wes = std::ranges::find(body.fragility, measure_named("v_wes"), &MeasuredFragility::measure);
    if (v_wes == body.fragility.end() || body.one_spectrum) {
        return beside;
    }
    for (std::size_t curve = 0; curve < body.fragility.size(); ++curve) {
        auto const& other = body.fragility[curve];
        if (other.measure == v_wes->measure || other.measure == measure_named("v_wes_ratio")) {
            continue;
        }
        MeasureBeside one{.curve = curve};
        if (v_wes->fit.identifiable() && other.fit.identifiable()) {
            one.beta_ratio = ratio_of_betas(v_wes->fit, other.fit, confidence);
            one.dispersion = by_dispersion(one.beta_ratio);
        }
        if (!std::isnan(v_wes->rank_area)) {
            one.rank = by_rank(*v_wes, other);
        }
        beside.push_back(one);
    }
    return beside;
}

}  // namespace

CriterionVerdict verdict_on(BodyAnalysis const& body, double confidence) {
    CriterionVerdict verdict;
    auto const v_wes = std::ranges::find(body.criterion, measure_named("v_wes"), &MeasuredCriterion::measure);
    if (v_wes != body.criterion.end()) {
        verdict.safety = safety_of(v_wes->study);
        verdict.false_alarms = by_false_alarms(v_wes->study);
    }
    verdict.beside = others_beside(body, confidence);
    return verdict;
}

}  // namespace overturn
