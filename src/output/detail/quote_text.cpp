#include "output/detail/quote_text.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/outward.hpp"
#include "output/detail/fit_words.hpp"
#include "output/detail/interval_text.hpp"

namespace overturn::output {
namespace {

// Never a number that no sample of that size could hold.
std::string curve_text(double least, double p) {
    return p < least ? fmt::format("value below {:.2g}", least) : fmt::format("{:.2g}", p);
}

std::string where_text(MeasuredFragility const& m, SeenBound const& seen) {
    return seen.from == seen.to ? m.shown_in.text(seen.from)
                                : fmt::format("{:.4g} to {}", m.shown_in.of(seen.from), m.shown_in.text(seen.to));
}

std::string below_least_text(QuotedProbability const& q) {
    return fmt::format("The fitted value is below 1/(10 n) = {:.2g} and is not reported", q.least);
}

// "0 of 40 at 600 gal"
std::string bound_from_text(MeasuredFragility const& m, QuotedProbability const& q) {
    return fmt::format("{} at {}{}", counts_text(*q.bound), where_text(m, *q.bound),
                       q.bound->units > q.trials ? ", if P does not decrease" : "");
}

// The exact bound that is left where the curve speaks of less than the trials hold.
std::string bound_text(MeasuredFragility const& m, QuotedProbability const& q) {
    if (!q.bound && has(m.fit.flags, FragilityFlag::non_monotone)) {
        return "no bound (P decreases with the level significantly, so that other levels bound nothing)";
    }
    if (!q.bound) {
        return fmt::format("no bound (no trial there or above). {}", below_least_text(q));
    }
    return fmt::format("< {:.3g} ({}). {}", rounded_up(q.bound->probability.upper), bound_from_text(m, q),
                       below_least_text(q));
}

// Behind bounds by what was seen, there or elsewhere.
std::string exact_text(QuotedProbability const& q, double group_size) {
    if (q.bounds.lower == 0 && q.bounds.upper == 1) {
        return {};
    }
    auto const how = group_size > 1 ? fmt::format(" counting {:g} trials as one", group_size) : std::string(" exact");
    return how + (q.pooled || q.source == QuotedProbability::Source::neighbours ? " if P does not decrease" : "");
}

std::string neighbours_text(MeasuredFragility const& m, Neighbours const& n) {
    std::vector<std::string> seen;
    for (auto const* side : {&n.below, &n.above}) {
        if (side->units > 0) {
            seen.push_back(
                fmt::format("{} {}at {}", counts_text(*side), seen.empty() ? "seen " : "", where_text(m, *side)));
        }
    }
    return fmt::format(", {}", fmt::join(seen, " and "));
}

// What was seen right there, and next above where nothing was either.
std::string stripe_text(MeasuredFragility const& m, QuotedProbability const& q) {
    auto const more = q.pooled ? fmt::format(", {:g} of {:g} up to {}", q.pooled->overturned, q.pooled->units,
                                             m.shown_in.text(q.pooled->to))
                               : std::string();
    return fmt::format(", {:g} of {:g} trials there{}", q.overturned, q.trials, more);
}

// What was seen, and what must be known beside it: ", 3 of 40 trials there, in the tail".
std::string seen_text(MeasuredFragility const& m, QuotedProbability const& q) {
    bool const differs =
        q.curve && (!q.probability || fmt::format("{:.2g}", *q.probability) != curve_text(q.least, *q.curve));
    auto const rejected =
        differs ? fmt::format(" (the fitted {} is not reported)", curve_text(q.least, *q.curve)) : std::string();
    auto const seen = q.trials > 0                                        ? stripe_text(m, q)
                      : q.source == QuotedProbability::Source::neighbours ? neighbours_text(m, *q.neighbours)
                                                                          : std::string();
    return fmt::format("{}{}{}{}", seen, rejected, q.outside_data ? ", outside the data" : "",
                       q.in_tail ? ", in the tail" : "");
}

}  // namespace

std::string quote_line(MeasuredFragility const& m, QuotedProbability const& q) {
    using Source = QuotedProbability::Source;
    auto const at = m.quote_base == "v_ereq" ? std::string("V_WES = V_Ereq")
                                             : fmt::format("{:.3g} x design basis, {} {}", q.quote.multiple, m.name,
                                                           m.shown_in.text(q.quote.intensity));
    if (q.curve && !q.probability && q.source != Source::neighbours) {
        return fmt::format("  P at {}: {}\n", at, bound_text(m, q));
    }
    auto const p = q.probability ? fmt::format("{:.3g}", *q.probability)
                   : q.curve     ? std::string("between")
                                 : std::string("no curve,");
    auto const bounds =
        q.source == Source::none
            ? std::string("no bound")
            : fmt::format("{}{}", interval_text(q.bounds),
                          q.source != Source::curve                   ? exact_text(q, m.fit.group_size)
                          : has(m.fit.flags, FragilityFlag::poor_fit) ? " by a curve that does not describe the data"
                                                                      : std::string());
    return fmt::format("  P at {}: {} {}{}\n", at, p, bounds, seen_text(m, q));
}

std::string quote_remark(MeasuredFragility const& m, QuotedProbability const& q) {
    bool const only_bound = q.curve && !q.probability && q.source != QuotedProbability::Source::neighbours;
    if (only_bound) {
        return q.bound ? fmt::format("{}. {}", bound_from_text(m, q), below_least_text(q)) : bound_text(m, q);
    }
    auto text = seen_text(m, q);
    text.erase(0, text.find_first_not_of(", "));
    return text;
}

std::string other_measures_text(std::string const& levels) {
    return fmt::format(
        "curves over measures other than {} depend on the scaling levels and the number of waves at each", levels);
}

}  // namespace overturn::output
