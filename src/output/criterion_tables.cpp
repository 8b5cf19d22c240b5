#include "output/detail/confusion_columns.hpp"
#include "output/detail/ratio_columns.hpp"
#include "output/summary_tables.hpp"

namespace overturn::output {
Table criterion_table(std::string const& body, std::span<MeasuredCriterion const> rows, double confidence) {
    using Row = MeasuredCriterion;
    TableOf<Row> table({.name = "criterion",
                        .group = "criterion/" + body,
                        .axis = "measure",
                        .constants = {{"body", body}, {"confidence", confidence}}},
                       rows);
    table
        .category("measure", "the criterion predicts safe where this measure is below V_Ereq",
                  [](Row const& row) { return std::string(row.measure->name); })
        .add("title", "1", "the measure as a figure's axis names it",
             [](Row const& row) { return std::string(in_any_unit(row.measure)->title); })
        .category("radius_unit", "unit in which R enters T0 and T1", {"cm", "m"},
                  [](Row const& row) { return std::string(name_of(row.radius_unit)); });
    add_confusion(table, [](Row const& row) -> Confusion const& { return row.study.counts; });
    auto const share = [](Share CriterionStudy::*member) {
        return [member](Row const& row) -> Share const& { return row.study.*member; };
    };
    using S = CriterionStudy;
    add_share(table, "false_safe_share", "overturned, of trials predicted safe", share(&S::safe_but_overturned));
    add_share(table, "false_safe_share_uplifted", "overturned, of trials predicted safe that uplifted",
              share(&S::safe_uplifted_but_overturned));
    add_share(table, "missed_share", "predicted safe, of trials that overturned", share(&S::overturned_predicted_safe));
    add_share(table, "false_alarm_share", "stood, of trials predicted unsafe", share(&S::unsafe_but_stood));
    add_share(table, "alarm_share_standing", "predicted unsafe, of trials that stood",
              share(&S::stood_predicted_unsafe));
    add_share(table, "false_safe_share_waves", "with a false-safe trial, of waves with a trial predicted safe",
              share(&S::waves_safe_but_overturned));
    add_share(table, "false_safe_share_waves_uplifted",
              "with a false-safe trial, of waves with a trial predicted safe that uplifted",
              share(&S::waves_safe_uplifted_but_overturned));
    auto const ratio = [](std::optional<RatioQuantiles> S::*member) {
        return [member](Row const& row) -> std::optional<RatioQuantiles> const& { return row.study.*member; };
    };
    add_percentiles(table, "ratio_at_overturning", "measure / V_Ereq of trials that overturned",
                    ratio(&S::at_overturning));
    add_percentiles(table, "ratio_at_first_overturning",
                    "measure / V_Ereq at the lowest level of each wave that overturned", ratio(&S::first_overturning));
    add_percentiles(table, "ratio_at_highest_standing", "measure / V_Ereq at the highest level of each wave that stood",
                    ratio(&S::highest_standing));
    return table.take();
}

Table response_table(std::string const& body, std::span<ResponseBin const> bins) {
    using Row = ResponseBin;
    TableOf<Row> table({.name = "response", .group = "response/" + body, .axis = "from", .constants = {{"body", body}}},
                       bins);
    table.add("from", "1", "lower end of the bin of V_WES / V_Ereq", [](Row const& row) { return row.from; })
        .add("to", "1", "upper end; infinite: no upper end", [](Row const& row) { return row.to; })
        .add("overturned", "1", "trials in the bin that overturned", [](Row const& row) { return row.overturned; });
    add_percentiles(table, "without_slip", "V_resp / V_Ereq of trials that moved and stood, without slip",
                    [](Row const& row) -> std::optional<RatioQuantiles> const& { return row.without_slip; });
    add_percentiles(table, "with_slip", "V_resp / V_Ereq of trials that moved and stood, with slip",
                    [](Row const& row) -> std::optional<RatioQuantiles> const& { return row.with_slip; });
    return table.take();
}

Table limit_table(CampaignSpec const& spec) {
    TableOf<LimitState> table({.name = "limit_states", .group = "limit_states"}, spec.limits);
    table.add("name", "1", "limit state", [](LimitState const& limit) { return limit.name; })
        .add("full_name", "1",
             "name in printed lines; with \"without overturning\" if overturning alone does not count",
             [&](LimitState const& limit) { return full_name(limit, spec.limits); })
        .add("definition", "1", "condition that a trial must meet to exceed the limit",
             [&](LimitState const& limit) { return definition_of(limit, spec.limits); })
        .add("quantity", "1", "response compared with the threshold; empty: none",
             [](LimitState const& limit) { return text_or_none(limit.quantity.name); })
        .add("units", "1", "its unit",
             [](LimitState const& limit) { return limit.quantity.name.empty() ? "1" : limit.quantity.units; })
        .add("side", "1", "which side of the threshold is passed", [](LimitState const& limit) {
            return text_or_none(limit.rule == LimitState::Rule::above   ? "above"
                                : limit.rule == LimitState::Rule::below ? "below"
                                                                        : "");
        });
    table.add("threshold", unit_of_row(), "threshold, in its unit; NaN: none", [](LimitState const& limit) {
        return limit.quantity.name.empty() ? std::nullopt : std::optional(limit.threshold);
    });
    return table.take();
}

Table sigma_table(std::optional<AchievedSigma> const& sigma) {
    using Row = AchievedMeasure;
    std::vector<Row> const rows = sigma ? sigma->measures : std::vector<Row>{};
    Table table{.name = "sigma", .group = "sigma"};
    if (sigma) {
        table.constants = {{"waves", sigma->waves},
                           {"independent", sigma->independent},
                           {"independent_are", std::string(sigma->of_events ? "events" : "targets")},
                           {"missed_match_tolerance", sigma->missed}};
    }
    TableOf<Row> made(std::move(table), rows);
    made.add("measure", "1", "measure of the unscaled waves", [](Row const& row) { return row.name; })
        .add("label", "1", "the same as figures and tables name it", [](Row const& row) { return row.label; })
        .add("period", "s", "period of the stated sigma", [](Row const& row) { return row.period_s; })
        .add("stated", "1", "standard deviation of ln Sa of the targets; NaN: not matched there",
             [](Row const& row) { return row.stated; })
        .add("achieved", "1", "standard deviation of ln of the measure", [](Row const& row) { return row.achieved; })
        .add("standard_error", "1", "its standard error", [](Row const& row) { return row.error; });
    return made.take();
}

}  // namespace overturn::output
