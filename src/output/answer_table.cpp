#include <limits>

#include "campaign/typed_units.hpp"
#include "output/answer.hpp"
#include "output/detail/answer_parts.hpp"
#include "output/detail/level_unit.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {

Table answer_table(Answered const& of) {
    struct Row {
        BodyAnalysis const* body;
        std::optional<double> alpha_rad;  // where all trials have the same
        std::string limit;
        std::size_t level;
        Stripe const* stripe;
        rare::Estimate const* rare;  // in place of what the trials show; null: none
        BodyFrequency const* frequency;
        FragilityFit const* fit;
    };
    std::vector<Row> rows;
    for (std::size_t b = 0; b < of.analysis.size() && !of.spec.is_grid(); ++b) {
        auto const& body = of.analysis[b];
        auto const alpha_rad =
            of.spec.bodies[b].draws_alpha() ? std::nullopt : std::optional(of.spec.bodies[b].body.alpha_rad());
        for (std::size_t limit = 0; limit < of.spec.limits.size(); ++limit) {
            for (auto const l : answer_levels(of.spec.levels)) {
                auto const& name = of.spec.limits[limit].name;
                rows.push_back({&body, alpha_rad, name, l, &of.statistics.bodies()[b].stripes_of(limit)[l],
                                rare_estimate_at(of, b, limit, l), frequency_at(of, body.body, name),
                                &body.curves_of(limit).front().fit});
            }
        }
    }
    TableOf<Row> table(
        {.name = "answer", .constants = {{"units", of.spec.levels.units()}, {"confidence", of.confidence}}}, rows);
    auto const why_no_probability = text_or_none(no_probability_text(of));
    bool const too_few = why_no_probability.has_value();
    bool const few = are_few_records(of.spec, of.statistics.waves().waves);  // each is a row of `records`
    enum class Of { median, p95, p95_upper };
    auto const percentile = [few](char const* quantity, Of which) {
        return [=](Row const& row) -> std::optional<double> {
            auto const* const at = quantiles_at(*row.body, quantity, row.level);
            if (few || at == nullptr || mostly_unknown(*at)) {
                return std::nullopt;
            }
            auto const& high = at->quantiles.back();
            auto const value = which == Of::median ? at->quantiles.front().value
                               : which == Of::p95  ? high.value
                                                   : high.upper.value_or(at->fallen);
            return value >= at->fallen ? std::numeric_limits<double>::infinity() : value;
        };
    };
    auto const rotation = [&](Of which) {
        return [ratio = percentile("peak_rotation_ratio", which)](Row const& row) -> std::optional<double> {
            auto const value = ratio(row);
            return value && row.alpha_rad ? std::optional(*value * *row.alpha_rad) : std::nullopt;
        };
    };
    auto const overturned_at = [few](Row const& row) {
        std::vector<std::string> names;
        auto const* const at = quantiles_at(*row.body, "peak_rotation_ratio", row.level);
        if (few || at == nullptr || mostly_unknown(*at)) {
            return names;
        }
        auto const& high = at->quantiles.back();
        // What is above a body that overturned is one too.
        for (auto const& [name, value] : {std::pair("median", at->quantiles.front().value),
                                          {"p95", high.value},
                                          {"p95_upper", high.upper.value_or(high.value)}}) {
            if (value >= at->fallen) {
                names.emplace_back(name);
            }
        }
        return names;
    };
    auto const slip = Unit("m").as(typed_units(of.spec).slip);
    auto const tilt = Unit("rad").as(shown_unit(of.spec, "rad"));
    table.add("body", "1", "the body", [](Row const& row) { return row.body->body; })
        .add("limit", "1", "the limit state", [](Row const& row) { return row.limit; })
        .add("amplitude", level_unit(of.spec.levels), "value of the level",
             [](Row const& row) { return row.stripe->amplitude; })
        .add("purpose", "1", "purpose of the level",
             [&](Row const& row) { return name_of(of.spec.levels.levels[row.level].purpose); })
        .add("trials", "1", "trials there", [](Row const& row) { return row.stripe->trials; })
        .add("exceeded", "1", "trials of these that overturned, or exceeded the limit",
             [](Row const& row) { return row.stripe->overturned; })
        .add("undecided", "1", "of them without a verdict",
             [](Row const& row) { return row.stripe->trials - row.stripe->decided(); })
        .add("probability", "1", "P of the limit state; NaN: only its interval is known, or see no_probability",
             [&](Row const& row) {
                 return too_few               ? std::nullopt
                        : row.rare != nullptr ? row.rare->probability
                                              : std::optional(row.stripe->probability());
             })
        .add("", "1", "its interval: of counts exact, of rare events at 95 %",
             [&](Row const& row) {
                 return too_few               ? std::nullopt
                        : row.rare != nullptr ? std::optional(row.rare->interval_95)
                                              : std::optional(row.stripe->interval(of.confidence));
             })
        .category("probability_by", "what P is taken from: counts of these trials, or the estimate of [rare]",
                  {"counts", "rare"}, [](Row const& row) { return row.rare != nullptr ? "rare" : "counts"; })
        .add("no_probability", "1", "why there is none: few recorded motions",
             [&](Row const&) { return std::optional<std::string>(why_no_probability); })
        .add("peak_slip_median", slip, "median of the peak slip; infinite: overturned",
             percentile("peak_slip", Of::median))
        .add("peak_slip_p95", slip, "95th percentile of it", percentile("peak_slip", Of::p95))
        .add("peak_slip_p95_upper", slip, "upper end of it; infinite: no limit, or overturned",
             percentile("peak_slip", Of::p95_upper))
        .add("peak_rotation_ratio_median", "1", "median of the peak tilt over alpha; infinite: overturned",
             percentile("peak_rotation_ratio", Of::median))
        .add("peak_rotation_ratio_p95", "1", "95th percentile of it", percentile("peak_rotation_ratio", Of::p95))
        .add("peak_rotation_ratio_p95_upper", "1", "upper end of it; infinite: no limit, or overturned",
             percentile("peak_rotation_ratio", Of::p95_upper))
        .add("peak_rotation_median", tilt, "the same as an angle; NaN: alpha is drawn", rotation(Of::median))
        .add("peak_rotation_p95", tilt, "95th percentile of it", rotation(Of::p95))
        .add("peak_rotation_p95_upper", tilt, "upper end of it; infinite: no limit, or overturned",
             rotation(Of::p95_upper))
        .names("overturned_at",
               "those of the medians, 95th percentiles and their upper ends that are of bodies that overturned",
               {"median", "p95", "p95_upper"}, overturned_at)
        .add("hclpf_lower", level_unit(of.spec.levels),
             "HCLPF of the limit state, the lower end of its interval; NaN: not known",
             [=](Row const& row) -> std::optional<double> {
                 auto const ends = row.fit->identifiable() ? row.fit->intervals().hclpf : std::nullopt;
                 return ends ? std::optional(ends->lower) : std::nullopt;
             })
        .add("hclpf", level_unit(of.spec.levels), "estimate of HCLPF; the safe value is hclpf_lower; NaN: not known",
             [](Row const& row) { return row.fit->hclpf(); })
        .add("beta_u", "1", "beta_U by which HCLPF is known",
             [=](Row const& row) -> std::optional<double> {
                 return row.fit->hclpf() ? std::optional(row.fit->beta_u) : std::nullopt;
             })
        .add("annual_frequency", "1/a", "times a year, where a hazard curve is given",
             [=](Row const& row) -> std::optional<Interval> {
                 if (row.frequency == nullptr || too_few) {
                     return std::nullopt;
                 }
                 return row.frequency->ends();
             })
        .add("annual_frequency_95", "1/a",
             "with beta_U, at 95 % confidence, no lower than the upper end of annual_frequency",
             [=](Row const& row) -> std::optional<double> {
                 bool const known = row.frequency != nullptr && !too_few && row.frequency->fractiles;
                 return known ? std::optional(row.frequency->fractiles->most) : std::nullopt;
             });
    return table.take();
}

}  // namespace overturn::output
