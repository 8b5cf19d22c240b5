#include "output/record_text.hpp"

#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "campaign/typed_units.hpp"
#include "core/field.hpp"
#include "core/units.hpp"
#include "core/wrapped.hpp"
#include "motion/column_unit.hpp"

namespace overturn::output {

std::string key_of(IntensityMeasure const& measure) {
    return Field{std::string(measure.name), measure.units(), {}}.key();
}

TypedUnits units_of(PlacedRecord const& record, TypedUnits const& body) {
    auto units = body;
    if (body.acceleration.symbol == TypedUnits().acceleration.symbol) {
        units.acceleration = unit_named(name_of_acceleration_unit(record.unit_mps2), Dimension::acceleration)
                                 .value_or(body.acceleration);
    }
    return units;
}

namespace {

// Of the ground: lengths in the body's unit, not in that of small slips.
IntensityUnit unit_of_ground(TypedUnits const& units, std::string const& si) {
    return si == "m" ? units.length : shown_unit(units, si);
}

Json stated_values(std::vector<double> const& si, IntensityUnit const& unit) {
    auto values = Json::array();
    for (double const value : si) {
        values.push_back(unit.of(value));
    }
    return {{"value", std::move(values)}, {"unit", unit.symbol}};
}

Json stated_of(GroundMotion const& motion, RecordSpectra const& spectra) {
    auto const& [acceleration, velocity, length] =
        std::tie(spectra.units.acceleration, spectra.units.velocity, spectra.units.length);
    Json stated{{"pga", stated_json(spectra.intensity.pga_mps2, acceleration)},
                {"pgv", stated_json(spectra.intensity.pgv_mps, velocity)},
                {"pgd", stated_json(spectra.intensity.pgd_m, length)},
                {"arias", stated_json(spectra.intensity.arias_mps, velocity)},
                {"residual_velocity", stated_json(spectra.drift.end_velocity_mps, velocity)},
                {"residual_displacement", stated_json(spectra.drift.end_displacement_m, length)},
                {"sa", stated_values(spectra.response.sa_mps2, acceleration)},
                {"sv", stated_values(spectra.response.sv_mps, velocity)},
                {"sd", stated_values(spectra.response.sd_m, length)},
                {"psa", stated_values(spectra.response.psa_mps2, acceleration)},
                {"psv", stated_values(spectra.response.psv_mps, velocity)},
                {"v_e", stated_values(spectra.v_e_mps, velocity)},
                {"v_e0", stated_values(spectra.v_e0_mps, velocity)}};
    for (auto const& [measure, value] : measures_of(motion)) {
        stated[std::string(measure->name)] = stated_json(value, unit_of_ground(spectra.units, measure->units()));
    }
    return stated;
}

Json stated_of(BodyEnergy const& energy, IntensityUnit const& velocity) {
    return {{"ou_v_e", stated_json(energy.restarted.ou_v_e_mps, velocity)},
            {"v_wes", stated_json(energy.restarted.v_wes_max_mps, velocity)},
            {"v_wes_running", stated_json(energy.running.v_wes_max_mps, velocity)},
            {"v_ereq", stated_json(energy.v_ereq_mps, velocity)}};
}

}  // namespace

Json record_json(PlacedRecord const& record) {
    return {{"format", record.format},
            {"components", record.components},
            {"unit", name_of_acceleration_unit(record.unit_mps2)},
            {"time_step_s", record.motion.time_step_s},
            {"samples", record.motion.samples()},
            {"duration_s", record.motion.duration_s()},
            {"used", record.says},
            {"statements", record.statements},
            {"not_understood", record.unread}};
}

Json json_of(PlacedRecord const& record, RecordSpectra const& spectra) {
    Json json{{"record", record_json(record)},
              {"pga_mps2", spectra.intensity.pga_mps2},
              {"pgv_mps", spectra.intensity.pgv_mps},
              {"pgd_m", spectra.intensity.pgd_m},
              {"arias_mps", spectra.intensity.arias_mps},
              {"residual_velocity_mps", spectra.drift.end_velocity_mps},
              {"residual_displacement_m", spectra.drift.end_displacement_m},
              {"residual_velocity_over_pgv", spectra.drift.share()},
              {"damping", spectra.damping},
              {"period_s", spectra.response.period_s},
              {"sa_mps2", spectra.response.sa_mps2},
              {"sv_mps", spectra.response.sv_mps},
              {"sd_m", spectra.response.sd_m},
              {"psa_mps2", spectra.response.psa_mps2},
              {"psv_mps", spectra.response.psv_mps},
              {"v_e_mps", spectra.v_e_mps},
              {"v_e0_mps", spectra.v_e0_mps}};
    for (auto const& [measure, value] : measures_of(record.motion)) {
        json[key_of(*measure)] = value;
    }
    json["stated"] = stated_of(record.motion, spectra);
    if (auto const& energy = spectra.energy) {
        json["energy"] = {{"t0_s", energy->band.t0_s},
                          {"t1_s", energy->band.t1_s},
                          {"ou_v_e_mps", energy->restarted.ou_v_e_mps},
                          {"v_wes_mps", energy->restarted.v_wes_max_mps},
                          {"v_wes_time_s", energy->restarted.v_wes_time_s},
                          {"v_wes_running_mps", energy->running.v_wes_max_mps},
                          {"v_wes_running_time_s", energy->running.v_wes_time_s},
                          {"v_ereq_mps", energy->v_ereq_mps},
                          {"v_wes_safe", energy->restarted.v_wes_max_mps < energy->v_ereq_mps},
                          {"ou_v_e_safe", energy->restarted.ou_v_e_mps < energy->v_ereq_mps}};
        json["energy"]["stated"] = stated_of(*energy, spectra.units.velocity);
    }
    return json;
}

std::string text_of(PlacedRecord const& record, RecordSpectra const& spectra, ShownVelocity const& unit,
                    std::size_t every) {
    auto const& symbol = unit.symbol;
    auto const& [acceleration, length] = std::tie(spectra.units.acceleration, spectra.units.length);
    auto units = spectra.units;
    units.velocity = {symbol, unit.si()};
    auto text = fmt::format("read as {}\n", record.read_as());
    for (auto const& statement : record.statements) {
        text += fmt::format("by its text, {}\n", statement);
    }
    for (auto const& line : record.unread) {
        text += fmt::format("not understood, {}\n", line);
    }
    text += fmt::format("PGA {:.6g} m/s2 = {:.2f} gal = {:.4g} g, PGV {:.5g} {}, PGD {:.5g} {}, Arias {:.5g} {}\n",
                        spectra.intensity.pga_mps2, 100 * spectra.intensity.pga_mps2,
                        spectra.intensity.pga_mps2 / unit_factor("g", Dimension::acceleration),
                        unit.of(spectra.intensity.pgv_mps), symbol, length.of(spectra.intensity.pgd_m), length.symbol,
                        unit.of(spectra.intensity.arias_mps), symbol);
    std::string further;
    for (auto const& [measure, value] : measures_of(record.motion)) {
        auto const shown = unit_of_ground(units, measure->units());
        further +=
            fmt::format("{}{} {:.5g} {}", further.empty() ? "" : ", ", measure->title, shown.of(value), shown.symbol);
    }
    text += fmt::format("{}\n", further);
    text += fmt::format("{}{}\n", spectra.drift.text(motion_units(units)),
                        spectra.drift.excessive() ? ": its baseline drifts, correct it with --baseline" : "");
    if (auto const& energy = spectra.energy) {
        auto const verdict = [&](double v) { return v < energy->v_ereq_mps ? "predicted safe" : "predicted unsafe"; };
        text += fmt::format("T0 {:.4f} s, T1 {:.4f} s, V_Ereq {:.4f} {}\n", energy->band.t0_s, energy->band.t1_s,
                            unit.of(energy->v_ereq_mps), symbol);
        text += fmt::format("ouV_E {:.4f} {}: {}\n", unit.of(energy->restarted.ou_v_e_mps), symbol,
                            verdict(energy->restarted.ou_v_e_mps));
        text += fmt::format("V_WES {:.4f} {} at {:.2f} s: {} (running window: {:.4f} {})\n",
                            unit.of(energy->restarted.v_wes_max_mps), symbol, energy->restarted.v_wes_time_s,
                            verdict(energy->restarted.v_wes_max_mps), unit.of(energy->running.v_wes_max_mps), symbol);
        text += "these predictions can be false: overturn rock computes whether the body overturns under this wave\n";
    }
    text = narrowed(text);
    text += fmt::format("\n{:>9} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "period s", "Sa " + acceleration.symbol,
                        "pSv " + symbol, "Sd " + length.symbol, "V_E " + symbol, "V_E0 " + symbol);
    for (std::size_t i = 0; i < spectra.response.period_s.size(); i += every) {
        text +=
            fmt::format("{:>9.4f} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", spectra.response.period_s[i],
                        acceleration.of(spectra.response.sa_mps2[i]), unit.of(spectra.response.psv_mps[i]),
                        length.of(spectra.response.sd_m[i]), unit.of(spectra.v_e_mps[i]), unit.of(spectra.v_e0_mps[i]));
    }
    text +=
        fmt::format("damping {:g}{}\n", spectra.damping,
                    every == 1 ? "" : fmt::format("; all {} periods with --json", spectra.response.period_s.size()));
    return text;
}

}  // namespace overturn::output
