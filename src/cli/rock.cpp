#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/body_spec.hpp"
#include "campaign/warnings.hpp"
#include "cli/history.hpp"
#include "cli/scene_files.hpp"
#include "cli/trial_history.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "motion/drift.hpp"
#include "report/figure.hpp"
#include "response/model_selector.hpp"
#include "response/registry.hpp"

namespace overturn::cli {
namespace {

struct RockOptions {
    RecordOptions record;
    std::string body, effects = "auto", history, plot;
    double scale = 1;
    VelocityUnit unit;
    bool json = false;
};

nlohmann::ordered_json names_json(std::int64_t mask) {
    auto names = nlohmann::ordered_json::array();
    for (auto const& entry : effects()) {
        if (has(static_cast<EffectMask>(mask), entry.value)) {
            names.push_back(entry.name);
        }
    }
    return names;
}

// What never came is null.
nlohmann::ordered_json value_json(std::span<std::byte const> row, Field const& field) {
    if (field.type == FieldType::category) {
        return category_at(row, field);
    }
    if (field.type == FieldType::integer) {
        return integer_at(row, field);
    }
    double const value = real_at(row, field);
    return std::isnan(value) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value);
}

// Quantities that models share are those of the one that ran: the others know nothing of theirs.
void add_own_json(nlohmann::ordered_json& json, ModelSelector const& selector, std::span<std::byte const> own) {
    static constexpr std::array matched{"restitution", "corner_share", "normal_restitution"};
    for (auto const& [traits, offset] : selector.extra_parts()) {
        for (auto const& field : traits->fields) {
            auto& place =
                std::ranges::count(matched, field.name) > 0 ? json["matched"][field.key()] : json[field.key()];
            if (place.is_null()) {
                place = value_json(own.subspan(offset), field);
            }
        }
    }
}

void print_json(BodySpec const& spec, PlacedRecord const& record, Drift const& drift, Response const& response,
                ModelSelector const& selector, std::span<std::byte const> own) {
    nlohmann::ordered_json json;
    for (auto const& field : fields_of<Response>()) {
        json[field.key()] = value_json(bytes_of(response), field);
    }
    json["effects"] = names_json(response.effects);
    json["effects_called"] = names_json(response.called);
    json["overturned"] = entry_of(response.verdict).fell;
    json["response_velocity_mps"] = json["v_resp_mps"];
    json["limit_velocity_mps"] = spec.body.limit_velocity_mps();
    json["restitution"] = spec.body.restitution();
    json["record"] = record_json(record);
    json["residual_velocity_mps"] = drift.end_velocity_mps;
    json["residual_displacement_m"] = drift.end_displacement_m;
    add_own_json(json, selector, own);
    fmt::print("{}\n", json.dump(2));
}

std::string_view summary_of_reason(std::int64_t number) {
    return std::ranges::find(reasons(), number, &ReasonEntry::number)->summary;
}

std::string time_text(double time_s) { return std::isnan(time_s) ? "never" : fmt::format("at {:.3f} s", time_s); }

void print_text(BodySpec const& spec, PlacedRecord const& record, Drift const& drift, Response const& r,
                ModelSelector const& selector, std::span<std::byte const> own, VelocityUnit const& unit) {
    auto const& b = spec.body;
    fmt::print("{}: alpha {:.2f} deg, p {:.4f} rad/s, e {:.4f}, uplift at {:.4g} m/s2, V_Ereq {}\n", spec.name,
               b.alpha_rad() * 180 / pi, b.p_radps(), b.restitution(), b.uplift_acceleration_mps2(),
               unit.text(b.limit_velocity_mps()));
    fmt::print("read as          {}\n", record.read_as());
    for (auto const& claim : record.claims) {
        if (claim.starts_with("left out: ")) {
            fmt::print("left out         {}\n", claim.substr(claim.find(' ', claim.find(':')) + 1));
        }
    }
    for (auto const& line : record.unread) {
        fmt::print("not understood   {}\n", line);
    }
    fmt::print("wave             {}{}\n", drift.text(),
               drift.any_excessive() ? ": its baseline drifts, correct it with --baseline" : "");
    fmt::print("verdict          {}\n", entry_of(r.verdict).name);
    if (std::isnan(r.peak_rotation_rad)) {
        return;  // no model ran it: the error says why
    }
    fmt::print("peak rotation    {:.6g} rad = {:.4g} deg = {:.4f} alpha, {}\n", r.peak_rotation_rad,
               r.peak_rotation_rad * 180 / pi, r.peak_rotation_ratio, time_text(r.time_of_peak_s));
    fmt::print("peak energy      {:.4f} of that of critical uplift\n", r.peak_energy_ratio);
    fmt::print("V_resp           {}\n", unit.text(r.response_velocity_mps));
    fmt::print("first uplift     {}, {} impacts\n", time_text(r.first_uplift_s), r.impacts);
    fmt::print("overturned       {}, off the ground {}\n", time_text(r.overturn_time_s), time_text(r.contact_lost_s));
    fmt::print("slip             {:.6g} m at most, {:.6g} m left\n", r.peak_slip_m, r.residual_slip_m);
    fmt::print("friction demand  {}, least contact force {:.4f} m g\n",
               std::isnan(r.friction_demand) ? "unknown" : fmt::format("{:.4f}", r.friction_demand),
               r.min_contact_force_ratio);
    fmt::print("effects          {} (called for: {}); {}\n", names_of_effects(static_cast<EffectMask>(r.effects)),
               names_of_effects(static_cast<EffectMask>(r.called)), summary_of_reason(r.reason));
    for (auto const& [traits, offset] : selector.extra_parts()) {
        if (traits->number != r.model) {
            continue;
        }
        for (auto const& field : traits->fields) {
            auto const values = own.subspan(offset);
            auto const degrees = field.units == "rad" && std::isfinite(real_at(values, field))
                                     ? fmt::format(" = {:.4g} deg", real_at(values, field) * 180 / pi)
                                     : std::string();
            fmt::print("{:<25}{} {}{}: {}\n", field.name, value_json(values, field).dump(),
                       field.units == "1" ? "" : field.units, degrees, field.description);
        }
    }
}

int rock(RockOptions const& options) {
    validate(std::isfinite(options.scale), "--scale {} (must be finite). Give a factor such as 1.5", options.scale);
    (void)options.unit.si();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    auto const spec = load_body(options.body);
    auto const record = load_motion(options.record);
    validate_rocking_plane(record.direction, {options.record.wave});
    auto const& motion = record.motion;
    note_warnings(warnings_of(spec));
    note_warnings(warnings_of(motion));
    Scene const scene{spec.body, spec.friction, spec.footing, spec.axes};
    auto const request = parse_effects(options.effects);
    if (auto const* const key = spec.planar_key(); key != nullptr) {
        bool const dearer = (request.include & (mask_of(Effect::contact) | mask_of(Effect::spatial))) != 0;
        validate(!dearer && (spec.axes < 2 || motion.transverse_mps2.empty()),
                 "{}: {} beside {} (only rocking and sliding in one plane hold it). Leave one of them out, or state "
                 "axes = 1",
                 options.body, key, dearer ? "the effects contact or spatial" : "a transverse component");
    }
    ModelSelector const selector(request);
    auto const unable = selector.impossible(scene);
    validate(unable == 0,
             "{}: effects {} (no model can simulate {} of this body{}). Leave it out, or state what it needs",
             options.body, options.effects, names_of_effects(unable),
             has(unable, Effect::sliding) ? ": it states no friction" : "");
    note_warnings(warnings_of_stated_effects(spec, motion, request));
    std::vector<std::byte> own(selector.extra_bytes());
    SceneTrial const trial{scene, motion, options.scale};
    if (auto const lost = selector.left_out(trial); lost != 0) {
        note_warnings({fmt::format(
            "{} requires {}, but no model supports it together with the other required effects: it is not simulated",
            spec.name, names_of_effects(lost))});
    }
    std::optional<HistoryFile> history;
    auto response = selector.respond(trial, own);
    response.verdict = MovementSpec{}.verdict(response, spec.body, spec.friction.has_value(), spec.footing.pad);
    if (!options.history.empty()) {
        history.emplace(options.history);
        selector.show(trial, response, *history);
    }
    if (!options.plot.empty()) {
        KeptHistory kept;
        selector.show(trial, response, kept);
        auto const title = fmt::format(
            "{} under {}{}: {}", spec.name, std::filesystem::path(options.record.wave).filename().string(),
            options.scale == 1 ? "" : fmt::format(" times {:g}", options.scale), entry_of(response.verdict).name);
        MeasureSpec const usual;
        draw_history(kept, {title, spec, spec.body, motion, options.scale, &usual}, options.unit, options.plot);
    }
    if (options.json) {
        print_json(spec, record, drift_of(motion), response, selector, own);
    } else {
        print_text(spec, record, drift_of(motion), response, selector, own, options.unit);
    }
    if (response.verdict == Verdict::failed) {
        throw SystemError(fmt::format("no verdict ({}). Check unit and scale", entry_of(response.failure).summary));
    }
    return done;
}

}  // namespace

void add_rock(CommandLine& line) {
    auto verb = line.verb("rock", "one body under one wave");
    auto options = std::make_shared<RockOptions>();
    verb.needs("--body", options->body, "body file (TOML)");
    verb.needs("--wave", options->record.wave, "record, or columns time,a_horizontal[,a_vertical]");
    add_record_options(verb, options->record);
    verb.takes("--scale", options->scale, "factor on every component");
    verb.takes("--effects", options->effects, "auto, none, or a list such as vertical");
    verb.takes("--history", options->history, "write the history to this csv file");
    verb.takes("--plot", options->plot, "draw wave, rotation, energy and contact over time, .svg, .png or .pdf");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "as JSON");
    verb.does([options] { return rock(*options); });
}

}  // namespace overturn::cli
