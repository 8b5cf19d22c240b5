#include "output/page_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/outward.hpp"
#include "core/texts_of.hpp"
#include "output/detail/answer_cells.hpp"
#include "output/detail/answer_parts.hpp"
#include "output/detail/fit_names.hpp"
#include "output/detail/fit_words.hpp"
#include "output/detail/quote_text.hpp"
#include "output/stripe_text.hpp"

namespace overturn::output {
namespace {

constexpr int headline_digits = 3;

std::string median_end(double value) { return std::isfinite(value) ? fmt::format("{:g}", value) : "open"; }

std::string basis_text(Answered const& of, std::size_t body, std::size_t limit) {
    auto const* const basis = of.spec.levels.design_basis();
    if (basis == nullptr) {
        return {};
    }
    auto const& stripe = of.statistics.bodies()[body].stripes_of(limit)[basis - of.spec.levels.levels.data()];
    auto const* const did = limit == 0 ? "overturned" : "exceeded the limit";
    if (!no_probability_text(of).empty()) {
        return fmt::format("at the design basis ({}) {} of {} {}", of.spec.levels.text(basis->value), stripe.overturned,
                           stripe.trials, did);
    }
    auto const ends = stripe.interval(of.confidence);
    return fmt::format("at the design basis ({}) {} of {} trials {}, P between {:.2g} and {:.2g}",
                       of.spec.levels.text(basis->value), stripe.overturned, stripe.trials, did,
                       rounded_down(ends.lower, 2), rounded_up(ends.upper, 2));
}

std::string curve_words(MeasuredFragility const& curve, double confidence) {
    auto const& fit = curve.fit;
    if (!fit.identifiable()) {
        auto const why = warnings_of(fit, curve.shown_in, confidence);
        return why.empty() ? "no curve: " + state_words(fit) : why.front();
    }
    auto const& ends = fit.intervals().median;
    auto text = fmt::format("half {} at {} ({} to {}), beta {:.2g}", pass_text(fit),
                            curve.shown_in.text(std::exp(fit.line->log_median())),
                            median_end(rounded_down(curve.shown_in.of(ends.lower), headline_digits)),
                            median_end(rounded_up(curve.shown_in.of(ends.upper), headline_digits)), fit.line->beta());
    text += ", 5 % point " + five_percent_text(curve);
    if (fit.beta_u_known) {
        text += ", HCLPF " + hclpf_text(curve, {.low_point = false, .beta_u = false});
    }
    auto const flags = names_of(fit.flags, fit.passing);
    return text + (flags.empty() ? std::string() : fmt::format(" (flagged: {})", fmt::join(flags, ", ")));
}

std::string frequency_line(Answered const& of, std::string const& body, std::string const& limit) {
    auto const* const f = frequency_at(of, body, limit);
    if (f == nullptr) {
        return {};
    }
    auto const& ends = f->ends();
    auto const low = rounded_down(ends.lower, headline_digits);
    auto const high = rounded_up(ends.upper, headline_digits);
    if (f->lacks_beta_u) {
        return low == 0
                   ? "not known: it needs beta_U of the body"
                   : fmt::format("more than {:.{}g} times a year (how much more needs beta_U)", low, headline_digits);
    }
    if (!f->mean) {
        return fmt::format("at most {:.{}g} times a year ({:g} %: {:.{}g} to {:.{}g})", high, headline_digits,
                           100 * of.confidence, low, headline_digits, high, headline_digits);
    }
    auto const mean = rounded_up(f->mean->annual + f->mean->beyond_least, headline_digits);
    auto const confident = f->fractiles ? fmt::format("; with beta_U at 95 % confidence at most {:.{}g}",
                                                      rounded_up(f->fractiles->most, headline_digits), headline_digits)
                                        : std::string();
    return fmt::format("{:.{}g} times a year ({:g} %: {:.{}g} to {:.{}g} by sampling{})", mean, headline_digits,
                       100 * of.confidence, low, headline_digits, high, headline_digits, confident);
}

// From which level on a limit state is passed, and at how many frequencies.
std::string grid_passed(GridMap const& map, std::size_t limit) {
    auto const what = limit == 0 ? std::string("overturns") : "exceeds " + map.limits[limit];
    GridLine const* first = nullptr;
    std::size_t passed = 0;
    for (auto const& line : map.lines) {
        if (line.least[limit]) {
            ++passed;
            first = first == nullptr || *line.least[limit] < *first->least[limit] ? &line : first;
        }
    }
    if (first == nullptr) {
        return fmt::format("{} at no frequency up to {}", what, map.shown_in.text(map.levels.back()));
    }
    return fmt::format("{} from {} on at {:.3g} Hz, at {} of {} frequencies in all", what,
                       map.shown_in.text(map.value(first->least[limit])), 1 / first->period_s, passed,
                       map.lines.size());
}

std::string grid_headline(BodyAnalysis const& body) {
    std::vector<std::string> parts;
    for (std::size_t limit = 0; limit < body.grid->limits.size(); ++limit) {
        parts.push_back(grid_passed(*body.grid, limit));
    }
    parts.push_back(grid_text(body.over_levels().fit.waves));
    return fmt::format("{}: {}.", body.body, fmt::join(parts, "; "));
}

std::string headline(Answered const& of, std::size_t b, std::size_t limit) {
    auto const& body = of.analysis[b];
    auto const& stated = of.spec.limits[limit];
    bool const too_few = !no_probability_text(of).empty();
    std::vector<std::string> parts;
    if (too_few) {
        parts.push_back(no_probability_text(of));
    }
    for (auto const& part :
         {basis_text(of, b, limit), too_few ? "" : curve_words(body.curves_of(limit).front(), of.confidence),
          too_few ? "" : frequency_line(of, body.body, stated.name)}) {
        if (!part.empty()) {
            parts.push_back(part);
        }
    }
    auto const who = limit == 0 ? body.body
                                : fmt::format("{}, {} ({})", body.body, full_name(stated, of.spec.limits),
                                              definition_of(stated, of.spec.limits));
    return fmt::format("{}: {}.", who, fmt::join(parts, "; "));
}

// Calls `take` with the body, limit state and measure of each curve, and the curve.
template <class Take> void each_curve(Answered const& of, Take take) {
    for (auto const& body : of.analysis) {
        for (std::size_t limit = 0; limit < of.spec.limits.size(); ++limit) {
            for (auto const& curve : body.curves_of(limit)) {
                take(Json{{"body", body.body}, {"limit", curve.limit}, {"measure", curve.name}}, curve);
            }
        }
    }
}

}  // namespace

std::vector<std::string> headlines(Answered const& of) {
    std::vector<std::string> lines;
    for (std::size_t b = 0; b < of.analysis.size(); ++b) {
        if (of.analysis[b].grid) {
            lines.push_back(grid_headline(of.analysis[b]));
            continue;
        }
        for (std::size_t limit = 0; limit < of.spec.limits.size(); ++limit) {
            lines.push_back(headline(of, b, limit));
        }
    }
    return lines;
}

Json quote_remarks(Answered const& of) {
    auto list = Json::array();
    each_curve(of, [&](Json const& place, MeasuredFragility const& curve) {
        for (auto const& quoted : curve.fit.quotes) {
            list.push_back(place);
            list.back()["text"] = quote_remark(curve, quoted);
        }
    });
    return list;
}

Json low_points(Answered const& of) {
    auto list = Json::array();
    each_curve(of, [&](Json const& place, MeasuredFragility const& curve) {
        list.push_back(place);
        list.back()["five_percent_point"] = five_percent_text(curve);
        list.back()["hclpf"] = hclpf_text(curve, {.low_point = false, .beta_u = false});
    });
    return list;
}

std::vector<std::string> cut_short_lines(Answered const& of) {
    std::vector<std::string> lines;
    for (auto const& body : of.statistics.bodies()) {
        if (auto const text = cut_short_text(body); !text.empty()) {
            lines.push_back(fmt::format("{}: {}.", body.body, text));
        }
    }
    return lines;
}

std::string cost_text(double wall_s, std::int64_t ranks, std::size_t runs, double trials_per_s,
                      std::string const& place) {
    constexpr double least_s = 0.01;  // of a run that found all trials computed already
    auto const on = fmt::format("{}{}", count_text(ranks, "rank"), runs > 1 ? fmt::format(" in {} runs", runs) : "");
    return wall_s < least_s ? fmt::format("Took less than {:g} s on {} (times are in {}).", least_s, on, place)
                            : fmt::format("Took {:.3g} s on {}, {:.3g} trials a second (times are in {}).", wall_s, on,
                                          trials_per_s, place);
}

std::string false_safe_histories_text(std::size_t shown, std::size_t all) {
    return fmt::format(
        "{} of {} tests that fell though their trial stood, of each specimen the highest peak rotation "
        "first.",
        shown, all);
}

std::string wave_title(std::int64_t number, bool telling) {
    return fmt::format("Wave {}{}", number, telling ? ": overturned a body at the lowest level" : "");
}

std::string histories_text(std::size_t shown, std::size_t bodies,
                           std::vector<std::string> const& at_rest_at_design_basis) {
    std::vector<std::string> sentences;
    if (!at_rest_at_design_basis.empty()) {
        sentences.push_back(fmt::format("No history at the design basis: {} did not move there under any wave.",
                                        names_text(at_rest_at_design_basis)));
    }
    if (shown < bodies) {
        sentences.push_back(fmt::format(
            "Histories are of {} of {} bodies. overturn replay --plot draws that of any trial.", shown, bodies));
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

std::string shown_waves_text(std::int64_t shown, std::int64_t all) {
    return fmt::format("Figures of trials and waves show the first {} of {} waves. Counts in tables are of all.", shown,
                       all);
}

std::string ran_text(std::int64_t ran, std::int64_t planned) {
    return ran == planned ? fmt::format("{}", ran)
                          : fmt::format("{} of {} planned: it ended early, precise enough", ran, planned);
}

std::string changed_file_text() {
    return "The results file is NOT as it was written: edited, damaged or never sealed. It was read as it is.";
}

}  // namespace overturn::output
