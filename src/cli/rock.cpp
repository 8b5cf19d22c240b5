#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "campaign/body_spec.hpp"
#include "campaign/warnings.hpp"
#include "cli/history.hpp"
#include "cli/scene_files.hpp"
#include "cli/trial_history.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "motion/drift.hpp"
#include "output/record_text.hpp"
#include "output/response_text.hpp"
#include "report/figure.hpp"
#include "response/model_selector.hpp"

namespace overturn::cli {
namespace {

struct RockOptions {
    RecordOptions record;
    std::string body, effects = "auto", history, plot;
    double scale = 1;
    VelocityUnit unit;
    bool json = false;
};

int rock(RockOptions const& options) {
    validate(std::isfinite(options.scale), "--scale {} (must be finite). Give a factor such as 1.5", options.scale);
    options.unit.check();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    auto spec = load_body(options.body);
    auto const record = load_motion(options.record);
    spec.units = output::units_of(record, spec.units);
    auto const velocity = options.unit.beside(spec.units);
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
    std::vector<std::byte> extra(selector.extra_bytes());
    SceneTrial const trial{scene, motion, options.scale};
    if (auto const lost = selector.left_out(trial); lost != 0) {
        note_warnings({fmt::format(
            "{} requires {}, but no model supports it together with the other required effects: it is not simulated",
            spec.name, names_of_effects(lost))});
    }
    std::optional<HistoryFile> history;
    auto response = selector.respond(trial, extra);
    response.verdict = MovementSpec{}.verdict(response, spec.body, spec.friction.has_value(), spec.footing.pad,
                                              selector.extra_value(response, "peak_rise", extra));
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
        draw_history(kept, {title, spec, spec.body, motion, options.scale, &usual}, {{"velocity", velocity.json()}},
                     options.plot);
    }
    output::OneResponse const answer{spec, record, drift_of(motion), response, selector, extra};
    if (options.json) {
        fmt::print("{}\n", output::json_of(answer).dump(2));
    } else {
        fmt::print("{}", output::text_of(answer, velocity));
    }
    if (response.verdict == Verdict::failed) {
        throw SystemError(fmt::format("no verdict ({}). Check unit and scale", entry_of(response.failure).summary));
    }
    return done;
}

}  // namespace

void add_rock(CommandLine& line) {
    auto verb = line.verb("rock", "compute one body under one wave");
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
