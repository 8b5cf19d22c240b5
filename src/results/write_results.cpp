#include "results/write_results.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/ranges.h>

#include "campaign/block_rows.hpp"
#include "campaign/version.hpp"
#include "campaign/withheld_inputs.hpp"
#include "response/registry.hpp"
#include "results/analysis.hpp"
#include "results/detail/column_values.hpp"
#include "results/detail/grid_results.hpp"
#include "results/detail/limit_results.hpp"
#include "results/fragility_schema.hpp"
#include "results/rare_results.hpp"
#include "results/rare_rows.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"

namespace overturn {
namespace {

void write_provenance(store::ResultsWriter& file, CampaignInput const& input, CampaignSpec const& spec) {
    file.attribute("format", store::format_name);
    file.attribute("format_version", store::format_version);
    file.attribute("program_version", program_version());
    file.attribute("git_revision", git_revision());
    file.attribute("sources_sha256", sources_sha256());
    file.attribute("library_versions", library_versions());
    file.attribute("title", spec.title);
    file.attribute("campaign", input.text);
    file.attribute("campaign_name", std::filesystem::path(input.name).filename().string());
    file.attribute("settings", fmt::format("{}", fmt::join(input.settings, "\n")));
    file.attribute("input_sha256", input.sha256());
    file.attribute("seed", static_cast<std::int64_t>(spec.seed));
    file.attribute("level_measure", spec.levels.measure_name());
    file.attribute("level_units", spec.levels.units());
    file.attribute("wave_source", spec.source->describe());
    file.attribute("wave_variability", spec.source->variability());
    file.attribute("wave_acceptance", spec.source->acceptance());
    auto const kept = kept_inputs(input);
    for (auto const& [name, content] : kept) {
        // Names hold '/', which HDF5 reads as a path; the number is the place, the attribute the name.
        auto const place = fmt::format("{:04}", std::distance(kept.begin(), kept.find(name)));
        file.bytes("inputs", place, name, content);
    }
}

void write_body(store::ResultsWriter& file, BodySpec const& spec, std::size_t number, RadiusUnit unit) {
    auto const group = "bodies/" + spec.name;
    auto const& body = spec.body;
    file.array(group, {"body", "1", "number of the body, as in /trials/body"},
               std::vector{static_cast<std::int64_t>(number)});
    auto const put = [&](char const* name, char const* units, char const* description, double value) {
        file.array(group, {name, units, description, FieldType::real, 0, {}}, std::vector<double>{value}, "body");
    };
    put("mass", "kg", "mass", body.mass_kg());
    put("half_width", "m", "b, half of the base", body.half_width_m());
    put("centre_height", "m", "h, height of the centre of gravity", body.centre_height_m());
    put("inertia", "kg m2", "moment of inertia about the centre of gravity", body.inertia_kgm2());
    put("radius", "m", "R = sqrt(b^2 + h^2)", body.radius_m());
    put("alpha", "rad", "critical angle atan(b/h)", body.alpha_rad());
    put("p", "rad/s", "frequency parameter sqrt(m g R / I_O)", body.p_radps());
    put("restitution", "1", "median restitution", body.restitution());
    put("housner_restitution", "1", "1 - 2 m b^2 / I_O", body.housner_restitution());
    put("axes", "1", "components that shake it: 1 horizontal, 2 both horizontal, 3 the vertical one too", spec.axes);
    auto const band = rocking_period_band(body.radius_m(), unit);
    put("t0", "s", "shortest period that the body runs through", band.t0_s);
    put("t1", "s", "longest period that the body runs through", band.t1_s);
    put("v_ereq", "m/s", "limit velocity sqrt(2 g (R - h))", body.limit_velocity_mps());
}

void write_stripes(store::ResultsWriter& file, CampaignSpec const& spec, BodyStatistics const& body) {
    auto const group = "stripes/" + body.body;
    auto const spec_of = [](char const* name, std::string const& units, char const* description) {
        return Field{name, units, description, FieldType::real, 0, {}};
    };
    auto const& s = body.stripes;
    file.array(group, spec_of("amplitude", spec.levels.units(), "value of the level"),
               column_values<double>(s, [](Stripe const& x) { return x.amplitude; }));
    auto const count = [&](char const* name, char const* description, auto get) {
        file.array(group, spec_of(name, "1", description), column_values<std::int64_t>(s, get), "amplitude");
    };
    count("trials", "trials at the level", [](Stripe const& x) { return x.trials; });
    auto const counts = [&](std::string const& name, std::string const& description,
                            std::vector<std::int64_t> const& values) {
        file.array(group, {name, "1", description}, values, "amplitude");
    };
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        auto const& entry = verdicts()[v];
        counts(column_of(entry),
               fmt::format("trials with this end: {}{}", entry.summary,
                           entry.decided ? "" : "; left out of the probability"),
               body.ends[v]);
    }
    bool const grid = !body.grid.empty();
    auto const real = [&](char const* name, char const* description, auto get) {
        file.array(group, spec_of(name, "1", grid ? no_chance : description),
                   column_values<double>(s, [&](Stripe const& x) { return grid ? never : get(x); }), "amplitude");
    };
    double const c = spec.confidence;
    real("probability", "overturned over decided trials; NaN where none is decided",
         [](Stripe const& x) { return x.probability(); });
    real("lower", "lower bound, Clopper-Pearson, undecided trials counted as standing",
         [c](Stripe const& x) { return x.interval(c).lower; });
    real("upper", "upper bound, Clopper-Pearson, undecided trials counted as overturned",
         [c](Stripe const& x) { return x.interval(c).upper; });
    std::vector<std::int64_t> purposes;
    for (auto const& level : spec.levels.levels) {
        purposes.push_back(static_cast<std::int64_t>(level.purpose));
    }
    file.array(group,
               {"purpose", "1", "0 ordinary, 1 design-basis, 2 beyond-design level", FieldType::integer, 0,
                numbered({"ordinary", "design-basis", "beyond-design"})},
               purposes, "amplitude");
    for (std::size_t e = 0; e < effects().size(); ++e) {
        counts(fmt::format("{}_called", effects()[e].name), "trials that call for this effect, simulated or not",
               body.called[e]);
    }
    std::vector<std::string> names;
    for (auto const& rung : rungs()) {
        names.push_back(rung.name);
    }
    std::vector<std::int64_t> numbers(names.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    file.array(group, {"rung", "1", "number of the rung", FieldType::integer, 0, numbered(names)}, numbers);
    file.array(group, {"rung_trials", "1", fmt::format("trials per rung: {}", fmt::join(names, ", "))}, body.rungs,
               "rung");
    file.attribute(group, "confidence", c);
    file.attribute(group, "level_measure", spec.levels.measure_name());
}

void write_confusion(store::ResultsWriter& file, std::string const& group, std::string const& units,
                     std::vector<Stripe> const& stripes, std::vector<Confusion> const& cells) {
    file.array(group, {"amplitude", units, "value of the level", FieldType::real, 0, {}},
               column_values<double>(stripes, [](Stripe const& x) { return x.amplitude; }));
    auto const put = [&](char const* cell, char const* description, auto get) {
        std::vector<std::int64_t> counts;
        counts.reserve(cells.size());
        for (auto const& confusion : cells) {
            counts.push_back(get(confusion));
        }
        file.array(group, {cell, "1", description, FieldType::integer, 0, {}}, counts, "amplitude");
    };
    put("false_safe", "said safe, overturned", [](Confusion const& x) { return x.false_safe; });
    put("false_alarm", "said unsafe, stood", [](Confusion const& x) { return x.false_alarm; });
    put("true_safe", "said safe, stood", [](Confusion const& x) { return x.true_safe; });
    put("true_overturn", "said unsafe, overturned", [](Confusion const& x) { return x.true_overturn; });
    put("undecided_safe", "said safe, failed or contact lost", [](Confusion const& x) { return x.undecided_safe; });
    put("undecided_unsafe", "said unsafe, failed or contact lost",
        [](Confusion const& x) { return x.undecided_unsafe; });
}

void write_criterion(store::ResultsWriter& file, CampaignSpec const& spec, BodyStatistics const& body) {
    auto const group = "criterion/" + body.body;
    write_confusion(file, group + "/v_wes", spec.levels.units(), body.stripes, body.v_wes);
    write_confusion(file, group + "/ou_v_e", spec.levels.units(), body.stripes, body.ou_v_e);
}

// HDF5 lists groups by name, so each body's says which in the campaign's order it is of.
void number_bodies(store::ResultsWriter& file, CampaignSpec const& spec) {
    std::vector<std::string> places{"bodies",    "stripes", "fragility", "criterion",
                                    "quantiles", "waves",   "rare",      "grid"};
    for (auto const& limit : spec.limits) {
        places.push_back("limits/" + limit.name + "/stripes");
        places.push_back("limits/" + limit.name + "/fragility");
    }
    for (auto const& place : places) {
        for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
            if (auto const group = place + "/" + spec.bodies[b].name; file.has_group(group)) {
                file.attribute(group, "index", static_cast<std::int64_t>(b));
            }
        }
    }
}

}  // namespace

std::vector<BodyAnalysis> write_results(std::filesystem::path const& path, CampaignInput const& input,
                                        CampaignSpec const& spec, Plan const& plan,
                                        std::function<std::vector<std::byte>(std::int64_t)> const& block,
                                        Statistics& statistics, std::span<RareBody const> rare) {
    store::ResultsWriter file(path);
    write_provenance(file, input, spec);
    auto const waves = file.table(wave_table(spec), plan.waves());
    std::vector<std::size_t> measures;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        if (auto table = measure_table(spec, b); !table.columns.empty()) {
            measures.push_back(file.table(std::move(table), plan.waves()));
        }
    }
    auto const trials = file.table(trial_table(spec), plan.trials());
    std::vector<std::size_t> own;
    for (auto& table : own_tables(Ladder(spec.effects, spec.accuracy))) {
        own.push_back(file.table(std::move(table), plan.trials()));
    }
    for (std::int64_t b = 0; b < plan.blocks(); ++b) {
        auto const rows = BlockRows::unpack(block(b), plan, plan.waves_of_block(b).count);
        file.append(waves, std::as_bytes(std::span(rows.waves)));
        for (auto const table : measures) {
            file.append(table, std::as_bytes(std::span(rows.measures)));
        }
        file.append(trials, std::as_bytes(std::span(rows.trials.rows)));
        for (auto const table : own) {
            file.append(table, rows.trials.own);
        }
        statistics.add(rows);
    }
    if (spec.has_target()) {
        file.attribute("waves_planned", Plan(spec).waves());
        file.attribute("precise_enough", std::int64_t{plan.waves() < Plan(spec).waves() ? 1 : 0});
    }
    auto analysis = analyse(spec, statistics, {.confidence = spec.confidence});
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        write_body(file, spec.bodies[b], b, spec.measures.radius_unit);
        write_stripes(file, spec, statistics.bodies()[b]);
        write_fragility(file, "fragility/" + spec.bodies[b].name, analysis[b].fragility, spec.confidence);
        if (spec.measures.energy) {
            write_criterion(file, spec, statistics.bodies()[b]);
        }
        if (analysis[b].grid) {
            write_grid(file, spec, analysis[b]);
        } else {
            write_quantiles(file, spec, analysis[b]);
        }
    }
    write_limits(file, spec, statistics, analysis);
    write_rare(file, spec, rare);
    number_bodies(file, spec);
    file.attribute("complete", std::int64_t{1});
    file.finish();
    return analysis;
}

}  // namespace overturn
