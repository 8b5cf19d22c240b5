#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "cli/history.hpp"
#include "cli/scene_files.hpp"
#include "cli/verbs.hpp"

namespace overturn::cli {
namespace {

struct Options {
    RecordOptions record;
    std::string body, effects = "auto", history;
    double scale = 1;
    bool json = false;
};

void print_json(BodySpec const& spec, Response const& response) {
    auto const& r = response.rocking;
    nlohmann::ordered_json json{{"verdict", verdict_names()[static_cast<std::size_t>(r.verdict)]},
                                {"overturned", r.verdict == Verdict::overturned},
                                {"peak_rotation_rad", r.peak_rotation_rad},
                                {"peak_rotation_ratio", r.peak_rotation_rad / spec.body.alpha_rad()},
                                {"peak_energy_ratio", r.peak_energy_ratio},
                                {"time_of_peak_s", r.time_of_peak_s},
                                {"overturn_time_s", r.overturn_time_s},
                                {"first_uplift_s", r.first_uplift_s},
                                {"impacts", r.impacts},
                                {"peak_slip_m", r.peak_slip_m},
                                {"residual_slip_m", r.residual_slip_m},
                                {"friction_demand", r.friction_demand},
                                {"min_contact_force_ratio", r.min_contact_force_ratio},
                                {"contact_lost_s", r.contact_lost_s},
                                {"response_velocity_mps", response.response_velocity_mps},
                                {"limit_velocity_mps", spec.body.limit_velocity_mps()},
                                {"effects", nlohmann::ordered_json::array()},
                                {"restitution", spec.body.restitution()}};
    for (auto const& entry : effects()) {
        if (has(response.effects, entry.value)) {
            json["effects"].push_back(entry.name);
        }
    }
    fmt::print("{}\n", json.dump(2));
}

std::string time_text(double time_s) { return time_s < 0 ? "never" : fmt::format("at {:.3f} s", time_s); }

void print_text(BodySpec const& spec, Response const& response) {
    auto const& r = response.rocking;
    auto const& b = spec.body;
    fmt::print("{}: alpha {:.2f} deg, p {:.4f} rad/s, e {:.4f}, uplift at {:.4g} m/s2, V_Ereq {:.4f} m/s\n", spec.name,
               b.alpha_rad() * 180 / pi, b.p_radps(), b.restitution(), b.uplift_acceleration_mps2(),
               b.limit_velocity_mps());
    fmt::print("verdict          {}\n", verdict_names()[static_cast<std::size_t>(r.verdict)]);
    fmt::print("peak rotation    {:.6g} rad = {:.4f} alpha, {}\n", r.peak_rotation_rad,
               r.peak_rotation_rad / b.alpha_rad(), time_text(r.time_of_peak_s));
    fmt::print("peak energy      {:.4f} of that of critical uplift\n", r.peak_energy_ratio);
    fmt::print("V_resp           {:.4f} m/s\n", response.response_velocity_mps);
    fmt::print("first uplift     {}, {} impacts\n", time_text(r.first_uplift_s), r.impacts);
    fmt::print("overturned       {}, contact lost {}\n", time_text(r.overturn_time_s), time_text(r.contact_lost_s));
    fmt::print("slip             {:.6g} m at most, {:.6g} m left\n", r.peak_slip_m, r.residual_slip_m);
    fmt::print("friction demand  {:.4f}, least contact force {:.4f} m g\n", r.friction_demand,
               r.min_contact_force_ratio);
    fmt::print("effects          {} (called for: {})\n", names_of_effects(response.effects),
               names_of_effects(response.called));
}

int rock(Options const& options) {
    validate(std::isfinite(options.scale), "--scale {} (must be finite). Give a factor such as 1.5", options.scale);
    auto const spec = load_body(options.body);
    auto const record = load_motion(options.record);
    validate_rocking_plane(record.direction, {options.record.wave});
    auto const& motion = record.motion;
    Scene const scene{spec.body, spec.friction, parse_effects(options.effects), {}};
    std::optional<HistoryFile> history;
    auto const response = respond(scene, motion, options.scale);
    if (!options.history.empty()) {
        history.emplace(options.history);
        (void)respond(scene, motion, options.scale, {}, &*history);
    }
    options.json ? print_json(spec, response) : print_text(spec, response);
    if (response.rocking.verdict == Verdict::failed) {
        throw SystemError(
            "no verdict (the shaking is absurdly strong, or no step was short enough). Check unit and scale");
    }
    return done;
}

}  // namespace

void add_rock(CommandLine& line) {
    auto verb = line.verb("rock", "one body under one wave");
    auto options = std::make_shared<Options>();
    verb.needs("--body", options->body, "body file (TOML)");
    verb.needs("--wave", options->record.wave, "record, or columns time,a_horizontal[,a_vertical]");
    add_record_options(verb, options->record);
    verb.takes("--scale", options->scale, "factor on every component");
    verb.takes("--effects", options->effects, "auto, none, or a list such as vertical");
    verb.takes("--history", options->history, "write the history to this csv file");
    verb.takes("--json", options->json, "as JSON");
    verb.does([options] { return rock(*options); });
}

}  // namespace overturn::cli
