#include <memory>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/intensity_measure.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/warnings.hpp"
#include "cli/figures.hpp"
#include "cli/overturning_spectrum.hpp"
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

struct SpectrumOptions {
    RecordOptions record;
    std::string body, plot;
    double damping = 0.05;
    VelocityUnit unit;
    OverturningOptions overturning;
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

Measures measure(GroundMotion const& motion, double damping) {
    constexpr double shortest_s = 0.02;
    constexpr double longest_s = 20;
    constexpr std::size_t count = 200;
    auto const periods = log_periods(shortest_s, longest_s, count);
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
                       std::optional<BodyEnergy> const& energy, VelocityUnit const& unit) {
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
    constexpr std::size_t every = 5;
    for (std::size_t i = 0; i < m.response.period_s.size(); i += every) {
        fmt::print("{:>9.4f} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", m.response.period_s[i],
                   m.response.sa_mps2[i], unit.of(m.response.psv_mps[i]), m.response.sd_m[i], unit.of(m.v_e_mps[i]),
                   unit.of(m.v_e0_mps[i]));
    }
    fmt::print("damping {:g}; all {} periods with --json\n", damping, m.response.period_s.size());
}

int show_overturning(SpectrumOptions const& options) {
    auto const& asked = options.overturning;
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
        validate(!asked.pulse.empty(), "--plot (a record's factors have no frequency to be drawn over). Leave it out");
    }
    auto const found = overturning_spectrum(asked, options.record, options.body);
    auto const json = json_of(found);
    if (!options.plot.empty()) {
        report::draw_figure("overturning_figure.py", json, options.plot);
    }
    if (!asked.output.empty()) {
        auto const csv = csv_of(found);
        store::write_durably(asked.output, std::as_bytes(std::span(csv)));
    }
    fmt::print("{}", options.json ? json.dump(2) + "\n" : text_of(found));
    return done;
}

int spectrum(SpectrumOptions const& options) {
    if (options.overturning.asked) {
        return show_overturning(options);
    }
    validate(!options.overturning.states_more(),
             "--pulse, --p, --ratios and the like (they are of an overturning spectrum). State --overturning too");
    validate(!options.record.wave.empty(), "--wave (missing). State a record, or --overturning with a pulse");
    validate(options.damping >= 0 && options.damping < 1,
             "--damping {} (a ratio, 0 to below 1: {} would be {:g} %). Write 0.05 for 5 %", options.damping,
             options.damping, 100 * options.damping);
    (void)options.unit.si();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    auto const record = load_motion(options.record);
    auto const& motion = record.motion;
    note_warnings(warnings_of(motion));
    auto const measures = measure(motion, options.damping);
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
        print_record_text(record, measures, options.damping, energy, options.unit);
    }
    return done;
}

}  // namespace

void add_spectrum(CommandLine& line) {
    auto verb =
        line.verb("spectrum", "response, energy and window energy spectra of one wave, or an overturning spectrum");
    auto options = std::make_shared<SpectrumOptions>();
    verb.takes("--wave", options->record.wave, "record, or columns time,a_horizontal");
    add_record_options(verb, options->record);
    verb.takes("--body", options->body, "body file (TOML): adds its energy measures");
    verb.takes("--damping", options->damping, "damping ratio");
    verb.takes("--plot", options->plot, "draw it: out.svg, .png or .pdf");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "as JSON");
    options->overturning.offered_by(verb);
    verb.does([options] { return spectrum(*options); });
}

}  // namespace overturn::cli
