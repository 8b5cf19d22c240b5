#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/validated_range.hpp"
#include "campaign/warnings.hpp"
#include "cli/assumptions_text.hpp"
#include "cli/plan_bodies.hpp"
#include "cli/plan_ranks.hpp"
#include "cli/plan_sizes.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "cli/walltime.hpp"
#include "core/elapsed.hpp"
#include "core/error.hpp"
#include "core/shared_rows.hpp"
#include "core/texts_of.hpp"
#include "core/wrapped.hpp"
#include "output/frequency_text.hpp"
#include "output/shown_levels.hpp"
#include "output/stripe_text.hpp"
#include "output/waves_text.hpp"
#include "results/hazard_table.hpp"
#include "results/statistics.hpp"
#include "runner/probe.hpp"
#include "runner/progress.hpp"
#include "runner/rare_forecast.hpp"

namespace overturn::cli {
namespace {

void print_entry(std::string_view label, std::string const& text) { fmt::print("{}", labelled(label, text)); }

// The limit states of the user's own, and what they make every trial simulate.
void print_limits(CampaignSpec const& spec) {
    for (auto const& limit : std::span(spec.limits).subspan(1)) {
        print_entry("limit", fmt::format("{}: {}", limit.name, definition_of(limit, spec.limits)));
    }
    if (spec.effects.mode == EffectMode::automatic && spec.effects.include != 0) {
        print_entry("effects", fmt::format("{} in every trial, because a limit state needs what it gives",
                                           names_of_effects(spec.effects.include)));
    }
}

constexpr std::int64_t most_asked_ranks = 10'000'000;

struct PlanOptions {
    std::string campaign;
    std::vector<std::string> settings;
    VelocityUnit unit;
    std::optional<std::int64_t> ranks;
    std::optional<std::string> max_walltime;
    bool json = false;
    bool full = false;
};

Json planned_levels_json(LevelSpec const& levels) {
    Json list = Json::array();
    for (auto const& level : levels.levels) {
        list.push_back(
            {{"amplitude", level.value}, {"stated", levels.shown(level.value)}, {"purpose", name_of(level.purpose)}});
    }
    return {{"measure", levels.measure_label()},
            {"units", levels.units()},
            {"stated_unit", levels.shown_units()},
            {"levels", list}};
}

Json planned_limits_json(CampaignSpec const& spec) {
    Json list = Json::array();
    for (auto const& limit : std::span(spec.limits).subspan(1)) {
        list.push_back({{"name", limit.name}, {"definition", definition_of(limit, spec.limits)}});
    }
    return list;
}

// Its times are never twice the same.
Json probe_json(CampaignSpec const& spec, ProbedCost const& cost) {
    Json models = Json::object();
    for (std::size_t r = 0; r < cost.models.models.size(); ++r) {
        auto const& model = cost.models.models[r];
        if (model.trials > 0) {
            models[model_categories()[r].name] = {{"trials", model.trials},
                                                  {"each_s", model.seconds / static_cast<double>(model.trials)}};
        }
    }
    auto const accepted = output::waves_text(cost.waves, spec.source->about().acceptance, spec.confidence);
    return {{"wave_s", cost.wave_s()},
            {"generation_s", cost.generation_s},
            {"measures_s", cost.measures_s},
            {"trials_s", cost.trials_s},
            {"counted_wave_s", cost.counted_wave_s()},
            {"accepted", or_null(!accepted.empty(), accepted)},
            {"models", models}};
}

std::vector<std::int64_t> asked_ranks(PlanOptions const& options) {
    std::vector<std::int64_t> ranks{1, std::max<std::int64_t>(1, std::thread::hardware_concurrency())};
    if (options.ranks) {
        ranks.push_back(*options.ranks);
    }
    return ranks;
}

// What a run does before its first block was done here by now.
StartSeconds start_of_run(double calibration_s) {
    return {.own = seconds_since(program_begin()) - calibration_s, .calibration = calibration_s};
}

ForecastSeconds seconds_of(StartSeconds const& start, ProbedCost const& cost, RareForecast const& rare) {
    return {.start = start,
            .wave = cost.counted_wave_s(),
            .rare = rare.seconds.likely,
            .undecided_bodies = cost.undecided_bodies};
}

// Of this job or as stated; infinite without one. [s]
double limit_of(PlanOptions const& options) {
    auto const of_job = seconds_of_job();
    return options.max_walltime ? std::min(of_job, stated_walltime(*options.max_walltime)) : of_job;
}

// Of one rank.
Json rare_json(RareForecast const& rare) {
    auto const ends = [](rare::Effort const& effort) {
        return Json{{"least", effort.least}, {"likely", effort.likely}, {"most", effort.most}};
    };
    return {{"trials", ends(rare.trials)}, {"seconds", ends(rare.seconds)}};
}

std::string rare_text(CampaignSpec const& spec, RareForecast const& rare) {
    return fmt::format(
        "{} bodies, {} limit states, {} levels beside the trials: about {:.1g} trials, {} on one core; "
        "{} if the first estimator can be trusted, {} at most ({} waves an estimator); their rows are "
        "not counted here",
        spec.bodies.size(), spec.limits.size(), spec.levels.levels.size(), rare.trials.likely,
        duration_text(rare.seconds.likely), duration_text(rare.seconds.least), duration_text(rare.seconds.most),
        spec.rare->max_runs);
}

// What a run finds after a hundred waves.
std::string no_wave_text(ProbedCost const& cost) {
    return fmt::format("{}. A run ends without results where fewer than one wave in ten meets it", cost.none_accepted);
}

// All that the text says, in SI.
int print_plan_json(CampaignInput const& input, CampaignSpec& spec, Plan const& drawn, double calibration_s,
                    std::optional<HazardCurve> const& hazard, PlanOptions const& options, double limit_s) {
    auto const plan = drawn.without_refusals();
    Json json{{"title", spec.title},
              {"waves", plan.waves()},
              {"trials", plan.trials()},
              {"blocks", plan.blocks()},
              {"block_waves", plan.block_size()},
              {"wave_source", spec.source->text()},
              {"wave_remarks", spec.source->about().remarks},
              {"variability", spec.source->about().variability},
              {"records", ends_of_records(spec)},
              {"bodies", bodies_json(spec)},
              {"levels", planned_levels_json(spec.levels)},
              {"limits", planned_limits_json(spec)},
              {"hazard", hazard ? Json(input.hazard_file()) : Json()},
              {"effects", names_of_effects(spec.effects.include)},
              {"validated", validated_range_text(spec, spec.bodies.size())},
              {"rare_max_waves", spec.rare ? Json(spec.rare->max_runs) : Json()},
              {"warnings", warnings_of(spec)},
              {"assumptions", assumptions_json(spec)}};
    json.update(sizes_json(input, spec, plan));
    auto const start = start_of_run(calibration_s);
    auto const cost = probe(spec, drawn);
    auto const rare = forecast_rare(spec);
    json["probe"] = probe_json(spec, cost);
    if (!cost.none_accepted.empty()) {
        json["warnings"].push_back(no_wave_text(cost));
    }
    json["rare"] = spec.rare ? rare_json(rare) : Json();
    json["ranks"] = Json::array();
    for (auto const ranks : asked_ranks(options)) {
        json["ranks"].push_back(ranks_json(estimate_ranks(spec, plan, seconds_of(start, cost, rare), ranks)));
    }
    json["limit_s"] = or_null(std::isfinite(limit_s), limit_s);
    auto const on_most = estimate_ranks(spec, plan, seconds_of(start, cost, rare), asked_ranks(options).back());
    if (auto const text = too_short_text(on_most, plan.block_size(), limit_s); !text.empty()) {
        json["warnings"].push_back(text);
    }
    fmt::print("{}\n", json.dump(2));
    return done;
}

void print_levels(LevelSpec const& levels) {
    std::string text;
    for (auto const place : output::shown_levels(levels)) {
        auto const& level = levels.levels[place];
        text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", levels.shown(level.value));
        text += level.purpose == LevelClass::ordinary ? "" : " (" + name_of(level.purpose) + ")";
    }
    auto const unit = levels.shown_units();
    print_entry("levels", fmt::format("{}{}: {}", levels.measure_label(),
                                      unit.empty() || unit == "1" ? "" : " [" + unit + "]", text));
    if (auto const more = output::left_out_levels(levels); !more.empty()) {
        fmt::print("{:<{}}{}", "", label_width, more);
    }
}

void print_records(CampaignSpec const& spec, bool full) {
    constexpr std::size_t most = 3;
    auto const records = ends_of_records(spec);
    for (auto const& record : std::span(records).first(full ? records.size() : std::min(most, records.size()))) {
        print_entry("record", record);
    }
    if (!full && records.size() > most) {
        print_entry("", "more records: --full");
    }
}

// What is asked: waves, bodies, levels, limits, and what is hardly meant or assumed.
void print_scene(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan,
                 std::optional<HazardCurve> const& hazard, PlanOptions const& options) {
    constexpr std::size_t most_bodies = 8;
    constexpr std::size_t most_outside = 2;
    fmt::print("{} x {} x {} = {}\n", count_text(plan.waves(), "wave"),
               count_text(std::ssize(spec.bodies), "body", "bodies"),
               count_text(std::ssize(spec.levels.levels), "level"), count_text(plan.trials(), "trial"));
    print_entry("waves", spec.source->text());
    for (auto const& remark : spec.source->about().remarks) {
        print_entry("remark", remark);
    }
    print_entry("variation", spec.source->about().variability);
    print_records(spec, options.full);
    fmt::print("{}",
               bodies_text(spec, options.unit.of_campaign(spec), options.full ? spec.bodies.size() : most_bodies));
    print_levels(spec.levels);
    print_limits(spec);
    if (hazard) {
        print_entry("hazard", fmt::format("{}: {}", input.hazard_file(), output::range_text(*hazard)));
    }
    print_entry("tested", validated_range_text(spec, options.full ? spec.bodies.size() : most_outside));
    fmt::print("{}", assumptions_lines(spec, options.full));
    for (auto const& line : warnings_of(spec)) {
        print_entry("warning", line);
    }
    fmt::print("{}", memory_lines(spec, plan));
}

// \return what it found
ProbedCost print_probe(CampaignSpec& spec, Plan const& plan, bool full) {
    auto cost = probe(spec, plan);
    if (full) {
        print_entry("per wave",
                    fmt::format("{:.1f} ms: generation {:.1f} ms, intensity measures {:.1f} ms, {} trials {:.1f} ms",
                                1e3 * cost.wave_s(), 1e3 * cost.generation_s, 1e3 * cost.measures_s,
                                plan.trials_per_wave(), 1e3 * cost.trials_s));
    }
    if (auto const text = output::waves_text(cost.waves, spec.source->about().acceptance, spec.confidence);
        !text.empty()) {
        print_entry("accepted", text);
    }
    if (!cost.none_accepted.empty()) {
        print_entry("warning", no_wave_text(cost));
    }
    if (auto const costs = output::model_costs(cost.models); full && !costs.empty()) {
        print_entry("models", costs);
    }
    return cost;
}

int plan_campaign(PlanOptions const& options) {
    auto const& path = options.campaign;
    options.unit.check();
    validate(!options.ranks || (*options.ranks > 0 && *options.ranks <= most_asked_ranks),
             "--ranks {} (must be 1 to {}). Say on how many ranks it shall run", options.ranks.value_or(0),
             most_asked_ranks);
    auto const limit_s = limit_of(options);
    auto const input = load_campaign(path, options.settings);
    auto spec = parse_campaign(input);
    auto const begin = Clock::now();
    spec.source->prepare(rows_alone);
    double const calibration_s = seconds_since(begin);
    Plan const plan(spec);
    auto const hazard = stated_hazard(input, spec.levels);  // refused before anything is printed
    if (options.json) {
        return print_plan_json(input, spec, plan, calibration_s, hazard, options, limit_s);
    }
    fmt::print("{}\n", spec.title.empty() ? path : spec.title);
    print_scene(input, spec, plan.without_refusals(), hazard, options);
    auto const start = start_of_run(calibration_s);
    auto const cost = print_probe(spec, plan, options.full);
    auto const rare = forecast_rare(spec);
    if (spec.rare) {
        print_entry("rare", rare_text(spec, rare));
    }
    auto const cores = std::max(1U, std::thread::hardware_concurrency());
    auto const estimate = [&](std::int64_t ranks) {
        return estimate_ranks(spec, plan.without_refusals(), seconds_of(start, cost, rare), ranks);
    };
    auto const one = estimate(1);
    print_entry("time", fmt::format("about {} on the {} cores here, {} on one ({}); results file: about {}",
                                    duration_text(estimate(cores).wall_s()), cores, duration_text(one.wall_s()),
                                    parts_text(one), file_text(input, spec, plan.without_refusals())));
    if (options.ranks) {
        print_entry("ranks", ranks_text(estimate(*options.ranks)));
    }
    if (auto const text = too_short_text(estimate(options.ranks.value_or(cores)), plan.block_size(), limit_s);
        !text.empty()) {
        print_entry("warning", text);
    }
    if (options.full) {
        fmt::print("{}", scratch_line(plan.without_refusals()));
    }
    return done;
}

}  // namespace

void add_plan(CommandLine& line) {
    auto verb = line.verb("plan", "check a campaign, count its trials, estimate time and file size");
    auto options = std::make_shared<PlanOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.takes("--set", options->settings, "override keys: waves.count=50 seed=2", "KEY=VALUE ...");
    options->unit.offered_by(verb);
    verb.takes("--ranks", options->ranks, "also estimate time and utilisation for this number of ranks", "N");
    verb.takes("--max-walltime", options->max_walltime,
               "warn where a block does not fit into this time: \"50 min\", 01:00:00; in a Slurm job it is known");
    verb.takes("--json", options->json, "as JSON, in SI");
    verb.takes("--full", options->full, "also list all records, bodies, assumed values, times by model, block files");
    verb.does([options] { return plan_campaign(*options); });
}

}  // namespace overturn::cli
