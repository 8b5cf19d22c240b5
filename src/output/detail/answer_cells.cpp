#include "output/detail/answer_cells.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "output/detail/answer_parts.hpp"
#include "output/detail/fit_names.hpp"
#include "output/detail/interval_text.hpp"

namespace overturn::output {
namespace {

// "19.1", "1280", "<0.1": three digits, never more letters than a column holds.
std::string number_text(double value, double least) {
    if (value > 0 && value < least) {
        return fmt::format("<{:g}", rounded_up(least, 2));  // 0.1 mm is 0.0039 in
    }
    auto const rounded = rounded_up(value);
    constexpr double most = 1e6;
    return rounded < most ? fmt::format("{:.{}f}", rounded,
                                        rounded >= 100 || rounded == 0 ? 0
                                        : rounded >= 10                ? 1
                                                                       : 2)
                          : fmt::format("{:.2g}", rounded);
}

// An amplitude that the body withstands, rounded down.
std::string withstood_text(MeasuredFragility const& curve, double intensity) {
    return curve.shown_in.text(curve.shown_in.si * rounded_down(curve.shown_in.of(intensity)));
}

// The safe end first.
std::string least_text(MeasuredFragility const& curve, Interval const& ends, double estimate) {
    return fmt::format(">= {} (estimate {})", withstood_text(curve, ends.lower), withstood_text(curve, estimate));
}

std::string unlimited_text(FragilityFit const& fit) {
    return fit.waves > 0 ? fmt::format("unknown: {} waves do not limit it from below", fit.waves)
                         : std::string("unknown: the trials do not limit it from below");
}

}  // namespace

std::string passed_text(Stripe const& stripe) {
    auto const undecided = stripe.trials - stripe.decided();
    return fmt::format("{} of {}{}", stripe.overturned, stripe.trials,
                       undecided > 0 ? fmt::format(" ({} undecided)", undecided) : std::string());
}

std::string percentiles_text(LevelQuantiles const* at, double unit, double least) {
    if (at == nullptr) {
        return "not simulated";
    }
    if (mostly_unknown(*at)) {
        return fmt::format("not known ({} of {})", at->unknown, at->trials + at->unknown);
    }
    auto const text = [&](double value) {
        return value >= at->fallen ? std::string("fell") : number_text(value / unit, least);
    };
    auto const& median = at->quantiles.front().value;
    auto const& high = at->quantiles.back();
    if (std::isnan(high.value)) {  // of few waves
        auto const first = text(at->least);
        auto const last = text(at->most);
        return (first == last ? last : first + " to " + last)
               + (at->unknown > 0 ? fmt::format(", {} not known", at->unknown) : std::string());
    }
    if (high.upper && *high.upper / unit < least) {
        return text(*high.upper);
    }
    auto const first = text(median);
    auto numbers = first.starts_with('<') && first == text(high.value) ? first : first + " / " + text(high.value);
    if (high.value >= at->fallen) {
        return numbers;
    }
    return numbers + (high.upper ? fmt::format(" (<= {})", text(*high.upper)) : std::string(no_upper_end));
}

std::string five_percent_text(MeasuredFragility const& curve) {
    auto const& fit = curve.fit;
    if (!fit.identifiable()) {
        return fmt::format("no curve ({})", state_words(fit));
    }
    auto const& ends = fit.intervals().five_percent_point;
    return ends.lower > 0 ? least_text(curve, ends, *fit.five_percent_point()) : unlimited_text(fit);
}

std::string hclpf_text(MeasuredFragility const& curve, HclpfWords words) {
    auto const& fit = curve.fit;
    if (!fit.identifiable()) {
        return fmt::format("no curve ({})", state_words(fit));
    }
    auto const& ends = fit.intervals().hclpf;
    if (ends && ends->lower <= 0) {
        return unlimited_text(fit);
    }
    if (!fit.hclpf()) {
        auto const& five = fit.intervals().five_percent_point;
        return words.low_point && five.lower > 0 ? "unknown: needs beta_U; 5 % point " + five_percent_text(curve)
                                                 : std::string("unknown: needs beta_U");
    }
    auto const stated = !words.beta_u ? std::string()
                        : fit.beta_u > fit.beta_u_drawn
                            ? fmt::format("; by beta_U {:.3g}{}", fit.beta_u, words.beta_u_assumed ? ", assumed" : "")
                            : fmt::format("; by beta_U {:.3g} of what is drawn", fit.beta_u);
    return (ends ? least_text(curve, *ends, *fit.hclpf()) : withstood_text(curve, *fit.hclpf())) + stated;
}

std::string frequency_words(BodyFrequency const& f) {
    auto const& ends = f.ends();
    if (f.lacks_beta_u) {
        return ends.lower > 0 ? fmt::format("> {:.3g} a year", rounded_down(ends.lower)) : "not known: needs beta_U";
    }
    auto const mean = fmt::format("{:.3g} to {:.3g} a year", rounded_down(ends.lower), rounded_up(ends.upper));
    return f.fractiles ? fmt::format("{}; at 95 % confidence <= {:.3g}", mean, rounded_up(f.fractiles->most)) : mean;
}

std::string frequency_in_short(BodyFrequency const& f) {
    return f.fractiles ? fmt::format("<= {:.3g} a year", rounded_up(f.fractiles->most)) : frequency_words(f);
}

std::string probability_text(Stripe const& stripe, double confidence) {
    if (stripe.decided() == 0) {
        return "not known";
    }
    auto const ends = stripe.interval(confidence);
    auto const undecided = stripe.trials - stripe.decided();
    auto const seen = undecided > 0 ? fmt::format("({} undecided)", undecided)
                                    : fmt::format("({} of {})", stripe.overturned, stripe.trials);
    if (stripe.overturned == 0) {
        return fmt::format("< {:.3g} {}", rounded_up(ends.upper), seen);
    }
    if (stripe.overturned == stripe.decided()) {
        return fmt::format("> {:.3g} {}", rounded_down(ends.lower), seen);
    }
    return fmt::format("{:.3g} [{:.3g}, {:.3g}]", stripe.probability(), rounded_down(ends.lower),
                       rounded_up(ends.upper));
}

std::string rare_text(rare::Estimate const& estimate) {
    return estimate.probability ? fmt::format("{:.3g} {}", *estimate.probability, interval_text(estimate.interval_95))
                                : fmt::format("< {:.3g}", rounded_up(estimate.interval_95.upper));
}

}  // namespace overturn::output
