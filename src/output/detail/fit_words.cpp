#include "output/detail/fit_words.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "core/texts_of.hpp"
#include "output/curve_spread.hpp"
#include "output/detail/interval_text.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {
namespace {

// Behind a number of trials that share what was drawn.
std::string group_text(double group_size) {
    return group_size > 1 ? fmt::format(", counting {:g} as one", group_size) : std::string();
}

std::string bound_text(FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    auto const& bound = *fit.bound;
    constexpr int digits = 4;
    bool const none = fit.state == FragilityState::none_overturned;
    auto const where = bound.from == bound.to ? unit.text(bound.from)
                                              : fmt::format("{:.4g} to {}", unit.of(bound.from), unit.text(bound.to));
    auto const* const what = fit.passing == Passing::exceeded
                                 ? none ? "no trial exceeded the limit" : "every trial exceeded the limit"
                             : none ? "nothing overturned"
                                    : "everything overturned";
    return fmt::format(
        "{}: no curve; P {} {:.4g} at {} ({} of {:g}{}, {:g} %)", what, none ? "<=" : ">=",
        none ? rounded_up(bound.probability.upper, digits) : rounded_down(bound.probability.lower, digits), where,
        none ? "none" : "all", bound.units, group_text(bound.group_size), 100 * confidence);
}

// What several stripes say together, if P does not fall.
std::string pooled_text(SeenBound const& pooled, IntensityUnit const& unit, double confidence) {
    auto const least = pooled.overturned > 0 ? fmt::format(", P >= {:.3g} at {}",
                                                           rounded_down(pooled.probability.lower), unit.text(pooled.to))
                                             : std::string();
    return fmt::format(
        "if P does not decrease with the level: P <= {:.3g} at {}{} ({} from {:.4g} to {:.4g}, {:g} %{})",
        rounded_up(pooled.probability.upper), unit.text(pooled.from), least, counts_text(pooled), unit.of(pooled.from),
        unit.of(pooled.to), 100 * confidence, least.empty() ? "" : " for both together");
}

std::string bracket_text(Interval const& bracket, IntensityUnit const& unit) {
    if (!std::isfinite(bracket.upper)) {
        return fmt::format("at or above {}", unit.text(bracket.lower));
    }
    return bracket.lower > 0 ? fmt::format("between {:.4g} and {}", unit.of(bracket.lower), unit.text(bracket.upper))
                             : fmt::format("at or below {}", unit.text(bracket.upper));
}

std::string separated_text(FragilityFit const& fit, IntensityUnit const& unit) {
    auto text = fmt::format(
        "no curve, because at most one level has both trials that {} and trials that do not: beta cannot be "
        "estimated; half of these trials {} {}",
        pass_text(fit), pass_text(fit), bracket_text(fit.isotonic_median, unit));
    if (fit.bound) {
        text += "; P there in " + interval_text(fit.bound->probability);
    }
    return text + (std::isfinite(fit.isotonic_median.upper) ? ". State more levels there" : ". State higher levels");
}

void add_state(std::vector<std::string>& texts, FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    switch (fit.state) {
        case FragilityState::no_trials:
            texts.emplace_back("no trial has a verdict: nothing is known");
            break;
        case FragilityState::none_overturned:
        case FragilityState::all_overturned:
            texts.push_back(bound_text(fit, unit, confidence));
            break;
        case FragilityState::one_level:
            texts.emplace_back("one level only: a curve needs two; see its interval");
            break;
        case FragilityState::separated:
            texts.push_back(separated_text(fit, unit));
            break;
        case FragilityState::not_rising:
            texts.push_back(fmt::format(
                "no curve: P does not increase significantly with this measure ({:g} %); use the intervals of the "
                "stripes",
                100 * confidence));
            break;
        case FragilityState::not_converged:
            texts.emplace_back("no curve: the fit did not converge");
            break;
        case FragilityState::grid:
            texts.push_back(grid_text(fit.waves));
            break;
        case FragilityState::few_records:
            texts.push_back(few_records_text(fit.waves, fit.waves));
            break;
        case FragilityState::few_waves:
            texts.push_back(
                fmt::format("no curve: it needs {} independent waves or more ({} here)", least_waves, fit.waves));
            break;
        case FragilityState::undecided:
            texts.push_back(fmt::format(
                "no curve: more than 5 % of the trials at a level below the median have no verdict ({:g} in all); "
                "use the intervals of the stripes, which include them",
                fit.undecided));
            break;
        case FragilityState::fitted:
            break;
    }
    if (fit.pooled) {
        texts.push_back(pooled_text(*fit.pooled, unit, confidence));
    }
}

std::string poor_text(FragilityFit const& fit) {
    if (!fit.goodness) {
        return {};
    }
    auto const& goodness = *fit.goodness;
    auto const stripe =
        goodness.stripe_p_value < goodness.p_value
            ? fmt::format("farthest stripe: exact p = {:.2g}, times the number of stripes", goodness.stripe_p_value)
            : fmt::format("deviance {:.3g} with {} degrees of freedom, p = {:.2g}{}", goodness.deviance,
                          goodness.degrees_of_freedom, goodness.p_value, goodness.chi_squared ? "" : " by simulation");
    return fmt::format("the lognormal curve does not fit the data ({})", stripe);
}

// The 5 % point stands, and what the trials themselves hold there.
std::string doubtful_text(FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    std::string text = "the data disagree with the curve near 5 %: do not use the 5 % point or HCLPF";
    if (!fit.beside_five_percent) {
        return text;
    }
    for (auto const* side : {&fit.beside_five_percent->below, &fit.beside_five_percent->above}) {
        if (side->units > 0) {
            text += fmt::format("; {} at {}: P in {}", counts_text(*side), unit.text(side->from),
                                interval_text(side->probability));
        }
    }
    return text + fmt::format(" ({:g} %)", 100 * confidence);
}

// Where nobody says which trials are of one wave.
std::string waves_text(FragilityFit const& fit) {
    return fit.waves_known == WavesKnown::number_unknown
               ? fmt::format(
                   "the waves are not named: these {:g} trials may be of {} alone. The intervals are widened for that. "
                   "Add a column 'wave', or state how many different waves there are (--waves)",
                   fit.trials, fit.waves)
               : fmt::format(
                   "the waves are not named: all levels may have the same {}. The intervals are widened for "
                   "that. Add a column 'wave', or state how many different waves there are (--waves)",
                   fit.waves);
}

}  // namespace

char const* pass_text(FragilityFit const& fit) {
    return fit.passing == Passing::exceeded ? "exceed the limit" : "overturn";
}

std::string grid_text(std::int64_t waves) {
    return fmt::format("a grid of {} is no sample: no curve", count_text(waves, "frequency", "frequencies"));
}

std::string few_records_text(std::int64_t records, std::int64_t recordings) {
    return records == recordings
               ? fmt::format("{}: no probability, which needs {} or more", count_text(records, "record"), least_records)
               : fmt::format("{} of {}: no probability, which needs {} recordings or more",
                             count_text(records, "record"), count_text(recordings, "recording"), least_records);
}

std::string counts_text(SeenBound const& seen) {
    return fmt::format("{:g} of {:g}{}", seen.overturned, seen.units,
                       seen.of_waves ? " independent waves" : group_text(seen.group_size));
}

std::vector<std::string> warnings_of(FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    std::vector<std::string> texts;
    add_state(texts, fit, unit, confidence);
    auto const add_if = [&](FragilityFlag flag, std::string_view text) {
        if (has(fit.flags, flag)) {
            texts.emplace_back(text);
        }
    };
    add_if(FragilityFlag::one_overturned, fit.passing == Passing::exceeded
                                              ? "only one trial exceeded the limit: the fit depends on that one"
                                              : "only one trial overturned: the fit depends on that one");
    if (fit.identifiable()) {
        std::ranges::copy(
            unusual_spread(
                {.beta_r = fit.beta_r(), .beta_u = fit.beta_u, .beta_u_stated = fit.beta_u > fit.beta_u_drawn}),
            std::back_inserter(texts));
        add_if(FragilityFlag::two_levels, "two levels only: the shape of the curve is not tested");
    }
    add_if(FragilityFlag::non_monotone, fmt::format("P decreases significantly between some levels (p = {:.2g} "
                                                    "by simulation); see the isotonic estimate",
                                                    fit.monotone.p_value));
    add_if(FragilityFlag::poor_fit, poor_text(fit));
    add_if(FragilityFlag::five_percent_doubtful, doubtful_text(fit, unit, confidence));
    add_if(FragilityFlag::no_beta_u,
           fmt::format("no HCLPF: it needs beta_U, the spread of the median from uncertain properties of the body "
                       "(--beta-u, or key statistics.beta_u). {}The 5 % point is without it",
                       fit.drawn ? "No sampled property changes the median significantly. " : ""));
    add_if(FragilityFlag::median_outside_data, "the median is outside the levels (extrapolated)");
    add_if(FragilityFlag::hclpf_outside_data, "HCLPF is below the levels (extrapolated)");
    if (fit.state != FragilityState::undecided) {
        add_if(FragilityFlag::undecided_trials,
               fmt::format("{:g} trials have no verdict and are left out of the curve{}", fit.undecided,
                           fit.identifiable() ? "; its intervals include both extremes (all stood, all fell)" : ""));
    }
    if (fit.identifiable() && fit.waves_known == WavesKnown::yes) {  // without a curve nothing is resampled
        add_if(FragilityFlag::few_waves,
               fmt::format("only {} {}{}", fit.waves, fit.group_size > 1 ? "groups of waves" : "waves",
                           fit.method == FragilityFit::Method::widest ? ": the intervals are widened for so few" : ""));
    }
    if (fit.waves_known != WavesKnown::yes && fit.trials > 0) {
        texts.push_back(waves_text(fit));
    }
    add_if(FragilityFlag::waves_left_out,
           fmt::format("curves and bootstrap use the first {} waves (2 million trials)", fit.waves));
    add_if(FragilityFlag::interval_unbounded, "an interval is open: the data do not limit it");
    for (auto const& quoted : fit.quotes) {
        if (has(fit.flags, FragilityFlag::poor_fit) && quoted.source == QuotedProbability::Source::curve) {
            texts.push_back(
                fmt::format("P at {} is from a curve that does not fit the data: its interval is too narrow",
                            unit.text(quoted.quote.intensity)));
        }
        if (quoted.in_tail) {
            texts.push_back(fmt::format(
                "P = {:.2g} at {} is more than a decade below the lowest observed proportion ({:.2g}): extrapolated "
                "along the lognormal tail. Use [rare] for such P",
                *quoted.probability, unit.text(quoted.quote.intensity), fit.lowest_proportion));
        }
    }
    return texts;
}

}  // namespace overturn::output
