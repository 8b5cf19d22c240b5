#include <memory>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/rocking_band.hpp"
#include "campaign/warnings.hpp"
#include "cli/figures.hpp"
#include "cli/number_grid.hpp"
#include "cli/overturning_spectrum.hpp"
#include "cli/rocking_spectrum.hpp"
#include "cli/scene_files.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "motion/drift.hpp"
#include "motion/intensity.hpp"
#include "output/record_text.hpp"
#include "report/figure.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

constexpr double default_damping = 0.05;

struct SpectrumOptions {
    RecordOptions record;
    std::string body, plot, periods;
    double damping = default_damping;
    VelocityUnit unit;
    OverturningOptions overturning;
    RockingSpectrumOptions rocking;
    bool json = false;
};

std::vector<double> default_periods() {
    constexpr double shortest_s = 0.02;
    constexpr double longest_s = 20;
    constexpr std::size_t count = 200;
    return log_periods(shortest_s, longest_s, count);
}

output::RecordSpectra spectra_of(GroundMotion const& motion, double damping, std::vector<double> const& periods) {
    auto const& a = motion.horizontal_mps2;
    double const dt = motion.time_step_s;
    return {intensity_of(a, dt),
            drift_of(motion),
            damping,
            response_spectrum(a, dt, periods, damping),
            input_energy_velocities(a, dt, periods, damping),
            undamped_energy_velocities(a, dt, periods)};
}

output::BodyEnergy energy_for(BodySpec const& spec, GroundMotion const& motion) {
    auto const band = rocking_band(spec.body);
    return {band, window_energy(motion.horizontal_mps2, motion.time_step_s, band),
            window_energy(motion.horizontal_mps2, motion.time_step_s, band, {.reading = WindowReading::running}),
            spec.body.limit_velocity_mps()};
}

// As figure, csv, text or JSON, of a spectrum that has them all.
template <class Found> int show(Found const& found, char const* figure, SpectrumOptions const& options) {
    auto const json = json_of(found);
    if (!options.plot.empty()) {
        report::draw_figure(figure, json, options.plot);
    }
    if (!options.overturning.output.empty()) {
        store::write_durably(options.overturning.output, csv_of(found));
    }
    fmt::print("{}", options.json ? json.dump(2) + "\n" : text_of(found));
    return done;
}

int show_overturning(SpectrumOptions const& options) {
    auto const& asked = options.overturning;
    validate(options.plot.empty() || !asked.pulse.empty(),
             "--plot (a record's factors have no frequency to be drawn over). Leave it out");
    return show(overturning_spectrum(asked, options.record, options.body), "overturning_figure.py", options);
}

int show_rocking(SpectrumOptions const& options) {
    validate(!options.overturning.has_pulse_or_scan(),
             "--rocking beside --pulse, --p, --ratios and the like (they are of an overturning spectrum). Leave "
             "them out");
    return show(rocking_spectrum(options.rocking, options.record, options.overturning.alpha,
                                 options.overturning.restitution, options.body),
                "rocking_figure.py", options);
}

int spectrum(SpectrumOptions const& options) {
    auto const& [overturning, rocking] = std::tie(options.overturning, options.rocking);
    if (!overturning.output.empty()) {
        store::require_writable(overturning.output);
    }
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    validate(!(overturning.asked || rocking.asked) || (options.periods.empty() && options.damping == default_damping),
             "--periods or --damping (of response spectra). Leave it out, or --overturning and --rocking");
    validate(!overturning.asked || !rocking.asked, "--overturning beside --rocking (two answers). State one of them");
    validate(rocking.asked || rocking.periods.empty(),
             "--rocking-periods (of a rocking spectrum). State --rocking too");
    if (overturning.asked) {
        return show_overturning(options);
    }
    if (rocking.asked) {
        return show_rocking(options);
    }
    validate(!overturning.states_more(),
             "--pulse, --p, --ratios and the like (they are of an overturning spectrum). State --overturning too, or "
             "--rocking");
    validate(!options.record.wave.empty(), "--wave (missing). State a record, or --overturning with a pulse");
    validate(options.damping >= 0 && options.damping < 1,
             "--damping {} (a ratio, 0 to below 1: {} would be {:g} %). Write 0.05 for 5 %", options.damping,
             options.damping, 100 * options.damping);
    options.unit.check();
    validate(options.plot.empty() || options.periods.empty(),
             "--periods beside --plot (the figure has periods of its own). Leave one of them out");
    auto const record = load_motion(options.record);
    auto const& motion = record.motion;
    note_warnings(warnings_of(motion));
    constexpr double shortest_s = 1e-3;
    constexpr double longest_s = 1e3;
    auto spectra = spectra_of(
        motion, options.damping,
        options.periods.empty() ? default_periods() : number_grid(options.periods, "--periods", shortest_s, longest_s));
    spectra.units = output::units_of(record);
    std::optional<BodySpec> body;
    if (!options.body.empty()) {
        validate_rocking_plane(record.direction, {options.record.wave});
        body = load_body(options.body);
        note_warnings(warnings_of(*body));
        spectra.energy = energy_for(*body, motion);
        spectra.units = output::units_of(record, body->units);
    }
    auto const velocity = options.unit.beside(spectra.units);
    if (!options.plot.empty()) {
        draw_record(options.record.wave, record, options.damping, body, velocity, options.plot);
    }
    if (options.json) {
        fmt::print("{}\n", output::json_of(record, spectra).dump(2));
    } else {
        constexpr std::size_t every_fifth = 5;
        fmt::print("{}", output::text_of(record, spectra, velocity, options.periods.empty() ? every_fifth : 1));
    }
    return done;
}

}  // namespace

void add_spectrum(CommandLine& line) {
    auto verb = line.verb("spectrum", "spectra of one wave; overturning spectrum; rocking spectrum");
    auto options = std::make_shared<SpectrumOptions>();
    verb.takes("--wave", options->record.wave, "record, or columns time,a_horizontal");
    add_record_options(verb, options->record);
    verb.takes("--body", options->body, "body file (TOML): adds its energy measures");
    verb.takes("--damping", options->damping, "damping ratio");
    verb.takes("--periods", options->periods,
               "of the response spectra [s]: 0.5,1,2 or first:last:count; default 0.02:20:200");
    verb.takes("--plot", options->plot, "draw it: out.svg, .png or .pdf");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "as JSON");
    options->overturning.offered_by(verb);
    options->rocking.offered_by(verb);
    verb.does([options] { return spectrum(*options); });
}

}  // namespace overturn::cli
