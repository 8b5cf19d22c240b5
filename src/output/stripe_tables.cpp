#include "output/stripe_tables.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "output/curve_tables.hpp"
#include "output/detail/confusion_columns.hpp"
#include "response/registry.hpp"
#include "results/schema.hpp"

namespace overturn::output {
namespace {

constexpr char const* no_chance = "NaN: the waves are no sample, but a grid of frequencies or too few recorded motions";

using Constants = std::vector<std::pair<std::string, Cell>>;

Constants of_level(CampaignSpec const& spec, Constants before) {
    before.insert(before.end(), {{"measure", spec.levels.measure_name()}, {"units", spec.levels.units()}});
    return before;
}

// A row of a table by level: what `list[level]` holds.
struct AtLevel {
    std::size_t level;
    double amplitude;
};

std::vector<AtLevel> levels_of(std::span<Stripe const> stripes) {
    std::vector<AtLevel> rows;
    for (auto const& stripe : stripes) {
        rows.push_back({rows.size(), stripe.amplitude});
    }
    return rows;
}

// The level's value lies in the unit of the levels, which the constant "units" names.
void add_level(TableOf<AtLevel>& table, std::string const& units) {
    table.add("amplitude", stated_unit(units), "value of the level", [](AtLevel const& row) { return row.amplitude; })
        .add("level", "1", "number of the level, rising from 0", [](AtLevel const& row) { return row.level; });
}

void add_counts(TableOf<AtLevel>& table, std::span<Stripe const> stripes, Passing passing) {
    auto const of = [stripes](auto member) {
        return [stripes, member](AtLevel const& row) { return stripes[row.level].*member; };
    };
    bool const overturns = passing == Passing::overturned;
    table.add("trials", "1", "trials at the level", of(&Stripe::trials))
        .add(passed_name(passing), "1", overturns ? "trials that overturned" : "trials that exceeded the limit",
             of(&Stripe::overturned))
        .add("failed", "1", "trials without a verdict, for a reason; left out of the probability", of(&Stripe::failed))
        .add("undecided", "1", "further trials without a verdict; left out of the probability", of(&Stripe::undecided));
}

void add_chances(TableOf<AtLevel>& table, std::span<Stripe const> stripes, double confidence, bool sample) {
    table
        .add("probability", "1", sample ? "passed over decided trials; NaN where none is decided" : no_chance,
             [=](AtLevel const& row) { return sample ? stripes[row.level].probability() : never; })
        .add("", "1",
             sample
                 ? "the exact interval (Clopper-Pearson); undecided trials count as not passed below, as passed above"
                 : no_chance,
             [=](AtLevel const& row) {
                 return sample ? std::optional(stripes[row.level].interval(confidence)) : std::nullopt;
             });
}

void add_ends(TableOf<AtLevel>& table, CampaignSpec const& spec, BodyStatistics const& body) {
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        auto const& entry = verdicts()[v];
        if (entry.value == Verdict::overturned || entry.value == Verdict::failed) {
            continue;  // counted above
        }
        table.add(column_of(entry.name), "1",
                  fmt::format("trials with this end: {}{}", entry.summary,
                              entry.decided ? "" : "; left out of the probability"),
                  [&body, v](AtLevel const& row) { return body.ends[v][row.level]; });
    }
    table
        .category("purpose", "purpose of the level", {"ordinary", "design-basis", "beyond-design"},
                  [&spec](AtLevel const& row) { return std::string(name_of(spec.levels.levels[row.level].purpose)); })
        .add("fell_after_record", "1", "trials that overturned only after the end of the record",
             [&body](AtLevel const& row) { return body.fell_after_record[row.level]; })
        .add("peaked_after_record", "1", "trials that did not overturn and reached peak rotation after the record",
             [&body](AtLevel const& row) { return body.peaked_after_record[row.level]; });
    for (std::size_t e = 0; e < effects().size(); ++e) {
        table.add(fmt::format("{}_called", effects()[e].name), "1", "trials that require this effect, simulated or not",
                  [&body, e](AtLevel const& row) { return body.required[e][row.level]; });
    }
}

// In the order of verdicts().
std::vector<std::string> verdict_names() {
    std::vector<std::string> names;
    for (auto const& entry : verdicts()) {
        names.emplace_back(entry.name);
    }
    return names;
}

}  // namespace

Table stripe_table(CampaignSpec const& spec, BodyStatistics const& body, std::size_t limit, double confidence,
                   bool sample) {
    auto const& name = spec.limits[limit].name;
    auto const& stripes = body.stripes_of(limit);
    auto const rows = levels_of(stripes);
    TableOf<AtLevel> table(
        {.name = "stripes",
         .group = group_of("stripes", body.body, name),
         .axis = "amplitude",
         .constants = of_level(spec, {{"body", body.body}, {"limit", name}, {"confidence", confidence}})},
        rows);
    add_level(table, spec.levels.units());
    add_counts(table, stripes, spec.limits[limit].passing());
    add_chances(table, stripes, confidence, sample);
    if (limit == 0) {
        add_ends(table, spec, body);
    }
    return table.take();
}

Table stripe_table(std::span<Stripe const> stripes, std::string const& unit, double confidence) {
    auto const rows = levels_of(stripes);
    TableOf<AtLevel> table({.name = "stripes",
                            .constants = {{"body", std::string()},
                                          {"limit", std::string(overturning_limit)},
                                          {"units", unit},
                                          {"confidence", confidence}}},
                           rows);
    add_level(table, unit);
    add_counts(table, stripes, Passing::overturned);
    add_chances(table, stripes, confidence, true);
    return table.take();
}

Table model_table(BodyStatistics const& body) {
    std::vector<std::size_t> rows;
    std::vector<std::string> names;
    for (std::size_t m = 0; m < model_categories().size(); ++m) {
        rows.push_back(m);
        names.push_back(model_categories()[m].name);
    }
    TableOf<std::size_t> table({.name = "models",
                                .group = group_of("models", body.body, overturning_limit),
                                .axis = "model",
                                .constants = {{"body", body.body}}},
                               rows);
    table.category("model", "the model that gave the result", names, [&names](std::size_t m) { return names[m]; })
        .add("trials", "1", "trials with a result of this model", [&body](std::size_t m) { return body.models[m]; });
    return table.take();
}

Table criterion_level_table(CampaignSpec const& spec, BodyStatistics const& body, std::string const& measure,
                            std::vector<Confusion> const& cells) {
    auto const rows = levels_of(body.stripes);
    TableOf<AtLevel> table({.name = "criterion_by_level",
                            .group = fmt::format("criterion_by_level/{}/{}", body.body, measure),
                            .axis = "amplitude",
                            .constants = {{"body", body.body}, {"measure", measure}, {"units", spec.levels.units()}}},
                           rows);
    add_level(table, spec.levels.units());
    add_confusion(table, [&cells](AtLevel const& row) -> Confusion const& { return cells[row.level]; });
    table
        .add("undecided_safe", "1", "predicted safe, no verdict",
             [&cells](AtLevel const& row) { return cells[row.level].undecided_safe; })
        .add("undecided_unsafe", "1", "predicted unsafe, no verdict",
             [&cells](AtLevel const& row) { return cells[row.level].undecided_unsafe; });
    return table.take();
}

Table capacities_table(std::span<Capacity const> capacities, std::string const& unit) {
    using Row = std::span<Capacity const>;
    auto const moment = [](auto which) {
        return [which](Row const& row) {
            auto const moments = moments_of(row);
            return moments ? std::optional((*moments).*which) : std::nullopt;
        };
    };
    TableOf<Row> table({.name = "capacities", .constants = {{"units", unit}}}, std::span(&capacities, 1));
    table.add("count", "1", "capacities, of a wave each", [](Row const& row) { return std::ssize(row); })
        .add("not_reached", "1", "censored ones: the body stood up to there",
             [](Row const& row) { return std::ranges::count(row, false, &Capacity::reached); })
        .add("moments_median", stated_unit(unit), "median by moments; null: censored, or fewer than five",
             moment(&CapacityMoments::median))
        .add("moments_beta", "1", "beta by moments, over n - 1; null as moments_median",
             moment(&CapacityMoments::beta));
    return table.take();
}

Table quantile_table(CampaignSpec const& spec, std::string const& body, std::span<LevelQuantiles const> rows,
                     double confidence) {
    using Row = LevelQuantiles;
    auto const& of = rows.front();
    TableOf<Row> table({.name = "quantiles",
                        .group = fmt::format("quantiles/{}/{}", body, of.quantity),
                        .axis = "amplitude",
                        .constants = {{"body", body},
                                      {"quantity", of.quantity},
                                      {"units", of.units},
                                      {"level_units", spec.levels.units()},
                                      {"confidence", confidence}}},
                       rows);
    table
        .add("amplitude", stated_unit(spec.levels.units()), "value of the level",
             [](Row const& row) { return row.amplitude; })
        .add("level", "1", "number of the level, rising from 0", [](Row const& row) { return row.level; })
        .add("trials", "1", "trials whose value is known", [](Row const& row) { return row.trials; })
        .add("unknown", "1", "further trials of unknown value: they widen the interval",
             [](Row const& row) { return row.unknown; })
        .add("overturned", "1",
             "of the known ones overturned: they lie above every value, where a percentile of slip is infinite",
             [](Row const& row) { return row.overturned; });
    auto const unit = stated_unit(of.units);
    table.add("lowest", unit, "lowest known value; NaN: none is known", [](Row const& row) { return row.least; })
        .add("highest", unit, "highest known value", [](Row const& row) { return row.most; });
    static constexpr std::array names{"median", "p84", "p95"};
    for (std::size_t q = 0; q < names.size(); ++q) {
        auto const what = fmt::format("value that {:g} % of the trials do not exceed", 100 * of.quantiles.at(q).share);
        table.add(names.at(q), unit, what, [q](Row const& row) { return row.quantiles.at(q).value; })
            .add(std::string(names.at(q)) + "_lower", unit, "lower end of it between order statistics; NaN: open",
                 [q](Row const& row) { return row.quantiles.at(q).lower; })
            .add(std::string(names.at(q)) + "_upper", unit, "upper end; NaN: no upper end",
                 [q](Row const& row) { return row.quantiles.at(q).upper; });
    }
    return table.take();
}

Table grid_table(CampaignSpec const& spec, BodySpec const& body, GridMap const& map) {
    TableOf<GridLine> table(
        {.name = "grid",
         .group = "grid/" + body.name,
         .axis = "frequency",
         .constants = {{"body", body.name}, {"measure", spec.levels.measure_name()}, {"units", spec.levels.units()}}},
        map.lines);
    table.add("frequency", "Hz", "frequency of the wave", [](GridLine const& line) { return 1 / line.period_s; })
        .add("period", "s", "its period", [](GridLine const& line) { return line.period_s; })
        .add("wave", "1", "number of the wave", [](GridLine const& line) { return line.wave; });
    auto const level = [&](std::string const& name, std::string const& what, auto place) {
        table.add(name, stated_unit(spec.levels.units()), what + "; NaN: none of these levels",
                  [&map, place](GridLine const& line) { return map.value(place(line)); });
    };
    level("uplift", "lowest level with uplift", [](GridLine const& line) { return line.uplift; });
    level("overturning", "lowest level at which it overturned",
          [](GridLine const& line) { return line.least.front(); });
    level("standing", "highest level at which it stood", [](GridLine const& line) { return line.standing; });
    for (std::size_t limit = 1; limit < map.limits.size(); ++limit) {
        level("limit_" + map.limits[limit], fmt::format("least level that exceeded {}", map.limits[limit]),
              [limit](GridLine const& line) { return line.least.at(limit); });
    }
    table.add("undecided", "1", "levels without a verdict", [](GridLine const& line) { return line.undecided; });
    return table.take();
}

Table grid_level_table(CampaignSpec const& spec, BodySpec const& body, GridMap const& map) {
    struct At {
        GridLine const* line;
        std::size_t level;
    };
    std::vector<At> rows;
    for (auto const& line : map.lines) {
        for (std::size_t level = 0; level < map.levels.size(); ++level) {
            rows.push_back({&line, level});
        }
    }
    TableOf<At> table({.name = "grid_by_level",
                       .group = "grid_by_level/" + body.name,
                       .constants = {{"body", body.name}, {"units", spec.levels.units()}}},
                      rows);
    table.add("frequency", "Hz", "frequency of the wave", [](At const& at) { return 1 / at.line->period_s; })
        .add("wave", "1", "number of the wave", [](At const& at) { return at.line->wave; })
        .add("amplitude", stated_unit(spec.levels.units()), "value of the level",
             [&map](At const& at) { return map.levels[at.level]; })
        .category("verdict", "how the trial ended", verdict_names(),
                  [](At const& at) { return std::string(entry_of(at.line->ends.at(at.level)).name); })
        .add("steady_rotation_ratio", "1",
             "steady rotation over alpha by the linearised closed form (Spanos and Koh 1984); NaN: there is none",
             [&](At const& at) {
                 return steady_rotation_ratio(spec.levels, map.levels[at.level], at.line->period_s, body.body);
             });
    return table.take();
}

}  // namespace overturn::output
