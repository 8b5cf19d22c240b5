#include "output/waves_text.hpp"

#include <fmt/format.h>

#include "stats/proportion.hpp"

namespace overturn::output {

std::string waves_text(WaveCounts const& counts, Acceptance const& acceptance, double confidence) {
    auto const& [waves, failed, not_accepted, refused, missed] = counts;
    if (!acceptance.asked() && failed == 0 && missed == 0) {
        return "";
    }
    auto text = fmt::format("{} waves", waves);
    text += missed > 0 ? fmt::format(", {} outside match_tolerance, but used", missed) : "";
    text += failed > 0 ? fmt::format(", {} could not be made (their trials are failed rows)", failed) : "";
    if (acceptance.uses_refused) {
        return text + fmt::format(", {} of them outside {}, but used", not_accepted, acceptance.rule);
    }
    if (not_accepted > 0) {  // up to format 4
        return text
               + fmt::format(", {} not accepted by {} (their trials are failed rows)", not_accepted, acceptance.rule);
    }
    if (acceptance.asked()) {
        auto const drawn = waves + refused;
        auto const share = clopper_pearson(refused, drawn, confidence);
        text +=
            fmt::format(" that meet {}; {} of {} drawn were refused: {:.3g} % [{:.3g} %, {:.3g} %]", acceptance.rule,
                        refused, drawn, 100.0 * static_cast<double>(refused) / static_cast<double>(drawn),
                        100 * share.lower, 100 * share.upper);
        if (waves > 0 && waves * acceptance.most_drawn < drawn) {
            text += "; fewer waves are used than waves.count, because no more may be drawn";
        }
    }
    return text;
}

std::string missed_clauses_text(MissedClauses const& missed) {
    std::string text;
    for (auto const& row : missed.rows()) {
        text += fmt::format("  {}{}: missed by {} waves", row.clause,
                            row.component.empty() ? std::string() : ", " + row.component, row.waves);
        text += row.worst ? fmt::format(", worst {:.4g}", *row.worst) : "";
        text +=
            row.from_period_s ? fmt::format(" (at {:.3g} s to {:.3g} s)", *row.from_period_s, *row.to_period_s) : "";
        text += '\n';
    }
    return text;
}

std::string sigma_text(AchievedSigma const& sigma) {
    auto line = fmt::format("achieved sd of ln (stated of Sa), over {} {}:", sigma.independent,
                            sigma.of_events ? "events" : "targets");
    for (auto const& m : sigma.measures) {
        bool const pga = &m == &sigma.measures.front();
        line += fmt::format("{} {} {:.3f} +- {:.3f} ({}{})", pga ? "" : ",", m.label, m.achieved, m.error,
                            m.stated ? fmt::format("{:.3g}", *m.stated) : "not matched there",
                            pga ? fmt::format(" at {:.2g} s, the shortest matched", m.period_s) : "");
    }
    return line + fmt::format("; {} of {} waves missed match_tolerance", sigma.missed, sigma.waves);
}

}  // namespace overturn::output
