#include <array>
#include <cmath>

#include <fmt/format.h>

#include "stats/fragility.hpp"

namespace overturn {
namespace {

constexpr std::array<char const*, fragility_flags> flag_names{"no-trials",
                                                              "nothing-overturned",
                                                              "all-overturned",
                                                              "one-level",
                                                              "separated",
                                                              "not-rising",
                                                              "not-converged",
                                                              "one-overturned",
                                                              "two-levels",
                                                              "non-monotone",
                                                              "poor-fit",
                                                              "median-outside-data",
                                                              "hclpf-outside-data",
                                                              "undecided-trials",
                                                              "few-waves",
                                                              "interval-unbounded",
                                                              "waves-left-out",
                                                              "no-beta-u",
                                                              "no-five-percent-point"};

// The same with the words of the limit state: "nothing-overturned", "nothing overturned".
std::string in_words(std::string text, Passing passing) {
    constexpr std::string_view overturned = "overturned";
    auto const at = text.find(overturned);
    if (passing == Passing::exceeded && at != std::string::npos) {
        text.replace(at, overturned.size(), "exceeded");
    }
    return text;
}

// Behind a number of trials that share what was drawn.
std::string alike_text(double alike) {
    return alike > 1 ? fmt::format(", counting {:g} as one", alike) : std::string();
}

std::string bound_text(FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    auto const& bound = *fit.bound;
    bool const none = fit.state == FragilityState::none_overturned;
    auto const where = bound.from == bound.to ? unit.text(bound.from)
                                              : fmt::format("{:.4g} to {}", unit.of(bound.from), unit.text(bound.to));
    auto const* const what = fit.passing == Passing::exceeded
                                 ? none ? "no trial exceeded it" : "every trial exceeded it"
                             : none ? "nothing overturned"
                                    : "everything overturned";
    return fmt::format("{}: no curve can be fitted; P {} {:.4g} at {} ({} of {:g}{}, {:g} %)", what,
                       none ? "<=" : ">=", none ? bound.probability.upper : bound.probability.lower, where,
                       none ? "none" : "all", bound.units, alike_text(bound.alike), 100 * confidence);
}

// What several stripes say together, if P does not fall.
std::string pooled_text(SeenBound const& pooled, IntensityUnit const& unit, double confidence) {
    auto const least = pooled.overturned > 0
                           ? fmt::format(" and at least {:.3g} at {}", pooled.probability.lower, unit.text(pooled.to))
                           : std::string();
    return fmt::format("if P does not fall, it is at most {:.3g} at {}{} ({} from {:.4g} to {:.4g}, {:g} %{})",
                       pooled.probability.upper, unit.text(pooled.from), least, counts_text(pooled),
                       unit.of(pooled.from), unit.of(pooled.to), 100 * confidence,
                       least.empty() ? "" : " for both together");
}

std::string bracket_text(Interval const& bracket, IntensityUnit const& unit) {
    if (!std::isfinite(bracket.upper)) {
        return fmt::format("at or above {}", unit.text(bracket.lower));
    }
    return bracket.lower > 0 ? fmt::format("between {:.4g} and {}", unit.of(bracket.lower), unit.text(bracket.upper))
                             : fmt::format("at or below {}", unit.text(bracket.upper));
}

std::string separated_text(FragilityFit const& fit, IntensityUnit const& unit) {
    auto text =
        fmt::format("all that {}, or at the one level where both happened: beta cannot be told, the median lies {}",
                    fit.passing == Passing::exceeded ? "kept within it lie below all that exceeded it"
                                                     : "stood lie below all that overturned",
                    bracket_text(fit.isotonic_median, unit));
    if (fit.penalised) {
        text += fmt::format("; penalised (Firth) median {}, beta {:.3g}",
                            unit.text(std::exp(fit.penalised->log_median())), fit.penalised->beta());
    }
    if (fit.bound) {
        text +=
            fmt::format("; P there in [{:.3g}, {:.3g}]", fit.bound->probability.lower, fit.bound->probability.upper);
    }
    return text;
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
            texts.emplace_back("one intensity only: its interval is all there is, a curve needs two");
            break;
        case FragilityState::separated:
            texts.push_back(separated_text(fit, unit));
            break;
        case FragilityState::not_rising:
            texts.push_back(
                fmt::format("P does not rise with this measure beyond chance ({:g} %): no lognormal curve; "
                            "the stripes' own intervals hold",
                            100 * confidence));
            break;
        case FragilityState::not_converged:
            texts.emplace_back("the fit did not converge: no curve is given");
            break;
        case FragilityState::grid:
            texts.push_back(grid_text(fit.waves));
            break;
        case FragilityState::undecided:
            texts.push_back(
                fmt::format("more than 5 % of the trials at some intensity below the median have no verdict ({:g} in "
                            "all): where it lies hangs on what they would have done; the stripes, which hold whatever "
                            "that is, are the answer",
                            fit.undecided));
            break;
        case FragilityState::fitted:
            break;
    }
    if (fit.pooled) {
        texts.push_back(pooled_text(*fit.pooled, unit, confidence));
    }
}

}  // namespace

std::string IntensityUnit::text(double intensity) const {
    return symbol.empty() || symbol == "1" ? fmt::format("{:.4g}", of(intensity))
                                           : fmt::format("{:.4g} {}", of(intensity), symbol);
}

std::string grid_text(std::int64_t waves) {
    return fmt::format("a grid of {} {} is no sample: no curve", waves, waves == 1 ? "frequency" : "frequencies");
}

std::string counts_text(SeenBound const& seen) {
    return fmt::format("{:g} of {:g}{}", seen.overturned, seen.units,
                       seen.of_waves ? " independent waves" : alike_text(seen.alike));
}

std::string name_of(FragilityState state, Passing passing) {
    switch (state) {
        case FragilityState::fitted:
            return "fitted";
        case FragilityState::no_trials:
            return "no-trials";
        case FragilityState::none_overturned:
            return in_words("nothing-overturned", passing);
        case FragilityState::all_overturned:
            return in_words("all-overturned", passing);
        case FragilityState::one_level:
            return "one-level";
        case FragilityState::separated:
            return "separated";
        case FragilityState::not_rising:
            return "not-rising";
        case FragilityState::grid:
            return "grid";
        case FragilityState::undecided:
            return "undecided";
        case FragilityState::not_converged:
            break;
    }
    return "not-converged";
}

std::vector<std::string> names_of(FragilityFlags flags, Passing passing) {
    std::vector<std::string> names;
    for (std::uint32_t f = 0; f < fragility_flags; ++f) {
        if (has(flags, static_cast<FragilityFlag>(f))) {
            names.push_back(in_words(flag_names.at(f), passing));
        }
    }
    return names;
}

namespace {

std::string poor_text(FragilityFit const& fit) {
    if (!fit.goodness) {
        return {};
    }
    auto const& goodness = *fit.goodness;
    auto const stripe =
        goodness.stripe_p_value < goodness.p_value
            ? fmt::format("the stripe farthest from it, p = {:.2g} by its exact tail times the number of stripes",
                          goodness.stripe_p_value)
            : fmt::format("deviance {:.3g} with {} degrees of freedom, p = {:.2g}", goodness.deviance,
                          goodness.degrees_of_freedom, goodness.p_value);
    return fmt::format("the lognormal curve does not describe the proportions ({})", stripe);
}

}  // namespace

std::vector<std::string> warnings_of(FragilityFit const& fit, IntensityUnit const& unit, double confidence) {
    std::vector<std::string> texts;
    add_state(texts, fit, unit, confidence);
    auto const add_if = [&](FragilityFlag flag, std::string_view text) {
        if (has(fit.flags, flag)) {
            texts.emplace_back(text);
        }
    };
    add_if(FragilityFlag::one_overturned, fit.passing == Passing::exceeded
                                              ? "one trial exceeded it: whatever is fitted hangs on that one"
                                              : "one trial overturned: whatever is fitted hangs on it");
    if (fit.identifiable()) {
        add_if(FragilityFlag::two_levels, "two intensities: the curve goes through both, nothing tests its shape");
    }
    add_if(FragilityFlag::non_monotone,
           fmt::format("the proportions fall somewhere, beyond chance (p = {:.2g}): rocking need not be monotone; see "
                       "the isotonic estimate",
                       fit.monotone.p_value));
    add_if(FragilityFlag::poor_fit, poor_text(fit));
    add_if(FragilityFlag::no_five_percent_point,
           "the proportions contradict the curve where 5 % and HCLPF would be read off it: neither is told");
    if (!has(fit.flags, FragilityFlag::no_five_percent_point)) {
        add_if(
            FragilityFlag::no_beta_u,
            "no beta_U was stated (--beta-u), or drawn (scattered bodies) that moves the median beyond chance: the 5 % "
            "point is that of one curve, and there is no HCLPF");
    }
    add_if(FragilityFlag::median_outside_data, "the median lies outside what was tried: extrapolated");
    add_if(FragilityFlag::hclpf_outside_data, "HCLPF lies below all that was tried: extrapolated");
    if (fit.state != FragilityState::undecided) {
        add_if(FragilityFlag::undecided_trials,
               fmt::format("{:g} trials have no verdict and are left out of the curve{}", fit.undecided,
                           fit.identifiable() ? "; its intervals hold with all of them standing and all fallen" : ""));
    }
    add_if(FragilityFlag::few_waves, fmt::format("{} {} only: intervals from resampling them are too short (of ten "
                                                 "they hold in 90 % instead of 95, of five in 84)",
                                                 fit.waves, fit.alike > 1 ? "groups of waves" : "waves"));
    add_if(
        FragilityFlag::waves_left_out,
        fmt::format("resampled, and fitted but for stripes, are the first {} waves: the million trials that are held",
                    fit.waves));
    add_if(FragilityFlag::interval_unbounded, "an interval is open: the data do not bound it");
    for (auto const& quoted : fit.quotes) {
        if (has(fit.flags, FragilityFlag::poor_fit) && quoted.source == QuotedProbability::Source::curve) {
            texts.push_back(
                fmt::format("P at {} comes from a curve that does not describe the data: its bounds are too "
                            "narrow",
                            unit.text(quoted.quote.intensity)));
        }
        if (quoted.in_tail) {
            texts.push_back(
                fmt::format("P = {:.2g} at {} lies more than a decade under the lowest proportion seen ({:.2g}): a "
                            "lognormal tail may err to either side there; [rare] estimates such P",
                            *quoted.probability, unit.text(quoted.quote.intensity), fit.lowest_proportion));
        }
    }
    return texts;
}

}  // namespace overturn
