#include "output/detail/criterion_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "output/detail/criterion_words.hpp"
#include "output/detail/interval_text.hpp"
#include "output/detail/ratio_columns.hpp"

namespace overturn::output {
namespace {

std::string share_line(char const* what, Share const& share) {
    if (share.of == 0) {
        return fmt::format("    {}: no such trials\n", what);
    }
    auto const ends = std::isnan(share.interval.lower)
                          ? std::string()
                          : fmt::format(" = {:.3g} {}", share.value(), interval_text(share.interval));
    return fmt::format("    {}: {} of {}{}\n", what, share.count, share.of, ends);
}

// Waves on a grid are no sample: their shares have none.
bool has_intervals(BodyAnalysis const& body) {
    return std::ranges::any_of(body.criterion, [](MeasuredCriterion const& criterion) {
        auto const& s = criterion.study;
        return std::ranges::any_of(std::array{&s.safe_but_overturned, &s.unsafe_but_stood}, [](Share const* share) {
            return share->of > 0 && !std::isnan(share->interval.lower);
        });
    });
}

std::string criterion_text(MeasuredCriterion const& criterion) {
    auto const& s = criterion.study;
    auto text = fmt::format("  criterion: safe where {} < V_Ereq (periods T0 and T1 computed with R in {})\n",
                            in_any_unit(criterion.measure)->title, name_of(criterion.radius_unit));
    text += share_line("false safe", s.safe_but_overturned);
    text += share_line("  of trials that uplifted", s.safe_uplifted_but_overturned);
    text += share_line("  of waves with an uplifted trial", s.waves_safe_uplifted_but_overturned);
    text += share_line("false alarm", s.unsafe_but_stood);
    if (s.at_overturning) {
        auto const line = [](char const* what, RatioQuantiles const& q) {
            return fmt::format("    ratio {}: lowest {:.3g}, 5 % {}, median {}, 95 % {} ({})\n", what, q.lowest,
                               percentile_text(q.p05), percentile_text(q.median), percentile_text(q.p95), q.count);
        };
        text += line("at overturning, trials", *s.at_overturning);
        text += line("at the first overturning, waves", *s.first_overturning);
    }
    return text;
}

std::string response_text(std::vector<ResponseBin> const& bins) {
    if (bins.empty()) {
        return {};
    }
    auto const spread = [](std::optional<RatioQuantiles> const& q) {
        return q ? fmt::format("{} {} {} ({})", percentile_text(q->p05, 'f'), percentile_text(q->median, 'f'),
                               percentile_text(q->p95, 'f'), q->count)
                 : std::string("-");
    };
    auto text = fmt::format(
        "  V_resp / V_Ereq of trials that moved but did not overturn: 5th, 50th, 95th percentile (trials)\n  {:>16} "
        "{:>30} {:>30} {:>11}\n",
        "V_WES / V_Ereq", "without slip", "with slip", "overturned");
    for (auto const& bin : bins) {
        auto const range = std::isfinite(bin.to) ? fmt::format("{:.2f} to {:.2f}", bin.from, bin.to)
                                                 : fmt::format("{:.2f} and above", bin.from);
        text += fmt::format("  {:>16} {:>30} {:>30} {:>11}\n", range, spread(bin.without_slip), spread(bin.with_slip),
                            bin.overturned);
    }
    return text;
}

std::string verdict_text(CriterionWords const& words) {
    std::string text;
    auto const add = [&](char const* heading, std::vector<std::string> const& sentences) {
        for (auto const& sentence : sentences) {
            text += fmt::format("    {} {}\n", heading, sentence);
        }
    };
    add("for:    ", words.supports);
    add("against:", words.against);
    add("open:   ", words.open);
    return text.empty() ? text : "  is V_WES practical and conservative?\n" + text;
}

}  // namespace

std::string criteria_text(std::span<BodyAnalysis const> bodies, double confidence) {
    std::string text;
    if (std::ranges::any_of(bodies, &has_intervals)) {
        text = fmt::format(
            "[lower, upper]: {:g} % interval; it counts all trials of a wave as one, since they may end alike\n",
            100 * confidence);
    }
    for (auto const& body : bodies) {
        text += fmt::format("\n{}\n", body.body);
        for (auto const& criterion : body.criterion) {
            text += criterion_text(criterion);
        }
        text += response_text(body.response);
        text += verdict_text(words_on(body, confidence));
    }
    return text;
}

}  // namespace overturn::output
