#include "cli/figures.hpp"

#include <filesystem>

#include "campaign/rocking_band.hpp"
#include "campaign/typed_units.hpp"
#include "spectra/target_input.hpp"

namespace overturn::cli {
namespace {

using report::FigureBody;

FigureBody figure_body(std::string const& name, RigidBody const& body, GroundMotion const& motion,
                       MeasureSpec const& measures) {
    auto const band = rocking_band(body, measures.radius_unit);
    WindowOptions options;
    options.reading = measures.window;
    options.keep_history = true;
    options.panel_phase_rad = measures.panel_phase_rad;
    return {name, body.limit_velocity_mps(), band,
            window_energy(motion.horizontal_mps2, motion.time_step_s, band, options).v_wes_mps};
}

}  // namespace

// The target stands in the campaign's own text.
std::optional<TargetSpectrum> target_of(CampaignInput const& input) {
    auto const waves = config::Table::parse(input.text, input.name, input.settings).child("waves");
    if (waves.text("source") != "spectrum-compatible" || !waves.has("target")) {
        return std::nullopt;
    }
    InputFiles files(input.files);
    return read_target(waves.child("target"), files);
}

report::WaveFigure campaign_wave_figure(CampaignInput const& input, CampaignSpec const& spec,
                                        GeneratedWave const& made) {
    report::WaveFigure figure;
    figure.title = spec.title.empty() ? input.name : spec.title;
    auto const source = spec.source->text();
    bool const named_there = source.find(made.label) != std::string::npos;  // records list their waves
    figure.subtitle = named_there ? made.label : fmt::format("{}: {}", made.label, source);
    figure.motion = made.motion;
    figure.target = target_of(input);
    if (figure.target) {
        figure.damping = figure.target->damping();
        if (spec.source->about().acceptance.rule == "srp-3.7.1") {
            figure.bands = {report::srp_acceptance_band()};
        }
    }
    for (auto const& body : spec.bodies) {
        figure.bodies.push_back(figure_body(body.name, body.body, made.motion, spec.measures));
    }
    return figure;
}

void draw_campaign_wave(CampaignInput const& input, CampaignSpec const& spec, GeneratedWave const& made,
                        output::ShownVelocity const& unit, std::string const& output) {
    auto figure = campaign_wave_figure(input, spec, made);
    auto const typed = typed_units(spec);
    figure.accelerations = {typed.acceleration.symbol, typed.acceleration.si};
    figure.lengths = {typed.length.symbol, typed.length.si};
    figure.velocities = {unit.symbol, unit.si()};
    report::draw_wave(figure, output);
}

void draw_record(std::string const& name, PlacedRecord const& record, double damping,
                 std::optional<BodySpec> const& body, output::ShownVelocity const& unit, std::string const& output) {
    report::WaveFigure figure;
    figure.title = std::filesystem::path(name).filename().string();
    figure.subtitle = record.says;
    figure.motion = record.motion;
    figure.damping = damping;
    figure.velocities = {unit.symbol, unit.si()};
    if (body) {
        figure.bodies = {figure_body(body->name, body->body, record.motion, {})};
    }
    report::draw_wave(figure, output);
}

}  // namespace overturn::cli
