#include <cstddef>
#include <cstring>

#include "campaign/results.hpp"

// offsetof on these plain structs is exact; the rows travel by it.
#define OVERTURN_COLUMN(row, field, name, units, type, description)                 \
    store::ColumnSpec {                                                             \
        name, units, description, store::ColumnType::type, offsetof(row, field), {} \
    }

namespace overturn {

std::vector<std::string> verdict_names() {
    return {"at-rest", "slid", "rocked", "overturned", "contact-lost", "failed"};
}

std::vector<std::string> failure_names() {
    return {"none", "wave-failed", "wave-cannot-be-scaled", "no-convergence", "absurd-level", "wave-not-accepted"};
}

std::vector<std::string> rung_names() { return {"at-rest", "rocking", "sliding"}; }

store::TableSpec trial_table() {
    using Row = TrialRow;
    store::TableSpec spec{
        "trials",
        sizeof(Row),
        {OVERTURN_COLUMN(Row, wave, "wave", "1", integer, "id of the wave, as in /waves/id"),
         OVERTURN_COLUMN(Row, body, "body", "1", integer, "number of the body, in the campaign's order from 0"),
         OVERTURN_COLUMN(Row, level, "level", "1", integer, "number of the level, rising from 0"),
         OVERTURN_COLUMN(Row, amplitude, "amplitude", "SI unit of the level's measure", real,
                         "value of the level (attribute level_measure of the file)"),
         OVERTURN_COLUMN(Row, scale, "scale", "1", real, "factor on the wave that brings it to the level"),
         OVERTURN_COLUMN(Row, mass_kg, "mass", "kg", real, "mass as drawn for the wave"),
         OVERTURN_COLUMN(Row, centre_height_m, "centre_height", "m", real,
                         "height of the centre of gravity as drawn for the wave"),
         OVERTURN_COLUMN(Row, restitution, "restitution", "1", real,
                         "angular velocity after over before an impact, as drawn for the wave"),
         OVERTURN_COLUMN(Row, static_friction, "static_friction", "1", real,
                         "static coefficient as drawn for the wave; -1: no slip"),
         OVERTURN_COLUMN(Row, kinetic_friction, "kinetic_friction", "1", real,
                         "kinetic coefficient as drawn for the wave; -1: no slip"),
         OVERTURN_COLUMN(Row, verdict, "verdict", "1", category, "how the trial ended"),
         OVERTURN_COLUMN(Row, failure, "failure", "1", category, "why a failed trial has no verdict"),
         OVERTURN_COLUMN(Row, peak_rotation_rad, "peak_rotation", "rad", real, "max |theta|; pi/2 if overturned"),
         OVERTURN_COLUMN(Row, peak_rotation_ratio, "peak_rotation_ratio", "1", real, "max |theta| / alpha"),
         OVERTURN_COLUMN(Row, time_of_peak_s, "time_of_peak", "s", real, "time of max |theta|; -1: never moved"),
         OVERTURN_COLUMN(Row, peak_energy_ratio, "peak_energy_ratio", "1", real,
                         "max of rocking energy over the energy of critical uplift m g (R - h)"),
         OVERTURN_COLUMN(Row, overturn_time_s, "overturn_time", "s", real,
                         "time of |theta| = pi/2; -1: not overturned"),
         OVERTURN_COLUMN(Row, first_uplift_s, "first_uplift", "s", real, "time of the first uplift; -1: never"),
         OVERTURN_COLUMN(Row, impacts, "impacts", "1", integer, "base impacts, without the bouncing that settles"),
         OVERTURN_COLUMN(Row, friction_demand, "friction_demand", "1", real,
                         "max |F| / N that no slip needs; the static coefficient itself once the body has slipped"),
         OVERTURN_COLUMN(Row, min_contact_force_ratio, "min_contact_force_ratio", "1", real, "min N / (m g)"),
         OVERTURN_COLUMN(Row, contact_lost_s, "contact_lost_time", "s", real, "first time of N <= 0; -1: never"),
         OVERTURN_COLUMN(Row, peak_slip_m, "peak_slip", "m", real, "max |slip| of the base"),
         OVERTURN_COLUMN(Row, residual_slip_m, "residual_slip", "m", real, "slip at the end"),
         OVERTURN_COLUMN(Row, friction_work_jpkg, "friction_work", "J/kg", real, "work lost in slip, over the mass"),
         OVERTURN_COLUMN(Row, v_wes_mps, "v_wes", "m/s", real,
                         "max over time of the window energy spectrum at this level"),
         OVERTURN_COLUMN(Row, ou_v_e_mps, "ou_v_e", "m/s", real, "Akiyama's ouV_E at this level"),
         OVERTURN_COLUMN(Row, v_ereq_mps, "v_ereq", "m/s", real, "limit velocity sqrt(2 g (R - h)) of the body"),
         OVERTURN_COLUMN(Row, v_resp_mps, "v_resp", "m/s", real,
                         "response velocity of the peak rotation, at most V_Ereq"),
         OVERTURN_COLUMN(Row, v_wes_safe, "v_wes_safe", "1", integer, "1: V_WES < V_Ereq says it does not overturn"),
         OVERTURN_COLUMN(Row, ou_v_e_safe, "ou_v_e_safe", "1", integer, "1: ouV_E < V_Ereq says it does not overturn"),
         OVERTURN_COLUMN(Row, effects, "effects", "1", integer, "bit mask of effects that ran: 1 vertical, 2 sliding"),
         OVERTURN_COLUMN(Row, effects_called, "effects_called", "1", integer,
                         "bit mask of effects that the monitors say would act"),
         OVERTURN_COLUMN(Row, rung, "rung", "1", category, "the highest model that ran for this trial"),
         OVERTURN_COLUMN(Row, steps, "steps", "1", integer, "series evaluated")}};
    for (auto& column : spec.columns) {
        if (column.name == "verdict") {
            column.categories = verdict_names();
        } else if (column.name == "failure") {
            column.categories = failure_names();
        } else if (column.name == "rung") {
            column.categories = rung_names();
        }
    }
    return spec;
}

store::TableSpec wave_table() {
    using Row = WaveRow;
    return {
        "waves",
        sizeof(Row),
        {OVERTURN_COLUMN(Row, id, "id", "1", integer, "identity of the wave in every random stream"),
         OVERTURN_COLUMN(Row, failed, "failed", "1", integer, "1: the wave could not be made"),
         OVERTURN_COLUMN(Row, duration_s, "duration", "s", real, "from the first to the last sample"),
         OVERTURN_COLUMN(Row, pga_mps2, "pga", "m/s2", real, "peak horizontal acceleration"),
         OVERTURN_COLUMN(Row, pgv_mps, "pgv", "m/s", real, "peak horizontal velocity"),
         OVERTURN_COLUMN(Row, pgd_m, "pgd", "m", real, "peak horizontal displacement"),
         OVERTURN_COLUMN(Row, arias_mps, "arias", "m/s", real, "Arias intensity of the horizontal component"),
         OVERTURN_COLUMN(Row, transverse_pga_mps2, "transverse_pga", "m/s2", real,
                         "peak acceleration of the other horizontal component; 0: none"),
         OVERTURN_COLUMN(Row, vertical_pga_mps2, "vertical_pga", "m/s2", real, "peak vertical acceleration; 0: none"),
         OVERTURN_COLUMN(Row, matched, "matched", "1", integer, "1: matched to a target spectrum"),
         OVERTURN_COLUMN(Row, match_iterations, "match_iterations", "1", integer, "iterations of the match"),
         OVERTURN_COLUMN(Row, match_mean_misfit, "match_mean_misfit", "1", real, "mean |computed / target - 1|"),
         OVERTURN_COLUMN(Row, match_max_misfit, "match_max_misfit", "1", real, "max |computed / target - 1|"),
         OVERTURN_COLUMN(Row, match_max_misfit_period_s, "match_max_misfit_period", "s", real, "where it lies"),
         OVERTURN_COLUMN(Row, match_mean_ratio, "match_mean_ratio", "1", real, "mean of computed / target"),
         OVERTURN_COLUMN(Row, match_ratio_cov, "match_ratio_cov", "1", real,
                         "coefficient of variation of computed / target"),
         OVERTURN_COLUMN(Row, match_long_mean_misfit, "match_long_mean_misfit", "1", real,
                         "mean misfit over the long periods, 1 s and above"),
         OVERTURN_COLUMN(Row, match_long_max_misfit, "match_long_max_misfit", "1", real,
                         "max misfit over the long periods, 1 s and above"),
         OVERTURN_COLUMN(Row, match_lowest_ratio, "match_lowest_ratio", "1", real, "min of computed / target"),
         OVERTURN_COLUMN(Row, match_highest_ratio, "match_highest_ratio", "1", real, "max of computed / target"),
         OVERTURN_COLUMN(Row, match_longest_below, "match_longest_below", "1", integer,
                         "most adjacent periods below the target, 100 a decade"),
         OVERTURN_COLUMN(Row, match_worst_decade, "match_worst_decade", "1", real,
                         "largest mean misfit over any decade of periods"),
         OVERTURN_COLUMN(Row, si_ratio, "si_ratio", "1", real,
                         "spectral intensity over that of the target, 0.1 s to 2.5 s; 0: not covered"),
         OVERTURN_COLUMN(Row, psd_lowest_ratio, "psd_lowest_ratio", "1", real,
                         "min of power spectral density over the one that fits the target, 20 % windows, 0.3 to 24 Hz"),
         OVERTURN_COLUMN(Row, psd_lowest_hz, "psd_lowest_frequency", "Hz", real, "where it lies"),
         OVERTURN_COLUMN(Row, transverse_match_mean_misfit, "transverse_match_mean_misfit", "1", real,
                         "mean misfit of the other horizontal component"),
         OVERTURN_COLUMN(Row, transverse_match_worst_decade, "transverse_match_worst_decade", "1", real,
                         "its largest mean misfit over any decade of periods"),
         OVERTURN_COLUMN(Row, vertical_match_mean_misfit, "vertical_match_mean_misfit", "1", real,
                         "mean misfit of the vertical component"),
         OVERTURN_COLUMN(Row, vertical_match_worst_decade, "vertical_match_worst_decade", "1", real,
                         "its largest mean misfit over any decade of periods"),
         OVERTURN_COLUMN(Row, duration_5_75_s, "duration_5_75", "s", real,
                         "time from 5 % to 75 % of the Arias integral"),
         OVERTURN_COLUMN(Row, duration_5_95_s, "duration_5_95", "s", real,
                         "time from 5 % to 95 % of the Arias integral"),
         OVERTURN_COLUMN(Row, residual_velocity_mps, "residual_velocity", "m/s", real,
                         "horizontal velocity at the end"),
         OVERTURN_COLUMN(Row, residual_displacement_m, "residual_displacement", "m", real,
                         "horizontal displacement at the end"),
         OVERTURN_COLUMN(Row, correlation, "correlation", "1", real,
                         "coefficient of the two components that are correlated most; 0: just one"),
         OVERTURN_COLUMN(Row, accepted, "accepted", "1", integer,
                         "1: meets waves.acceptance, 0: does not, -1: not asked"),
         OVERTURN_COLUMN(
             Row, acceptance_failures, "acceptance_failures", "1", integer,
             "bit mask of clauses not met, from bit 0: time step, duration, judged to, lowest ratio, adjacent "
             "below, highest ratio, SI ratio, cov of the ratio, error of the mean, worst decade, end velocity, "
             "component correlation, rocking band")}};
}

store::TableSpec measure_table(CampaignSpec const& spec, std::size_t body) {
    using Row = MeasureRow;
    store::TableSpec table{
        "waves/" + spec.bodies.at(body).name,
        spec.bodies.size() * sizeof(Row),
        {OVERTURN_COLUMN(Row, ou_v_e_mps, "ou_v_e", "m/s", real, "Akiyama's ouV_E of the unscaled wave"),
         OVERTURN_COLUMN(Row, v_wes_max_mps, "v_wes", "m/s", real,
                         "max over time of the unscaled wave's window energy spectrum"),
         OVERTURN_COLUMN(Row, v_wes_time_s, "v_wes_time", "s", real, "when that maximum is reached"),
         OVERTURN_COLUMN(Row, band_mean_misfit, "band_mean_misfit", "1", real,
                         "mean |computed / target - 1| over [T0, T1] of the body"),
         OVERTURN_COLUMN(Row, band_max_misfit, "band_max_misfit", "1", real, "max of it over [T0, T1]"),
         OVERTURN_COLUMN(Row, band_mean_ratio, "band_mean_ratio", "1", real, "mean of computed / target over [T0, T1]"),
         OVERTURN_COLUMN(Row, band_ratio_cov, "band_ratio_cov", "1", real,
                         "coefficient of variation of computed / target over [T0, T1]")}};
    if (spec.measures.both_radius_units) {
        table.columns.push_back(OVERTURN_COLUMN(Row, other_unit_ou_v_e_mps, "ou_v_e_other_unit", "m/s", real,
                                                "ouV_E with R in the unit that measures.radius_unit does not name"));
        table.columns.push_back(OVERTURN_COLUMN(Row, other_unit_v_wes_max_mps, "v_wes_other_unit", "m/s", real,
                                                "V_WES with R in the unit that measures.radius_unit does not name"));
    }
    for (auto& column : table.columns) {
        column.offset += body * sizeof(Row);
    }
    return table;
}

std::vector<std::string> differing_columns(TrialRow const& a, TrialRow const& b) {
    std::vector<std::string> names;
    for (auto const& column : trial_table().columns) {
        auto const* const left = reinterpret_cast<std::byte const*>(&a) + column.offset;
        auto const* const right = reinterpret_cast<std::byte const*>(&b) + column.offset;
        if (std::memcmp(left, right, sizeof(double)) != 0) {
            names.push_back(column.name);
        }
    }
    return names;
}

TrialRow read_trial(store::ResultsReader const& file, std::int64_t number) {
    TrialRow row;
    for (auto const& column : trial_table().columns) {
        auto* const place = reinterpret_cast<std::byte*>(&row) + column.offset;
        auto const name = "trials/" + column.name;
        if (column.type == store::ColumnType::real) {
            double const value = file.real_at(name, number);
            std::memcpy(place, &value, sizeof value);
        } else {
            std::int64_t const value = file.integer_at(name, number);
            std::memcpy(place, &value, sizeof value);
        }
    }
    return row;
}

}  // namespace overturn
