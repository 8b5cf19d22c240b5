#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/summary_tables.hpp"
#include "results/rare_results.hpp"
#include "results/schema.hpp"

namespace overturn::output {
namespace {

Table part_table(std::string const& units, std::span<BodyFrequency const> frequencies) {
    struct Row {
        BodyFrequency const* of;
        HazardPart const* part;
    };
    std::vector<Row> rows;
    for (auto const& of : frequencies) {
        if (of.mean) {
            std::ranges::transform(of.mean->parts, std::back_inserter(rows), [&](HazardPart const& part) {
                return Row{&of, &part};
            });
        }
    }
    TableOf<Row> table({.name = "frequency_parts", .constants = {{"units", units}}}, rows);
    table.add("body", "1", "the body", [](Row const& row) { return row.of->body; })
        .add("limit", "1", "the limit state", [](Row const& row) { return row.of->limit; })
        .add("from", stated_unit(units), "motions from this intensity", [](Row const& row) { return row.part->from; })
        .add("to", stated_unit(units), "motions up to this one", [](Row const& row) { return row.part->to; })
        .add("frequency", "1/a", "times passed in a year by motions between them",
             [](Row const& row) { return row.part->annual; });
    return table.take();
}

using Constants = std::vector<std::pair<std::string, Cell>>;

// An item of a list that each level has.
template <class Item> struct OfLevel {
    std::size_t level, place;
    Item const* item;
};

template <class Item>
std::vector<OfLevel<Item>> of_levels(RareBody const& body, std::vector<Item> rare::Estimate::*list) {
    std::vector<OfLevel<Item>> rows;
    for (std::size_t l = 0; l < body.estimates.size(); ++l) {
        auto const& items = body.estimates[l].*list;
        for (std::size_t i = 0; i < items.size(); ++i) {
            rows.push_back({l, i, &items[i]});
        }
    }
    return rows;
}

Table replicate_table(std::string const& group, Constants const& constants, RareBody const& body) {
    using Row = OfLevel<double>;
    auto const rows = of_levels(body, &rare::Estimate::replicates);
    TableOf<Row> table({.name = "rare_replicates", .group = group, .constants = constants}, rows);
    table.add("level", "1", "number of the level, rising from 0", [](Row const& row) { return row.level; })
        .add("replicate", "1", "independent repetition", [](Row const& row) { return row.place; })
        .add("estimate", "1", "estimate of P; not valid if a check of the estimate failed",
             [](Row const& row) { return *row.item; });
    return table.take();
}

Table health_table(std::string const& group, Constants const& constants, RareBody const& body) {
    using Row = OfLevel<rare::HealthCheck>;
    auto const rows = of_levels(body, &rare::Estimate::health);
    TableOf<Row> table({.name = "rare_health", .group = group, .constants = constants}, rows);
    table.add("level", "1", "number of the level, rising from 0", [](Row const& row) { return row.level; })
        .add("check", "1", "what was checked", [](Row const& row) { return row.item->name; })
        .add("value", "1", "what was found", [](Row const& row) { return row.item->value; })
        .add("limit_value", "1", "threshold of the check", [](Row const& row) { return row.item->limit; })
        .add("passed", "1", "1: check passed", [](Row const& row) { return row.item->passed; });
    return table.take();
}

}  // namespace

std::vector<Table> frequency_tables(std::string const& units, std::span<BodyFrequency const> frequencies,
                                    HazardCurve const& hazard, double confidence) {
    using Row = BodyFrequency;
    TableOf<Row> table({.name = "frequency",
                        .constants = {{"hazard_points", std::ssize(hazard.points())}, {"confidence", confidence}}},
                       frequencies);
    auto const mean = [](auto get) {
        return [get](Row const& row) { return row.mean ? std::optional<double>(get(*row.mean)) : std::nullopt; };
    };
    auto const fractile = [](double Row::Fractiles::*member) {
        return
            [member](Row const& row) { return row.fractiles ? std::optional((*row.fractiles).*member) : std::nullopt; };
    };
    auto const share = [](double FrequencyShares::*member) {
        return [member](Row const& row) { return row.shares ? std::optional((*row.shares).*member) : std::nullopt; };
    };
    using Annual = AnnualFrequency;
    table.add("body", "1", "the body", [](Row const& row) { return row.body; })
        .add("limit", "1", "the limit state", [](Row const& row) { return row.limit; })
        .add("mean", "1/a", "mean annual frequency by the curve; NaN: there is no curve",
             mean([](Annual const& annual) { return annual.annual + annual.beyond_least; }))
        .add("frequency", "1/a",
             "the answer: what lies outside of levels and hazard curve as seldom, or as often, as they allow; of the "
             "stripes alone without a curve",
             [](Row const& row) { return row.ends(); })
        .add("extrapolated", "1/a", "of the mean: by motions outside of the levels or of the hazard curve",
             [](Row const& row) { return row.mean ? std::optional(row.extrapolated()) : std::nullopt; })
        .add("continued", "1/a",
             "estimate of the mean with the hazard curve continued at its slopes at both ends, up to one weaker motion "
             "a year",
             [](Row const& row) { return row.mean ? std::optional(row.continued) : std::nullopt; })
        .add("above_levels_most", "1/a",
             "of the upper end: motions above the highest level or the hazard curve's end, counted as failing",
             [](Row const& row) { return row.mean ? std::optional(row.bounds.above_most) : std::nullopt; })
        .add("below_levels_most", "1/a",
             "of the upper end: motions below the lowest level, counted as failing as often as there",
             [](Row const& row) { return row.mean ? std::optional(row.bounds.below_most) : std::nullopt; })
        .add("below_curve_most", "1/a", "of the upper end: motions below the hazard curve's first point",
             [](Row const& row) { return row.mean ? row.bounds.weaker_most : row.seen_below_curve; })
        .add("poor_fit", "1", "1: the curve does not describe the data", [](Row const& row) { return row.poor; })
        .add("fractile_5", "1/a", "by the curve of 95 % confidence", fractile(&Row::Fractiles::low))
        .add("fractile_50", "1/a", "by the median curve", fractile(&Row::Fractiles::median))
        .add("fractile_95", "1/a", "by the curve of 5 % confidence", fractile(&Row::Fractiles::high))
        .add("fractile_95_most", "1/a",
             "upper end of it, by sampling and by motions outside of levels and hazard curve; no lower than that of "
             "frequency",
             fractile(&Row::Fractiles::most))
        .add("stripes_alone", "1/a", "bounds from the stripes without a curve; no upper end where beta_U is not known",
             [](Row const& row) { return row.seen; })
        .add(
            "beyond_curve", "1/a", "motions beyond the last point of the hazard curve",
            [](Row const& row) {
                return row.mean ? std::optional(Interval{row.mean->beyond_least, row.mean->beyond_most}) : std::nullopt;
            })
        .add("share_below_levels", "1", "share of the mean by motions below all levels", share(&FrequencyShares::below))
        .add("share_within_levels", "1", "share by motions between the levels", share(&FrequencyShares::between))
        .add("share_above_levels", "1", "share by motions above all levels", share(&FrequencyShares::above));
    return {table.take(), part_table(units, frequencies)};
}

std::vector<Table> rare_tables(CampaignSpec const& spec, RareBody const& body) {
    using Row = rare::Estimate;
    auto const& name = spec.bodies[body.body].name;
    auto const& limit = spec.limits[body.limit].name;
    Constants const constants{{"body", name}, {"limit", limit}};
    TableOf<Row> table(
        {.name = "rare", .group = group_of("rare", name, limit), .axis = "amplitude", .constants = constants},
        body.estimates);
    auto const trusted = [](double Row::*member) {
        return [member](Row const& row) { return row.probability ? std::optional(row.*member) : std::nullopt; };
    };
    table.add("amplitude", stated_unit("1"), "value of the level", [](Row const& row) { return row.factor; })
        .add("probability", "1", "P of exceeding the limit; NaN: no estimate passed its checks",
             [](Row const& row) { return row.probability; })
        .add("", "1", "95 % confidence interval; from plain trials if no other estimate passed its checks",
             [](Row const& row) { return row.interval_95; })
        .add("cov", "1", "standard error over probability; NaN without one", trusted(&Row::cov))
        .add("crude_runs", "1", "waves that crude Monte Carlo needs for this; NaN without a probability",
             trusted(&Row::crude_runs))
        .add("runs", "1", "number of generated waves, with those that levels share",
             [](Row const& row) { return row.runs; })
        .category("method", "estimator", rare_method_names(), [](Row const& row) { return name_of(row.method); })
        .category("state", "did the estimate pass its checks?", rare_state_names(),
                  [](Row const& row) { return name_of(row.state); })
        .add("reason", "1", "why there is no estimate", [](Row const& row) { return text_or_none(row.reason); })
        .add("tried", "1", "estimators that failed their checks before, and why",
             [](Row const& row) { return text_or_none(fmt::format("{}", fmt::join(row.tried, between_tries))); });
    return {table.take(), replicate_table(group_of("rare_replicates", name, limit), constants, body),
            health_table(group_of("rare_health", name, limit), constants, body)};
}

}  // namespace overturn::output
