#include "output/summary_tables.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/typed_units.hpp"
#include "output/curve_tables.hpp"
#include "output/detail/level_unit.hpp"
#include "response/registry.hpp"
#include "results/rare_results.hpp"

namespace overturn::output {
namespace {

Table any_table(CampaignSpec const& spec, BodiesTogether const& of, double confidence) {
    struct Row {
        Stripe const* any;
        double if_independent;
    };
    std::vector<Row> rows;
    for (std::size_t l = 0; l < of.joint.any.size(); ++l) {
        rows.push_back({&of.joint.any[l], of.joint.if_independent[l]});
    }
    TableOf<Row> table({.name = "together",
                        .group = "together/" + of.limit,
                        .axis = "amplitude",
                        .constants = {{"limit", of.limit}, {"units", spec.levels.units()}, {"confidence", confidence}}},
                       rows);
    table
        .add("amplitude", stated_unit(spec.levels.units()), "value of the level",
             [](Row const& row) { return row.any->amplitude; })
        .add("waves", "1", "waves with a trial of every body", [](Row const& row) { return row.any->trials; })
        .add(passed_name(of.passing), "1", "waves of these in which any body exceeded the limit",
             [](Row const& row) { return row.any->overturned; })
        .add("undecided", "1", "waves in which no body overturned and at least one body has no verdict",
             [](Row const& row) { return row.any->undecided; })
        .add("probability", "1", "P that any body exceeds the limit",
             [](Row const& row) { return row.any->probability(); })
        .add("", "1", "its exact interval", [confidence](Row const& row) { return row.any->interval(confidence); })
        .add("if_independent", "1", "the same probability for independent bodies; NaN: unknown",
             [](Row const& row) { return row.if_independent; });
    return table.take();
}

Table pair_table(CampaignSpec const& spec, BodiesTogether const& of) {
    struct Row {
        JointPair const* pair;
        std::size_t level;
        double amplitude;
    };
    std::vector<Row> rows;
    for (auto const& pair : of.joint.pairs) {
        for (std::size_t l = 0; l < pair.phi.size(); ++l) {
            rows.push_back({&pair, l, of.joint.any.at(l).amplitude});
        }
    }
    auto const names = names_of(spec.bodies);
    TableOf<Row> table({.name = "pairs",
                        .group = "pairs/" + of.limit,
                        .constants = {{"limit", of.limit}, {"units", spec.levels.units()}}},
                       rows);
    table.category("first", "a body", names, [&](Row const& row) { return names[row.pair->first]; })
        .category("second", "another one", names, [&](Row const& row) { return names[row.pair->second]; })
        .add("amplitude", stated_unit(spec.levels.units()), "value of the level",
             [](Row const& row) { return row.amplitude; })
        .add("phi", "1",
             "correlation of their outcomes at the level; NaN: one of them has the same outcome in all trials",
             [](Row const& row) { return row.pair->phi[row.level]; })
        .add("phi_pooled", "1", "the same over all levels", [](Row const& row) { return row.pair->pooled; });
    return table.take();
}

}  // namespace

std::vector<Table> together_tables(CampaignSpec const& spec, std::span<BodiesTogether const> together,
                                   double confidence) {
    std::vector<Table> tables;
    for (auto const& of : together) {
        tables.push_back(any_table(spec, of, confidence));
        tables.push_back(pair_table(spec, of));
    }
    return tables;
}

Table telling_trial_table(CampaignSpec const& spec, std::span<TellingTrial const> trials) {
    using Row = TellingTrial;
    TableOf<Row> table({.name = "telling_trials", .constants = {{"units", spec.levels.units()}}}, trials);
    table.add("body", "1", "the body", [&](Row const& t) { return spec.bodies[t.body].name; })
        .add("kind", "1", "why to inspect it",
             [](Row const& t) { return std::string(telling_kinds.at(static_cast<std::size_t>(t.kind))); })
        .add("trial", "1", "number of its row in /trials", [](Row const& t) { return t.trial; })
        .add("wave", "1", "number of its wave", [](Row const& t) { return t.wave; })
        .add("level", "1", "number of its level", [](Row const& t) { return t.level; })
        .add("amplitude", level_unit(spec.levels), "value of the level", [](Row const& t) { return t.amplitude; })
        .add("verdict", "1", "how it ended", [](Row const& t) { return std::string(entry_of(t.verdict).name); })
        .add("peak_rotation_ratio", "1", "max |theta| / alpha", [](Row const& t) { return t.peak_rotation_ratio; })
        .add("peak_slip", Unit("m").as(typed_units(spec).slip),
             "max |slip| of the base; of a body that overturned: until then",
             [](Row const& t) { return t.peak_slip_m; })
        .add("overturned_at", level_unit(spec.levels),
             "of a trial that stood: the lower level at which its wave overturned the body",
             [](Row const& t) { return t.overturned_at; });
    return table.take();
}

Table hand_check_table(CampaignSpec const& spec, std::span<HandCheck const> checks) {
    using Row = HandCheck;
    TableOf<Row> table(
        {.name = "hand_check",
         .constants = {{"method", std::string("energy balance under a vector spectrum of the first waves")},
                       {"demand_fractile", checks.empty() ? 0 : checks.front().fractile},
                       {"units", spec.levels.units()}}},
        checks);
    auto const body_of = [&spec](Row const& row) -> BodySpec const& {
        return *std::ranges::find(spec.bodies, row.body, &BodySpec::name);
    };
    table.add("body", "1", "the body", [](Row const& row) { return row.body; })
        .add("waves", "1", "first waves whose spectra are the demand", [](Row const& row) { return row.waves; })
        .add("left_out", "1", "components of the waves that the method leaves out",
             [](Row const& row) { return text_or_none(row.left_out); })
        .add("overturning_level", level_unit(spec.levels), "level at which the demand reaches the capacity",
             [](Row const& row) { return row.overturning_level; })
        .add("simulated_median", level_unit(spec.levels),
             "median of the simulated curve; without one the lowest level at which half overturned; NaN: none",
             [](Row const& row) { return row.simulated_median; })
        .add("unsafe", "1", "1: above the simulated median, not to be quoted; NaN: nothing to compare with",
             [](Row const& row) { return row.simulated_median ? std::optional(row.is_unsafe()) : std::nullopt; })
        .add("rotation_ratio", "1", "rotation there over alpha",
             [=](Row const& row) { return row.rocking.rotation_rad / body_of(row).body.alpha_rad(); })
        .add("frequency", "Hz", "effective frequency there", [](Row const& row) { return row.rocking.frequency_hz; })
        .add("damping", "1", "effective damping", [](Row const& row) { return row.rocking.damping; })
        .add("sliding", Unit("m").as(typed_units(spec).slip),
             "slip at the design basis; NaN: no friction or no design basis",
             [](Row const& row) { return row.sliding_m; });
    return table.take();
}

Table two_measure_table(std::span<TwoMeasures const> fits, double confidence) {
    using Row = TwoMeasures;
    TableOf<Row> table({.name = "two_measures", .constants = {{"confidence", confidence}}}, fits);
    auto const estimate = [&](std::string const& name, std::string const& what, auto get) {
        table
            .add(name, "1", what,
                 [get](Row const& row) { return row.fit ? std::optional(get(*row.fit).value) : std::nullopt; })
            .add(name, "1", "the coefficient, by bootstrap over waves",
                 [get](Row const& row) { return row.fit ? std::optional(get(*row.fit).interval) : std::nullopt; });
    };
    table.add("body", "1", "the body", [](Row const& row) { return row.body; })
        .add("limit", "1", "the limit state", [](Row const& row) { return row.limit; })
        .add("first", "1", "the first measure", [](Row const& row) { return row.names[0]; })
        .add("second", "1", "the second measure", [](Row const& row) { return row.names[1]; })
        .add("identifiable", "1", "1: the trials hold such a curve",
             [](Row const& row) { return row.fit.has_value(); });
    estimate("constant", "constant of P = Phi(constant + slope_first ln a + slope_second ln b)",
             [](TwoMeasureFit const& fit) { return fit.constant; });
    estimate("slope_first", "slope with ln of the first measure",
             [](TwoMeasureFit const& fit) { return fit.slopes[0]; });
    estimate("slope_second", "slope with ln of the second", [](TwoMeasureFit const& fit) { return fit.slopes[1]; });
    estimate("beta", "lognormal standard deviation where both measures scale equally",
             [](TwoMeasureFit const& fit) { return fit.beta; });
    table
        .add("better_alone", "1", "the measure that describes the trials better alone",
             [](Row const& row) { return text_or_none(row.fit ? row.names.at(row.fit->better) : ""); })
        .add("deviance_gain", "1", "by which both together fall below that one alone",
             [](Row const& row) { return row.fit ? std::optional(row.fit->deviance_gain) : std::nullopt; })
        .add("trials", "1", "trials in the fit", [](Row const& row) { return row.fit ? row.fit->trials : 0; })
        .add("waves", "1", "their waves", [](Row const& row) { return row.fit ? row.fit->waves : 0; });
    return table.take();
}

}  // namespace overturn::output
