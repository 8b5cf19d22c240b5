#include "results/detail/criterion_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "results/analysis.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string ends(Share const& share) {
    return fmt::format("{} to {}", percent(share.interval.lower), percent(share.interval.upper));
}

void judge_safety(CriterionVerdict& verdict, CriterionStudy const& study, double confidence) {
    auto const& share = study.safe_but_overturned;
    if (share.of == 0) {
        verdict.open.emplace_back("V_WES called no trial safe: whether safe means safe was not tried");
        return;
    }
    auto const& tried = study.safe_uplifted_but_overturned;
    auto const& waves = study.waves_safe_uplifted_but_overturned;
    if (tried.of == 0) {
        verdict.open.push_back(
            fmt::format("not tested: none of the {} trials that V_WES < V_Ereq predicts safe uplifted", share.of));
        return;
    }
    if (tried.count > 0) {
        verdict.against.push_back(fmt::format(
            "not conservative: {} of {} trials that uplifted and were predicted safe overturned ({}; {:g} "
            "%: {}), in {} of {} waves",
            tried.count, tried.of, percent(tried.value()), 100 * confidence, ends(tried), waves.count, waves.of));
        return;
    }
    constexpr double most = 0.1;  // share of waves: a bound above it shows little
    bool const shown = study.at_overturning && waves.interval.upper <= most;
    auto text = fmt::format(
        "{}no false-safe prediction in {} trials that uplifted ({} that did not uplift are excluded) in {} waves: "
        "false-safe rate < {} of waves ({:g} %)",
        shown                  ? "conservative here: "
        : study.at_overturning ? "too few waves to call it conservative: "
                               : "",
        tried.of, share.of - tried.of, waves.of, percent(waves.interval.upper), 100 * confidence);
    auto& list = shown ? verdict.supports : verdict.open;
    list.push_back(std::move(text));
    if (study.at_overturning) {
        list.push_back(fmt::format(
            "the lowest V_WES / V_Ereq at which a trial overturned is {:.3g} (of these waves: more may go below)",
            study.at_overturning->lowest));
    } else {
        verdict.open.emplace_back("nothing overturned: these trials do not show how conservative V_WES is");
    }
}

void judge_price(CriterionVerdict& verdict, CriterionStudy const& study, double confidence) {
    auto const& price = study.unsafe_but_stood;
    if (price.of == 0) {
        return;
    }
    constexpr double half = 0.5;
    bool const dear = price.interval.lower > half;
    bool const cheap = price.interval.upper < half;
    auto const* const share = dear ? "more than half" : cheap ? "fewer than half" : "more or fewer than half";
    auto text = fmt::format(
        "{} of its alarms at these levels are false{}: of {} trials predicted unsafe, {} did not overturn "
        "({}; {:g} %: {})",
        share, dear || cheap ? "" : " (too few trials)", price.of, price.count, percent(price.value()),
        100 * confidence, ends(price));
    (dear ? verdict.against : cheap ? verdict.supports : verdict.open).push_back(std::move(text));
    if (study.first_overturning) {
        verdict.open.push_back(fmt::format(
            "margin: half of the waves that overturned the body first did so at V_WES / V_Ereq above {:.3g}, 5 % below "
            "{:.3g}",
            study.first_overturning->median, study.first_overturning->p05));
    }
}

// T0 and T1 with R in the other unit: the sources do not print which is meant, so what it decides is said.
void judge_unit(CriterionVerdict& verdict, MeasuredCriterion const& criterion) {
    auto const& share = criterion.study.safe_but_overturned;
    if (share.of > 0) {
        verdict.open.push_back(
            fmt::format("unit of R: with R in {} in T0 and T1, {} of {} trials predicted safe overturned",
                        name_of(criterion.radius_unit), share.count, share.of));
    }
}

bool is_v_wes(MeasuredFragility const& m) { return m.measure == measure_named("v_wes"); }

// Of two measures' dispersions, waves resampled for both alike: nothing where no pair of replicates holds both.
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

// Which of two curves the data reject: its beta is that of no lognormal.
std::string rejected_text(MeasuredFragility const& own, MeasuredFragility const& other) {
    auto const poor = [](MeasuredFragility const& m) { return has(m.fit.flags, FragilityFlag::poor_fit); };
    return poor(own) && poor(other) ? "; neither curve describes the data"
           : poor(own) || poor(other)
               ? fmt::format("; the curve over {} does not describe the data", poor(own) ? "V_WES" : other.label)
               : std::string();
}

constexpr char const* not_testable =
    "cannot be assessed: all waves share one target spectrum or density and differ only in phase. Use "
    "[waves.variability] or recorded motions";

// V_WES against PGA, PGV and ouV_E: is anything simpler at least as good?
void compare_dispersion(CriterionVerdict& verdict, BodyAnalysis const& body, double confidence) {
    auto const own = std::find_if(body.fragility.begin(), body.fragility.end(), is_v_wes);
    if (own == body.fragility.end() || !own->fit.identifiable()) {
        verdict.open.emplace_back("no curve over V_WES: its dispersion cannot be compared");
        return;
    }
    if (body.one_spectrum) {
        verdict.open.push_back(fmt::format("dispersion and rank of V_WES beside other measures: {}", not_testable));
        return;
    }
    for (auto const& other : body.fragility) {
        if (is_v_wes(other) || other.measure == measure_named("v_wes_ratio") || !other.fit.identifiable()) {
            continue;
        }
        double const beta = own->fit.line->beta();
        double const theirs = other.fit.line->beta();
        auto const ratio = ratio_of_betas(own->fit, other.fit, confidence);
        bool const better = ratio && ratio->upper < 1;
        bool const worse = ratio && ratio->lower > 1;
        auto& list = better ? verdict.supports : worse ? verdict.against : verdict.open;
        auto const rejected = rejected_text(*own, other);
        auto const paired = ratio ? fmt::format(", ratio {:.3g} [{:.3g}, {:.3g}] with waves resampled in pairs",
                                                beta / theirs, ratio->lower, ratio->upper)
                                  : std::string();
        list.push_back(fmt::format("dispersion: beta is {:.3g} over V_WES and {:.3g} over {}{}{}{}", beta, theirs,
                                   other.label, paired, rejected,
                                   better || worse ? "" : " (no significant difference)"));
    }
}

void compare_rank(CriterionVerdict& verdict, BodyAnalysis const& body) {
    auto const own = std::find_if(body.fragility.begin(), body.fragility.end(), is_v_wes);
    if (own == body.fragility.end() || std::isnan(own->rank_area) || body.one_spectrum) {
        return;
    }
    for (auto const& other : body.fragility) {
        if (is_v_wes(other) || other.measure == measure_named("v_wes_ratio")) {
            continue;
        }
        bool const better = own->rank_interval.lower > other.rank_area;
        bool const worse = other.rank_interval.lower > own->rank_area;
        auto& list = better ? verdict.supports : worse ? verdict.against : verdict.open;
        list.push_back(fmt::format("rank: V_WES is higher for the trial that overturned in {} of pairs, {} in {}{}",
                                   percent(own->rank_area), other.label, percent(other.rank_area),
                                   better || worse ? "" : " (no significant difference)"));
    }
}

}  // namespace

CriterionVerdict verdict_on(BodyAnalysis const& body, double confidence) {
    CriterionVerdict verdict;
    for (auto const& criterion : body.criterion) {
        if (criterion.measure == measure_named("v_wes")) {
            judge_safety(verdict, criterion.study, confidence);
            judge_price(verdict, criterion.study, confidence);
        } else if (criterion.measure == measure_named("v_wes_other_unit")) {
            judge_unit(verdict, criterion);
        }
    }
    compare_dispersion(verdict, body, confidence);
    compare_rank(verdict, body);
    return verdict;
}

}  // namespace overturn
