#include "output/detail/criterion_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "output/detail/ratio_columns.hpp"

namespace overturn::output {
namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string ends(Share const& share) {
    return fmt::format("{} to {}", percent(rounded_down(share.interval.lower)),
                       percent(rounded_up(share.interval.upper)));
}

std::vector<std::string>& list_of(CriterionWords& words, Speaks speaks) {
    return speaks == Speaks::in_favour ? words.supports : speaks == Speaks::against ? words.against : words.open;
}

// No trial that was predicted safe and left the ground overturned.
void say_none_false(CriterionWords& words, Safety safety, CriterionStudy const& study, double confidence) {
    auto const& tried = study.safe_uplifted_but_overturned;
    auto const& waves = study.waves_safe_uplifted_but_overturned;
    auto& list = safety == Safety::conservative ? words.supports : words.open;
    list.push_back(fmt::format(
        "{}no false-safe prediction in {} trials that uplifted ({} that did not uplift are excluded) in {} waves: "
        "false-safe rate < {} of waves ({:g} %)",
        safety == Safety::conservative ? "conservative here: "
        : safety == Safety::few_waves  ? "too few waves to call it conservative: "
                                       : "",
        tried.of, study.safe_but_overturned.of - tried.of, waves.of, percent(rounded_up(waves.interval.upper)),
        100 * confidence));
    if (study.at_overturning) {
        list.push_back(fmt::format(
            "the lowest V_WES / V_Ereq at which a trial overturned is {:.3g} (of these waves: more may go below)",
            study.at_overturning->lowest));
    } else {
        words.open.emplace_back("nothing overturned: these trials do not show how conservative V_WES is");
    }
}

void say_safety(CriterionWords& words, Safety safety, CriterionStudy const& study, double confidence) {
    auto const& tried = study.safe_uplifted_but_overturned;
    auto const& waves = study.waves_safe_uplifted_but_overturned;
    switch (safety) {
        case Safety::none_predicted_safe:
            words.open.emplace_back("not tested: V_WES predicted no trial safe");
            break;
        case Safety::none_uplifted:
            words.open.push_back(
                fmt::format("not tested: no uplift in any of the {} trials that V_WES < V_Ereq predicts safe",
                            study.safe_but_overturned.of));
            break;
        case Safety::false_safe:
            words.against.push_back(fmt::format(
                "not conservative: {} of {} trials that uplifted and were predicted safe overturned ({}; {:g} "
                "%: {}), in {} of {} waves",
                tried.count, tried.of, percent(tried.value()), 100 * confidence, ends(tried), waves.count, waves.of));
            break;
        case Safety::nothing_overturned:
        case Safety::few_waves:
        case Safety::conservative:
            say_none_false(words, safety, study, confidence);
            break;
    }
}

void say_false_alarms(CriterionWords& words, Speaks speaks, CriterionStudy const& study, double confidence) {
    auto const& price = study.unsafe_but_stood;
    if (price.of == 0) {
        return;
    }
    auto const* const share = speaks == Speaks::against     ? "more than half"
                              : speaks == Speaks::in_favour ? "fewer than half"
                                                            : "perhaps half";
    list_of(words, speaks)
        .push_back(fmt::format(
            "{} of its alarms at these levels are false{}: of {} trials predicted unsafe, {} did not overturn "
            "({}; {:g} %: {})",
            share, speaks == Speaks::neither ? " (too few trials)" : "", price.of, price.count, percent(price.value()),
            100 * confidence, ends(price)));
    if (study.first_overturning) {
        words.open.push_back(fmt::format(
            "margin: V_WES / V_Ereq at the first overturning of each wave: lowest {:.3g}, 5th percentile {}, median {}",
            study.first_overturning->lowest, percentile_text(study.first_overturning->p05),
            percentile_text(study.first_overturning->median)));
    }
}

// T0 and T1 with R in the other unit: the sources do not print which is meant, so what it decides is stated.
void say_unit(CriterionWords& words, MeasuredCriterion const& criterion) {
    auto const& share = criterion.study.safe_but_overturned;
    if (share.of > 0) {
        words.open.push_back(
            fmt::format("unit of R: with R in {} in T0 and T1, {} of {} trials predicted safe overturned",
                        name_of(criterion.radius_unit), share.count, share.of));
    }
}

// Which of two curves the data reject: its beta is that of no lognormal.
std::string rejected_text(MeasuredFragility const& own, MeasuredFragility const& other) {
    auto const poor = [](MeasuredFragility const& m) { return has(m.fit.flags, FragilityFlag::poor_fit); };
    return poor(own) && poor(other) ? "; neither curve describes the data"
           : poor(own) || poor(other)
               ? fmt::format("; the curve over {} does not describe the data", poor(own) ? "V_WES" : other.label)
               : std::string();
}

char const* significance(Speaks speaks) { return speaks == Speaks::neither ? " (no significant difference)" : ""; }

void say_dispersion(CriterionWords& words, BodyAnalysis const& body) {
    auto const own = std::ranges::find(body.fragility, measure_named("v_wes"), &MeasuredFragility::measure);
    if (own == body.fragility.end() || !own->fit.identifiable()) {
        words.open.emplace_back("no curve over V_WES: its dispersion cannot be compared");
        return;
    }
    if (body.one_spectrum) {
        words.open.emplace_back(
            "dispersion and rank of V_WES beside other measures: cannot be assessed: all waves share one target "
            "spectrum or density and differ only in phase. Use [waves.variability] or recorded motions");
        return;
    }
    for (auto const& beside : body.verdict->beside) {
        if (!beside.dispersion) {
            continue;
        }
        auto const& other = body.fragility.at(beside.curve);
        double const beta = own->fit.line->beta();
        double const theirs = other.fit.line->beta();
        auto const paired = beside.beta_ratio
                                ? fmt::format(", ratio {:.3g} [{:.3g}, {:.3g}] with waves resampled in pairs",
                                              beta / theirs, beside.beta_ratio->lower, beside.beta_ratio->upper)
                                : std::string();
        list_of(words, *beside.dispersion)
            .push_back(fmt::format("dispersion: beta is {:.3g} over V_WES and {:.3g} over {}{}{}{}", beta, theirs,
                                   other.label, paired, rejected_text(*own, other), significance(*beside.dispersion)));
    }
}

void say_rank(CriterionWords& words, BodyAnalysis const& body) {
    auto const own = std::ranges::find(body.fragility, measure_named("v_wes"), &MeasuredFragility::measure);
    for (auto const& beside : body.verdict->beside) {
        if (beside.rank) {
            auto const& other = body.fragility.at(beside.curve);
            list_of(words, *beside.rank)
                .push_back(fmt::format("rank: V_WES is higher for the trial that overturned in {} of pairs, {} in {}{}",
                                       percent(own->rank_area), other.label, percent(other.rank_area),
                                       significance(*beside.rank)));
        }
    }
}

}  // namespace

CriterionWords words_on(BodyAnalysis const& body, double confidence) {
    CriterionWords words;
    if (body.grid && !body.criterion.empty()) {
        words.open.emplace_back(
            "waves on a grid of frequencies are not a random sample: shares and ranks are not probabilities");
    }
    if (!body.verdict) {
        return words;
    }
    for (auto const& criterion : body.criterion) {
        if (criterion.measure == measure_named("v_wes")) {
            say_safety(words, body.verdict->safety, criterion.study, confidence);
            say_false_alarms(words, body.verdict->false_alarms, criterion.study, confidence);
        } else if (criterion.measure == measure_named("v_wes_other_unit")) {
            say_unit(words, criterion);
        }
    }
    say_dispersion(words, body);
    say_rank(words, body);
    return words;
}

}  // namespace overturn::output
