#include <memory>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/intensity_measure.hpp"
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

struct Measures {
    Intensity intensity;
    Drift drift;
    ResponseSpectrum response;
    std::vector<double> v_e_mps, v_e0_mps;
};

struct BodyEnergy {
    PeriodBand band;
    WindowEnergy restarted, running;
    double v_ereq_mps;
};

std::vector<double> default_periods() {
    constexpr double shortest_s = 0.02;
    constexpr double longest_s = 20;
    constexpr std::size_t count = 200;
    return log_periods(shortest_s, longest_s, count);
}

Measures measure(GroundMotion const& motion, double damping, std::vector<double> const& periods) {
    auto const& a = motion.horizontal_mps2;
    double const dt = motion.time_step_s;
    return {intensity_of(a, dt), drift_of(motion), response_spectrum(a, dt, periods, damping),
            input_energy_velocities(a, dt, periods, damping), undamped_energy_velocities(a, dt, periods)};
}

BodyEnergy energy_for(BodySpec const& spec, GroundMotion const& motion) {
    auto const band = rocking_band(spec.body);
    return {band, window_energy(motion.horizontal_mps2, motion.time_step_s, band),
            window_energy(motion.horizontal_mps2, motion.time_step_s, band, {.reading = WindowReading::running}),
            spec.body.limit_velocity_mps()};
}

void print_record_json(PlacedRecord const& record, Measures const& m, double damping,
                       std::optional<BodyEnergy> const& energy) {
    nlohmann::ordered_json json{{"record", record_json(record)},
                                {"pga", m.intensity.pga_mps2},
                                {"pgv", m.intensity.pgv_mps},
                                {"pgd", m.intensity.pgd_m},
                                {"arias", m.intensity.arias_mps},
                                {"residual_velocity", m.drift.end_velocity_mps},
                                {"residual_displacement", m.drift.end_displacement_m},
                                {"residual_velocity_over_pgv", m.drift.share()},
                                {"units",
                                 {{"pga", "m/s2"},
                                  {"pgv", "m/s"},
                                  {"pgd", "m"},
                                  {"arias", "m/s"},
                                  {"residual_velocity", "m/s"},
                                  {"residual_displacement", "m"},
                                  {"residual_velocity_over_pgv", "1"}}},
                                {"damping", damping},
                                {"period_s", m.response.period_s},
                                {"sa_mps2", m.response.sa_mps2},
                                {"sv_mps", m.response.sv_mps},
                                {"sd_m", m.response.sd_m},
                                {"psa_mps2", m.response.psa_mps2},
                                {"psv_mps", m.response.psv_mps},
                                {"v_e_mps", m.v_e_mps},
                                {"v_e0_mps", m.v_e0_mps}};
    for (auto const& [measure, value] : measures_of(record.motion)) {
        json[std::string(measure->name)] = value;
        json["units"][std::string(measure->name)] = measure->units();
    }
    if (energy) {
        json["energy"] = {{"T0_s", energy->band.t0_s},
                          {"T1_s", energy->band.t1_s},
                          {"ou_v_e_mps", energy->restarted.ou_v_e_mps},
                          {"v_wes_max_mps", energy->restarted.v_wes_max_mps},
                          {"v_wes_time_s", energy->restarted.v_wes_time_s},
                          {"v_wes_running_max_mps", energy->running.v_wes_max_mps},
                          {"v_wes_running_time_s", energy->running.v_wes_time_s},
                          {"v_ereq_mps", energy->v_ereq_mps},
                          {"v_wes_safe", energy->restarted.v_wes_max_mps < energy->v_ereq_mps},
                          {"ou_v_e_safe", energy->restarted.ou_v_e_mps < energy->v_ereq_mps}};
    }
    fmt::print("{}\n", json.dump(2));
}

void print_record_text(PlacedRecord const& record, Measures const& m, double damping,
                       std::optional<BodyEnergy> const& energy, VelocityUnit const& unit, std::size_t every) {
    auto const& symbol = unit.symbol;
    fmt::print("read as {}\n", record.read_as());
    for (auto const& claim : record.claims) {
        fmt::print("by its text, {}\n", claim);
    }
    for (auto const& line : record.unread) {
        fmt::print("not understood, {}\n", line);
    }
    fmt::print("PGA {:.6g} m/s2 = {:.2f} gal, PGV {:.5g} {}, PGD {:.5g} m, Arias {:.5g} m/s\n", m.intensity.pga_mps2,
               100 * m.intensity.pga_mps2, unit.of(m.intensity.pgv_mps), symbol, m.intensity.pgd_m,
               m.intensity.arias_mps);
    std::string further;
    for (auto const& [measure, value] : measures_of(record.motion)) {
        further += fmt::format("{}{} {:.5g} {}", further.empty() ? "" : ", ", measure->title, value, measure->units());
    }
    fmt::print("{}\n", further);
    fmt::print("{}{}\n", m.drift.text(),
               m.drift.excessive() ? ": its baseline drifts, correct it with --baseline" : "");
    if (energy) {
        auto const verdict = [&](double v) { return v < energy->v_ereq_mps ? "does not overturn" : "may overturn"; };
        fmt::print("T0 {:.4f} s, T1 {:.4f} s, V_Ereq {:.4f} {}\n", energy->band.t0_s, energy->band.t1_s,
                   unit.of(energy->v_ereq_mps), symbol);
        fmt::print("ouV_E {:.4f} {}: {}\n", unit.of(energy->restarted.ou_v_e_mps), symbol,
                   verdict(energy->restarted.ou_v_e_mps));
        fmt::print("V_WES {:.4f} {} at {:.2f} s: {} (running window: {:.4f} {})\n",
                   unit.of(energy->restarted.v_wes_max_mps), symbol, energy->restarted.v_wes_time_s,
                   verdict(energy->restarted.v_wes_max_mps), unit.of(energy->running.v_wes_max_mps), symbol);
    }
    fmt::print("\n{:>9} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "period s", "Sa m/s2", "pSv " + symbol, "Sd m",
               "V_E " + symbol, "V_E0 " + symbol);
    for (std::size_t i = 0; i < m.response.period_s.size(); i += every) {
        fmt::print("{:>9.4f} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", m.response.period_s[i],
                   m.response.sa_mps2[i], unit.of(m.response.psv_mps[i]), m.response.sd_m[i], unit.of(m.v_e_mps[i]),
                   unit.of(m.v_e0_mps[i]));
    }
    fmt::print("damping {:g}{}\n", damping,
               every == 1 ? "" : fmt::format("; all {} periods with --json", m.response.period_s.size()));
}

// As figure, csv, text or JSON, of a spectrum that has them all.
template <class Found> int show(Found const& found, char const* figure, SpectrumOptions const& options) {
    auto const json = json_of(found);
    if (!options.plot.empty()) {
        report::draw_figure(figure, json, options.plot);
    }
    if (!options.overturning.output.empty()) {
        auto const csv = csv_of(found);
        store::write_durably(options.overturning.output, std::as_bytes(std::span(csv)));
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
    (void)options.unit.si();
    validate(options.plot.empty() || options.periods.empty(),
             "--periods beside --plot (the figure has periods of its own). Leave one of them out");
    auto const record = load_motion(options.record);
    auto const& motion = record.motion;
    note_warnings(warnings_of(motion));
    constexpr double shortest_s = 1e-3;
    constexpr double longest_s = 1e3;
    auto const measures = measure(
        motion, options.damping,
        options.periods.empty() ? default_periods() : number_grid(options.periods, "--periods", shortest_s, longest_s));
    std::optional<BodySpec> body;
    std::optional<BodyEnergy> energy;
    if (!options.body.empty()) {
        validate_rocking_plane(record.direction, {options.record.wave});
        body = load_body(options.body);
        note_warnings(warnings_of(*body));
        energy = energy_for(*body, motion);
    }
    if (!options.plot.empty()) {
        draw_record(options.record.wave, record, options.damping, body, options.unit, options.plot);
    }
    if (options.json) {
        print_record_json(record, measures, options.damping, energy);
    } else {
        constexpr std::size_t every_fifth = 5;
        print_record_text(record, measures, options.damping, energy, options.unit,
                          options.periods.empty() ? every_fifth : 1);
    }
    return done;
}

}  // namespace

void add_spectrum(CommandLine& line) {
    auto verb = line.verb(
        "spectrum", "response, energy and window energy spectra of one wave, or an overturning or rocking spectrum");
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
