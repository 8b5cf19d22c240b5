#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/outward.hpp"
#include "core/wrapped.hpp"
#include "cost/sensitivity.hpp"
#include "stats/proportion.hpp"

namespace overturn::cost {
namespace {

std::string percent(double ratio) { return std::isinf(ratio) ? "inf" : fmt::format("{:+.1f}", 100 * (ratio - 1)); }

// "-8.1 % [-9.0, -7.2]"
std::string median_text(Shift const& shift) {
    if (shift.levels_too_coarse) {
        return "not resolved: coarse levels";
    }
    if (!shift.median_ratio) {
        return "not identified";
    }
    auto const& ends = *shift.median_interval;
    return fmt::format("{} % [{}, {}]{}", percent(*shift.median_ratio), percent(ends.lower), percent(ends.upper),
                       shift.resolved() ? " *" : "");
}

std::string share_text(Counts const& counts) {
    auto const share = counts.share();
    if (!share) {
        return "-";
    }
    auto const ends = clopper_pearson(counts.passed, counts.decided, 0.95);
    return counts.passed == 0                ? fmt::format("< {:.3g}", rounded_up(ends.upper))
           : counts.passed == counts.decided ? fmt::format("> {:.3g}", rounded_down(ends.lower))
                                             : fmt::format("{:.3g}", *share);
}

std::string design_text(Shift const& shift) {
    return fmt::format("{} (+{} -{}, p {:.2g})", share_text(shift.at_design_basis), shift.design_passed,
                       shift.design_no_longer, shift.design_p_value);
}

// The input with its value; below it a line for each changed value.
void append_row(std::string& text, Sensitivity const& study, SensitivityRow const& row) {
    auto const& input = study.inputs[row.input];
    text += wrapped(fmt::format("  {} = {}", fmt::join(input.keys, ", "), input.value), 4);
    for (std::size_t end = 0; end < input.ends.size(); ++end) {
        if (auto const& shift = row.ends.at(end)) {
            text += fmt::format("    {:>12}  {:<28} {:>11}{}\n", input.ends.at(end), median_text(*shift),
                                fmt::format("+{} -{}", shift->passed, shift->no_longer),
                                study.design_basis ? "  " + design_text(*shift) : "");
        } else {
            text += wrapped("refused: " + input.refused.at(end), 18, line_width,
                            fmt::format("    {:>12}  ", input.ends.at(end)));
        }
    }
}

bool moves_nothing(SensitivityRow const& row) {
    return std::ranges::all_of(row.ends, [](auto const& end) {
        return end && !end->levels_too_coarse && end->flips() == 0 && end->median_ratio.value_or(1) == 1;
    });
}

std::string no_effect(Sensitivity const& study) {
    if (study.inputs.empty()) {
        return study.unvaried.empty() ? "No value is marked as assumed: none was changed."
                                      : "No assumed value was changed; the reasons are below.";
    }
    bool const identified = std::ranges::any_of(study.rows, [](SensitivityRow const& row) {
        return std::ranges::any_of(row.ends, [](auto const& end) { return end && end->median_ratio; });
    });
    return identified ? fmt::format("No assumed value changes a median significantly ({} waves).", study.waves)
                      : fmt::format("The effect of assumed values on medians is not known: {} waves identify none.",
                                    study.waves);
}

// The significant change of a median that is the largest as a factor.
std::string largest_effect(Sensitivity const& study) {
    std::string text;
    double most = 0;
    for (auto const& row : study.rows) {
        auto const& input = study.inputs[row.input];
        for (std::size_t end = 0; end < input.ends.size(); ++end) {
            auto const& shift = row.ends.at(end);
            if (!shift || !shift->median_ratio || !shift->resolved()
                || std::abs(std::log(*shift->median_ratio)) <= most) {
                continue;
            }
            most = std::abs(std::log(*shift->median_ratio));
            text = fmt::format("Largest effect: {} = {} instead of {} changes the median of {} ({}) by {} %",
                               input.keys.front(), input.ends.at(end), input.value, study.bodies[row.body],
                               study.limits[row.limit], percent(*shift->median_ratio));
            auto const unmoved = std::ranges::find_if(
                study.unmoved, [&](Unmoved const& one) { return one.body == row.body && one.limit == row.limit; });
            if (study.design_basis && unmoved != study.unmoved.end()) {
                auto const changed = share_text(shift->at_design_basis);
                auto const before = share_text(unmoved->at_design_basis);
                text += changed == before ? fmt::format("; P at the design basis stays {}", before)
                                          : fmt::format("; P at the design basis is {} instead of {}", changed, before);
            }
        }
    }
    bool const coarse = std::ranges::any_of(study.rows, [](SensitivityRow const& row) {
        return std::ranges::any_of(row.ends, [](auto const& end) { return end && end->levels_too_coarse; });
    });
    text = text.empty() ? no_effect(study) : text + ".";
    return text
           + (coarse ? " Not resolved where levels are coarse: at most one has both outcomes. State more levels." : "");
}

std::string at_level(Sensitivity const& study, double value) {
    return fmt::format("{:.4g} {}", value / study.shown_si, study.shown_units == "1" ? "" : study.shown_units);
}

}  // namespace

std::string sensitivity_text(Sensitivity const& study) {
    auto text = study.title + "\n" + wrapped(largest_effect(study)) + "\n";
    text +=
        wrapped(fmt::format("Each assumed value, and each friction near tan(alpha), is changed alone: to the ends of "
                            "its range, or by {:.0f} %. "
                            "The waves stay the same: {} of {}.",
                            100 * usual_share, study.waves, study.campaign_waves));
    text += wrapped(fmt::format(
        "Below each input: its changed value, change of the median over {} with its {:g} % interval by bootstrap over "
        "waves (*: significant; not identified: too few waves exceed the limit), verdicts newly passed and no longer "
        "passed{}.",
        study.measure, 100 * study.confidence,
        study.design_basis ? ", P at the design basis (waves that change it, exact p value)" : ""));
    for (auto const& unmoved : study.unmoved) {
        text += fmt::format("\n{}, {}: median {}", study.bodies[unmoved.body], study.limits[unmoved.limit],
                            unmoved.median              ? at_level(study, *unmoved.median)
                            : unmoved.levels_too_coarse ? std::string("not resolved: coarse levels")
                                                        : std::string("-"));
        if (study.design_basis) {
            text +=
                fmt::format(", P {} at {}", share_text(unmoved.at_design_basis), at_level(study, *study.design_basis));
        }
        text += "\n";
        std::string nothing;
        for (auto const& row : study.rows) {
            if (row.body != unmoved.body || row.limit != unmoved.limit) {
                continue;
            }
            if (moves_nothing(row)) {
                nothing +=
                    fmt::format("{}{}", nothing.empty() ? "" : ", ", fmt::join(study.inputs[row.input].keys, ", "));
            } else {
                append_row(text, study, row);
            }
        }
        text += nothing.empty() ? "" : wrapped("  No verdict changes with: " + nothing + ".", 4);
    }
    for (auto const& input : study.unvaried) {
        text += wrapped(fmt::format("not changed: {} = {} ({})", input.key, input.value, input.why), 4);
    }
    if (study.inputs.empty() && study.unvaried.empty()) {
        text += "Mark assumed values with basis = \"assumed\".\n";
    }
    return text;
}

}  // namespace overturn::cost
