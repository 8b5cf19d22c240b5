#include "output/curve_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/outward.hpp"
#include "output/detail/columns_text.hpp"
#include "output/detail/fit_names.hpp"
#include "output/detail/fit_words.hpp"
#include "output/detail/grid_map_text.hpp"
#include "output/detail/interval_text.hpp"
#include "output/detail/quote_text.hpp"
#include "output/waves_text.hpp"
#include "results/analysis.hpp"

namespace overturn::output {
namespace {

constexpr int digits = 4;

std::string end_text(double value) { return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "open"; }

std::string ends_text(Interval const& interval, IntensityUnit const& unit = {}) {
    return fmt::format("[{}, {}]", end_text(rounded_down(unit.of(interval.lower), digits)),
                       end_text(rounded_up(unit.of(interval.upper), digits)));
}

std::string measure_text(MeasuredFragility const& m) {
    return m.shown_in.symbol == "1" ? m.label : fmt::format("{} {}", m.label, m.shown_in.symbol);
}

// The lower end stands for a point on the curve's lower tail: whoever copies it copies no interval.
std::string least_text(MeasuredFragility const& m, Interval const& point) {
    return point.lower > 0 ? fmt::format("{:.{}g}", rounded_down(m.shown_in.of(point.lower), digits), digits)
                           : std::string("-");
}

std::array<std::string, 8> fit_cells(MeasuredFragility const& m) {
    auto const rank = std::isnan(m.rank_area) ? std::string("-") : fmt::format("{:.3f}", m.rank_area);
    if (!m.fit.identifiable()) {
        return {measure_text(m), "-", "no curve", "-", "-", "-", "-", rank};
    }
    auto const& line = *m.fit.line;
    auto const& ends = m.fit.intervals();
    return {measure_text(m),
            fmt::format("{:.4g}", m.shown_in.of(std::exp(line.log_median()))),
            ends_text(ends.median, m.shown_in),
            fmt::format("{:.3f}", line.beta()),
            ends_text(ends.beta),
            least_text(m, ends.five_percent_point),
            m.fit.hclpf() ? least_text(m, ends.hclpf.value_or(Interval{0, 0})) : "-",
            rank};
}

// "flags of pga, pgv: few-waves no-beta-u", and why there is no curve: a line for all measures that it is true of.
std::string flags_text(std::vector<MeasuredFragility> const& fits) {
    std::vector<std::pair<std::string, std::vector<std::string>>> of;  // flags, measures
    for (auto const& m : fits) {
        auto const flags = m.fit.identifiable()
                               ? fmt::format("{}", fmt::join(names_of(m.fit.flags, m.fit.passing), " "))
                               : name_of(m.fit.state, m.fit.passing);
        auto const known = std::ranges::find(of, flags, &decltype(of)::value_type::first);
        if (known != of.end()) {
            known->second.push_back(m.label);
        } else if (!flags.empty()) {
            of.push_back({flags, {m.label}});
        }
    }
    std::string text;
    for (auto const& [flags, measures] : of) {
        text += fmt::format("  flags of {}: {}\n", fmt::join(measures, ", "), flags);
    }
    return text;
}

// Are there several measures, and did all trials end the same way, whatever one draws them over?
bool end_the_same_way(std::vector<MeasuredFragility> const& fits) {
    auto const state = fits.front().fit.state;
    bool const same = state == FragilityState::none_overturned || state == FragilityState::all_overturned;
    return same && fits.size() > 1 && std::ranges::all_of(fits, [&](auto const& m) { return m.fit.state == state; });
}

// What the draws of the body's quantities add, where they were drawn.
std::string split_line(MeasuredFragility const& m) {
    if (!m.split || !m.fit.identifiable()) {
        return {};
    }
    auto const& s = *m.split;
    std::string shifts;
    for (std::size_t k = 0; k < s.per_score.size(); ++k) {
        shifts += fmt::format("{}{} {:+.3f} +- {:.3f}", k == 0 ? "" : ", ", m.drawn.at(k), s.per_score[k],
                              s.per_score_error[k]);
    }
    return fmt::format(
        "  beta {:.3f} is beta_R {:.3f} (waves) with beta_U {:.3f} (the body){}; ln median per deviation of: {}\n",
        m.fit.line->beta(), m.fit.beta_r(), m.fit.beta_u_drawn,
        m.fit.beta_u > m.fit.beta_u_drawn ? fmt::format(", {:.3f} with what is stated", m.fit.beta_u) : "", shifts);
}

// Curves of all limit states.
std::string body_text(BodyAnalysis const& body, double confidence) {
    auto const& levels = body.over_levels().fit;
    auto const of = levels.group_size > 1 ? fmt::format("groups of {:g} waves with the same draw", levels.group_size)
                                          : std::string("waves");
    auto text = fmt::format(
        "\n{}: fragility curves from {} {}; confidence intervals by {}\n", body.body, levels.waves, of,
        levels.method == FragilityFit::Method::bootstrap_by_waves ? "bootstrap over waves"
        : levels.method == FragilityFit::Method::widest           ? "the widest of bootstrap over waves and likelihood"
                                                                  : "profile likelihood");
    text += fmt::format("  variability of waves: {}\n", body.variability);
    text += body.sigma ? fmt::format("  {}\n", sigma_text(*body.sigma)) : "";
    text += fragility_table(body.fragility, confidence);
    for (auto const& limit : body.limits) {
        text += fmt::format("  limit state {}: {}\n", limit.name, limit.definition);
        text += fragility_table(limit.fragility, confidence);
    }
    return text;
}

}  // namespace

std::string fragility_table(std::vector<MeasuredFragility> const& fits, double confidence) {
    auto const& first = fits.front().fit;
    std::string text;
    if (end_the_same_way(fits)) {
        text += fmt::format("  no curve over any measure: {}\n", state_words(first));
    } else {
        auto const ends = fmt::format("{:g} % interval", 100 * confidence);
        TextGroup columns{{"fragility"},           {"median"},          {ends},         {"beta"}, {ends},
                          {"5 % point\nat least"}, {"HCLPF\nat least"}, {"rank\n(AUC)"}};
        columns.front().side = TextColumn::Side::left;
        for (auto const& m : fits) {
            append_row(columns, fit_cells(m));
        }
        text += columns_text({columns}, 2) + flags_text(fits);
    }
    if (std::any_of(fits.begin() + 1, fits.end(), [](auto const& m) { return m.fit.identifiable(); })) {
        text += fmt::format("  note: {}\n", other_measures_text(fits.front().label));
    }
    text += split_line(fits.front());
    for (auto const& m : fits) {
        for (auto const& quoted : m.fit.quotes) {
            text += quote_line(m, quoted);
        }
    }
    // What is stated of the first, over the levels, mostly holds for the others; their flags stand in their lines.
    for (auto const& warning : warnings_of(fits.front().fit, fits.front().shown_in, confidence)) {
        text += fmt::format("  note: {}\n", warning);
    }
    return text;
}

std::string rank_text() {
    return "rank (AUC): chance that a trial that overturned, or exceeded the limit, has more of the measure than one "
           "that\ndid not; 0.5: no order, 1: a perfect one\n";
}

std::string curves_text(std::span<BodyAnalysis const> bodies, double confidence) {
    std::string text;
    bool const ranked = std::ranges::any_of(
        bodies, [](BodyAnalysis const& body) { return !body.grid && !end_the_same_way(body.fragility); });
    for (auto const& body : bodies) {
        text += body.grid ? fmt::format("\n{}: {}\n{}", body.body, grid_text(body.over_levels().fit.waves),
                                        grid_map_text(*body.grid))
                          : body_text(body, confidence);
    }
    return ranked ? text + rank_text() : text;
}

}  // namespace overturn::output
