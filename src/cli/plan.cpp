#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/validated_range.hpp"
#include "campaign/warnings.hpp"
#include "cli/assumptions_told.hpp"
#include "cli/plan_sizes.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "contact/matching.hpp"
#include "core/elapsed.hpp"
#include "output/shown_levels.hpp"
#include "output/stripe_text.hpp"
#include "results/statistics.hpp"
#include "runner/progress.hpp"

namespace overturn::cli {
namespace {

std::string base_text(BasePlan const& base) {
    switch (base.shape) {
        case BaseShape::round:
            return base.continuous() ? std::string("round base on its continuous rim")
                                     : fmt::format("round base, {} points on its rim", base.points);
        case BaseShape::polygon:
            return fmt::format("polygon of {} corners", base.corners_m.size());
        case BaseShape::square:
            break;
    }
    return base.corner_share == 1 ? std::string("square base on its corners")
           : base.corner_share ? fmt::format("square base, {:.4g} of its stiffness on the corners", *base.corner_share)
                               : fmt::format("square base, flat on {} points", base.points);
}

// What base and pad make of the body's restitution.
std::string footing_text(BodySpec const& body) {
    auto const& base = body.footing.base;
    auto const& pad = body.footing.pad;
    auto text = fmt::format("{}, {:g} Hz, {}", base_text(base), pad.vertical_frequency_hz,
                            pad.strength_pa ? fmt::format("{:g} MPa", *pad.strength_pa / 1e6) : "elastic");
    if (base.shape == BaseShape::polygon) {
        return text;
    }
    auto const match = matched_footing(body.body, body.footing);
    constexpr double close = 1e-3;
    return text
           + fmt::format("; rocks with e {:.4f}{}", match.restitution,
                         !pad.match_restitution ? ", its own"
                         : std::abs(match.restitution - body.body.restitution()) > close
                             ? fmt::format(", as near to {:.4f} as it can", body.body.restitution())
                             : "");
}

// Does it slide or rock first? Friction against the slope at which it tips.
std::string friction_text(BodySpec const& body) {
    if (!body.friction) {
        return "no slip";
    }
    double const mu = body.friction->static_coefficient;
    auto const& weaker = body.body.corner(body.body.weaker_side());
    double const slope =
        body.body.lopsided() ? std::tan(weaker.base_angle_rad) : body.body.half_width_m() / body.body.centre_height_m();
    auto const& drawn = body.scatter.friction;
    if (drawn && drawn->scatters() && drawn->lowest() < slope && slope < drawn->highest()) {
        double const below = 0.5 * std::erfc(-drawn->score(slope) / std::sqrt(2.0));
        return fmt::format("friction about {:.4g}, tan(alpha) {:.4g}: slides before it rocks in {:.0f} % of draws", mu,
                           slope, 100 * below);
    }
    auto const compared = fmt::format("friction {:.4g} {} tan(alpha) {:.4g}", mu, mu < slope ? "<" : ">=", slope);
    if (mu < slope) {
        return compared + ": slides before it rocks, not expected to overturn";
    }
    constexpr double near = 1.15;  // up to here slip changes peak rotations by orders of magnitude
    return compared + (mu < near * slope ? ": rocks and slides at once" : ": rocks before it slides");
}

// Which side is the weaker one, whose figures V_Ereq and all others are; empty where both are alike.
std::string placement_text(RigidBody const& body, VelocityUnit const& unit) {
    std::string text;
    if (body.lopsided()) {
        auto const tips = [&](double side) {
            auto const& c = body.corner(side);
            return fmt::format("alpha {:.2f} deg, uplift {:.4g} m/s2, V_Ereq {}", c.alpha_rad * 180 / pi,
                               body.gravity_mps2() * std::tan(c.alpha_rad), unit.text(c.limit_velocity_mps));
        };
        text = fmt::format("towards +x {}; towards -x {}; V_Ereq, alpha, p and e are those of the weaker side, {}x",
                           tips(1), tips(-1), body.weaker_side() > 0 ? '+' : '-');
    }
    if (double const tilt = body.initial_tilt_rad(); tilt != 0) {
        text += fmt::format("{}let go at a tilt of {:.4g} deg, {:.3f} of alpha", text.empty() ? "" : "; ",
                            tilt * 180 / pi, std::abs(tilt) / body.corner(tilt).alpha_rad);
    }
    return text;
}

// The limit states of the user's own, and what they make every trial simulate.
void print_limits(CampaignSpec const& spec) {
    for (auto const& limit : std::span(spec.limits).subspan(1)) {
        fmt::print("limit     {}: {}\n", limit.name, definition_of(limit, spec.limits));
    }
    if (spec.effects.mode == EffectMode::automatic && spec.effects.include != 0) {
        fmt::print("calls     {} in every trial: a limit state asks for what only they tell\n",
                   names_of_effects(spec.effects.include));
    }
}

struct PlanOptions {
    std::string campaign;
    std::vector<std::string> settings;
    VelocityUnit unit;
    bool json = false;
};

// Without the probe, whose times are never the same.
int print_plan_json(CampaignSpec const& spec, Plan const& plan) {
    Json const json{{"title", spec.title},           {"waves", plan.waves()},
                    {"trials", plan.trials()},       {"blocks", plan.blocks()},
                    {"warnings", warnings_of(spec)}, {"assumptions", assumptions_json(spec)}};
    fmt::print("{}\n", json.dump(2));
    return done;
}

void print_bodies(std::vector<BodySpec> const& bodies, VelocityUnit const& unit) {
    for (auto const& body : bodies) {
        fmt::print(
            "body      {}: {:.4g} kg, alpha {:.2f} deg, p {:.4f} rad/s, e {:.4f} (Housner {:.4f}), uplift {:.4g} m/s2, "
            "V_Ereq {}\n",
            body.name, body.body.mass_kg(), body.body.alpha_rad() * 180 / pi, body.body.p_radps(),
            body.body.restitution(), body.body.housner_restitution(), body.body.uplift_acceleration_mps2(),
            unit.text(body.body.limit_velocity_mps()));
        if (auto const text = placement_text(body.body, unit); !text.empty()) {
            fmt::print("placed    {}: {}\n", body.name, text);
        }
        fmt::print("slip      {}: {}\n", body.name, friction_text(body));
        if (body.footing.stated) {
            fmt::print("stands    {}: {}\n", body.name, footing_text(body));
        }
    }
}

void print_levels(LevelSpec const& levels) {
    for (auto const place : output::shown_levels(levels)) {
        auto const& level = levels.levels[place];
        fmt::print("level     {} {}{}\n", levels.measure_name(), levels.text(level.value),
                   level.purpose == LevelClass::ordinary ? "" : "  " + name_of(level.purpose));
    }
    if (auto const more = output::left_out_levels(levels); !more.empty()) {
        fmt::print("levels    {}", more);
    }
}

// What is asked: waves, bodies, levels, limits, and what is hardly meant or assumed.
void print_scene(CampaignSpec const& spec, Plan const& plan, VelocityUnit const& unit) {
    fmt::print("waves     {} ({})\n", plan.waves(), spec.source->about().text);
    fmt::print("differ by {}\n", spec.source->about().variability);
    for (auto const& line : ends_of_records(spec)) {
        fmt::print("record    {}\n", line);
    }
    print_bodies(spec.bodies, unit);
    print_levels(spec.levels);
    print_limits(spec);
    fmt::print("validated {}\n", validated_range_text(spec));
    for (auto const& line : warnings_of(spec)) {
        fmt::print("warning   {}\n", line);
    }
    fmt::print("{}", assumptions_lines(spec));
    fmt::print("trials    {} in {} blocks of {} waves\n", plan.trials(), plan.blocks(), plan.block_size());
    fmt::print("{}", memory_lines(spec, plan));
}

// A timed probe: a few waves, spread over the campaign, whole. \return seconds of all waves on one rank
double print_probe(CampaignSpec const& spec, Plan const& plan) {
    bool const refuses = spec.source->about().acceptance.refuses();
    auto const probes = std::min<std::int64_t>(refuses ? 16 : 4, plan.asked());
    PhaseSeconds seconds;
    TrialRows trials;
    WaveCounts waves;
    auto const begin = Clock::now();
    for (std::int64_t i = 0; i < probes; ++i) {
        auto const wave = plan.without_refusals().number(i * plan.asked() / probes);
        auto const prepared = prepare_wave(spec, plan, wave, seconds);
        append_trials(spec, plan, std::span(&prepared, 1), trials, seconds);
        if (is_tried(spec.source->about().acceptance, prepared.row)) {
            waves.add(prepared.row);
        } else {
            ++waves.refused;
        }
    }
    double const each = seconds_since(begin) / static_cast<double>(probes);
    auto const n = static_cast<double>(probes);
    fmt::print("probe     {:.1f} ms a wave: {:.1f} to make it, {:.1f} to measure it, {:.1f} for its {} trials\n",
               1e3 * each, 1e3 * seconds.waves / n, 1e3 * seconds.measures / n,
               1e3 * (each - (seconds.waves + seconds.measures) / n), plan.trials_per_wave());
    if (auto const text = waves.text(spec.source->about().acceptance, spec.confidence); !text.empty()) {
        fmt::print("probed    {}\n", text);
    }
    fmt::print("rungs     {}\n", output::rung_costs(seconds));
    double const drawn_for_each = refuses ? n / static_cast<double>(std::max<std::int64_t>(1, waves.waves)) : 1;
    return each * drawn_for_each * static_cast<double>(plan.asked());
}

int plan_campaign(PlanOptions const& options) {
    auto const& path = options.campaign;
    (void)options.unit.si();
    auto const input = load_campaign(path, options.settings);
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    if (options.json) {
        return print_plan_json(spec, plan.without_refusals());
    }
    fmt::print("{}\n", spec.title.empty() ? path : spec.title);
    print_scene(spec, plan.without_refusals(), options.unit);
    double const all = print_probe(spec, plan);
    if (spec.rare) {
        fmt::print(
            "rare      {} bodies, {} limit states, {} levels beside the trials: at most {} waves an estimator; "
            "their time and rows are not counted here\n",
            spec.bodies.size(), spec.limits.size(), spec.levels.levels.size(), spec.rare->max_runs);
    }
    auto const cores = std::max(1U, std::thread::hardware_concurrency());
    fmt::print("time      about {} on one rank, {} on the {} cores here\n", duration_text(all),
               duration_text(all / cores), cores);
    fmt::print("{}", size_lines(input, spec, plan.without_refusals()));
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
    verb.does([options] { return plan_campaign(*options); });
}

}  // namespace overturn::cli
