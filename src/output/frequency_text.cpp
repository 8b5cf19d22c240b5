#include "output/frequency_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "core/text_width.hpp"
#include "core/wrapped.hpp"
#include "output/detail/interval_text.hpp"

namespace overturn::output {
namespace {

constexpr double much = 0.05;  // a part of an end, or of the mean, that is worth a line

double mean_of(BodyFrequency const& f) { return f.mean->annual + f.mean->beyond_least; }

// What of the upper end rests on no trial or no hazard, and how to learn more.
void add_parts(std::vector<std::string>& notes, BodyFrequency const& f, HazardCurve const& hazard) {
    auto const& b = f.bounds;
    if (b.above_most > much * f.interval.upper) {
        bool const of_levels = f.highest < hazard.last();
        notes.push_back(fmt::format(
            "{:.3g} a year of the upper end is every motion above {}, {}, counted as failing. {}", b.above_most,
            hazard_text(hazard, b.top), of_levels ? "the highest level" : "where the hazard curve ends",
            of_levels ? "State higher levels" : "State the hazard curve further"));
    }
    if (b.below_most > much * f.interval.upper) {
        notes.push_back(
            fmt::format("{:.3g} a year of the upper end is motions below {}, the lowest level, counted as failing as "
                        "often as there. State lower levels",
                        b.below_most, hazard_text(hazard, f.lowest)));
    }
    if (b.weaker_most > much * f.interval.upper) {
        notes.push_back(fmt::format(
            "the upper end counts motions below {}, where the hazard curve begins, by its steepest slope "
            "there, no more than one a year: {:.3g} a year by the fitted curve. State the hazard curve from lower on",
            hazard_text(hazard, hazard.first()), b.weaker_most));
    }
}

void add_mean(std::vector<std::string>& notes, BodyFrequency const& f, HazardCurve const& hazard) {
    if (f.extrapolated() > much * mean_of(f)) {
        notes.push_back(fmt::format("{:.0f} % of the curve's {:.3g} a year lies outside {}: extrapolated",
                                    100 * f.extrapolated() / mean_of(f), mean_of(f),
                                    f.stated ? "the hazard curve" : "the levels or the hazard curve"));
    }
    if (f.continued > (1 + much) * mean_of(f)) {
        notes.push_back(
            fmt::format("with the hazard curve continued at its slopes at both ends, up to one weaker motion a year, "
                        "the curve gives {:.3g} a "
                        "year (an estimate)",
                        f.continued));
    }
    if (f.wide) {
        notes.push_back(fmt::format(
            "{:.0f} % of the curve's {:.3g} a year rests on the straight line of the hazard curve from {} to "
            "{}, {:.1f} decades. Twice the exceedance halfway ({}) makes it {:.3g} a year ({:+.0f} %). "
            "State points between",
            100 * f.wide->share, mean_of(f), hazard_text(hazard, f.wide->from), hazard_text(hazard, f.wide->to),
            f.wide->decades, hazard_text(hazard, f.wide->halfway), f.wide->if_doubled,
            100 * (f.wide->if_doubled / mean_of(f) - 1)));
    }
}

void add_trust(std::vector<std::string>& notes, BodyFrequency const& f) {
    if (f.few_waves > 0) {
        notes.push_back(fmt::format(
            "the interval comes from {} independent waves, or groups of them, and is widened for so few", f.few_waves));
    }
    if (f.poor) {
        notes.emplace_back(
            "the curve does not fit the data: use the interval, which includes the bounds from the stripes");
    }
    if (f.outside_seen) {
        notes.emplace_back("the curve's frequency is outside the bounds from the stripes: use these bounds");
    }
}

// Of a body without a curve the stripes are the answer.
void add_seen(std::vector<std::string>& notes, BodyFrequency const& f, HazardCurve const& hazard) {
    constexpr double nearly_all = 0.75;
    if (f.lacks_beta_u) {
        return;
    }
    if (!f.mean && f.seen_below_curve > much * f.seen.upper) {
        notes.push_back(fmt::format(
            "{:.2g} a year of the upper end is motions below {}, where the hazard curve begins, by its "
            "steepest slope there{}. State the hazard curve from lower on",
            f.seen_below_curve, hazard_text(hazard, hazard.first()), f.nothing_below > 0 ? "" : " up to one a year"));
    } else if (!f.mean && f.nothing_below < hazard.first()) {
        notes.push_back(fmt::format("motions below {}, where the hazard curve begins, are not counted",
                                    hazard_text(hazard, hazard.first())));
    }
    if (f.seen_below_levels > nearly_all * f.seen.upper) {
        notes.push_back(
            fmt::format("{:.2g} of the {:.2g} a year that trials alone allow is by motions weaker than all "
                        "levels, counted as at the lowest. State lower levels",
                        f.seen_below_levels, f.seen.upper));
    }
}

constexpr std::size_t name_width = 24;

// A longer name has a line of its own.
std::string row_of(BodyFrequency const& f) {
    auto name = frequency_name(f);
    std::string text;
    if (text_width(name) > name_width) {
        text = name + '\n';
        name.clear();
    }
    auto const text_of = [&](Interval const& ends) {
        return f.lacks_beta_u ? fmt::format("> {:.3g}", rounded_down(ends.lower)) : interval_text(ends);
    };
    auto const seen = f.stated ? std::string("no trials") : text_of(f.seen);
    text += fmt::format("{:<{}} {:>22} {:>11} {:>12} {:>22}\n", name, name_width, text_of(f.ends()),
                        f.mean ? fmt::format("{:.3g}", mean_of(f)) : "-",
                        f.mean ? fmt::format("{:.2g}", f.extrapolated()) : "no curve", seen);
    return text
           + (f.fractiles ? fmt::format(
                  "  by the curves at 5, 50, 95 % confidence: {:.3g}, {:.3g}, {:.3g} a year; at most {:.3g}\n",
                  rounded_down(f.fractiles->low), f.fractiles->median, rounded_up(f.fractiles->high),
                  rounded_up(f.fractiles->most))
                          : std::string());
}

}  // namespace

std::string frequency_name(BodyFrequency const& f) {
    return f.limit == overturning_limit || f.limit.empty()
               ? f.body
               : fmt::format("{}, {}", f.body, f.full_name.empty() ? f.limit : f.full_name);
}

std::vector<std::string> frequency_notes(BodyFrequency const& f, HazardCurve const& hazard) {
    std::vector<std::string> notes;
    if (std::isnan(f.seen.upper)) {  // of waves that are no sample
        return notes;
    }
    if (f.lacks_beta_u) {
        notes.emplace_back(
            "no upper end, because beta_U is not known (--beta-u, or the campaign's key statistics.beta_u): uncertain "
            "properties of the body make the limit state more frequent");
    }
    if (f.mean) {
        if (!f.lacks_beta_u) {
            add_parts(notes, f, hazard);
        }
        add_mean(notes, f, hazard);
        add_trust(notes, f);
    }
    add_seen(notes, f, hazard);
    return notes;
}

std::string range_text(HazardCurve const& hazard) {
    return fmt::format("{} points from {} ({:.3g} 1/a) to {} ({:.3g} 1/a)", hazard.points().size(),
                       hazard_text(hazard, hazard.first()), hazard.points().front().annual_exceedance,
                       hazard_text(hazard, hazard.last()), hazard.points().back().annual_exceedance);
}

std::string frequency_text(std::span<BodyFrequency const> frequencies, HazardCurve const& hazard, double confidence) {
    bool const stated = std::ranges::all_of(frequencies, &BodyFrequency::stated);
    auto text = "\n" + wrapped("annual frequency [1/a], by a hazard curve of " + range_text(hazard), 2);
    for (auto const& remark : hazard.remarks()) {
        text += wrapped("note: hazard curve: " + remark, 4, line_width, "  ");
    }
    text += fmt::format("{:<{}} {:>22} {:>11} {:>12} {:>22}\n", "body, limit state", name_width,
                        stated ? std::string("bounds") : fmt::format("{:g} % interval", 100 * confidence), "curve mean",
                        "beyond data", "by trials alone");
    for (auto const& f : frequencies) {
        text += row_of(f);
        for (auto const& note : frequency_notes(f, hazard)) {
            text += wrapped("note: " + note, 4, line_width, "  ");
        }
    }
    return text;
}

}  // namespace overturn::output
