#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/validated_range.hpp"
#include "campaign/warnings.hpp"
#include "cli/assumptions_told.hpp"
#include "cli/plan_bodies.hpp"
#include "cli/plan_sizes.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/elapsed.hpp"
#include "core/wrapped.hpp"
#include "output/shown_levels.hpp"
#include "output/stripe_text.hpp"
#include "output/waves_text.hpp"
#include "results/statistics.hpp"
#include "runner/probe.hpp"
#include "runner/progress.hpp"

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

struct PlanOptions {
    std::string campaign;
    std::vector<std::string> settings;
    VelocityUnit unit;
    bool json = false;
    bool full = false;
};

// Without the probe, whose times are never the same.
int print_plan_json(CampaignSpec const& spec, Plan const& plan) {
    Json const json{{"title", spec.title},           {"waves", plan.waves()},
                    {"trials", plan.trials()},       {"blocks", plan.blocks()},
                    {"warnings", warnings_of(spec)}, {"assumptions", assumptions_json(spec)}};
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
void print_scene(CampaignSpec const& spec, Plan const& plan, PlanOptions const& options) {
    constexpr std::size_t most_bodies = 8;
    constexpr std::size_t most_outside = 2;
    auto const count = [](std::size_t n, char const* one, char const* more) {
        return fmt::format("{} {}", n, n == 1 ? one : more);
    };
    fmt::print("{} x {} x {} = {} trials\n", count(plan.waves(), "wave", "waves"),
               count(spec.bodies.size(), "body", "bodies"), count(spec.levels.levels.size(), "level", "levels"),
               plan.trials());
    print_entry("waves", spec.source->text());
    print_entry("differ by", spec.source->about().variability);
    print_records(spec, options.full);
    fmt::print("{}", bodies_text(spec, options.unit, options.full ? spec.bodies.size() : most_bodies));
    print_levels(spec.levels);
    print_limits(spec);
    print_entry("validated", validated_range_text(spec, options.full ? spec.bodies.size() : most_outside));
    fmt::print("{}", assumptions_lines(spec, options.full));
    for (auto const& line : warnings_of(spec)) {
        print_entry("warning", line);
    }
    fmt::print("{}", memory_lines(spec, plan));
}

// \return seconds of all waves on one rank
double print_probe(CampaignSpec& spec, Plan const& plan, bool full) {
    auto const cost = probe(spec, plan);
    print_entry("per wave", fmt::format("{:.1f} ms: generation {:.1f}, intensity measures {:.1f}, {} trials {:.1f}",
                                        1e3 * cost.wave_s(), 1e3 * cost.generation_s, 1e3 * cost.measures_s,
                                        plan.trials_per_wave(), 1e3 * cost.trials_s));
    if (auto const text = output::waves_text(cost.waves, spec.source->about().acceptance, spec.confidence);
        !text.empty()) {
        print_entry("accepted", text);
    }
    if (full) {
        print_entry("models", output::model_costs(cost.models));
    }
    return cost.counted_wave_s() * static_cast<double>(plan.asked());
}

int plan_campaign(PlanOptions const& options) {
    auto const& path = options.campaign;
    (void)options.unit.si();
    auto const input = load_campaign(path, options.settings);
    auto const begin = Clock::now();
    auto spec = parse_campaign(input);
    double const start_s = seconds_since(begin);  // calibrations, which every rank makes
    Plan const plan(spec);
    if (options.json) {
        return print_plan_json(spec, plan.without_refusals());
    }
    fmt::print("{}\n", spec.title.empty() ? path : spec.title);
    print_scene(spec, plan.without_refusals(), options);
    double const all = print_probe(spec, plan, options.full);
    if (spec.rare) {
        print_entry("rare", fmt::format("{} bodies, {} limit states, {} levels beside the trials: at most {} waves an "
                                        "estimator; their time and rows are not counted here",
                                        spec.bodies.size(), spec.limits.size(), spec.levels.levels.size(),
                                        spec.rare->max_runs));
    }
    auto const cores = std::max(1U, std::thread::hardware_concurrency());
    print_entry("time", fmt::format("about {} on one rank, {} on the {} cores here", duration_text(start_s + all),
                                    duration_text(start_s + all / cores), cores));
    fmt::print("{}", size_lines(input, spec, plan.without_refusals(), options.full));
    return done;
}

}  // namespace

void add_plan(CommandLine& line) {
    auto verb = line.verb("plan", "check a campaign, count its trials, estimate time and file size");
    auto options = std::make_shared<PlanOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.takes("--set", options->settings, "override a key: waves.count=50");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "counts, warnings and all that is assumed, as JSON");
    verb.takes("--full", options->full, "every record, body, assumed value, model's time and block file too");
    verb.does([options] { return plan_campaign(*options); });
}

}  // namespace overturn::cli
