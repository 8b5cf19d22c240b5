/// The rows of the results file. Every field is 8 bytes, so that rows travel and are stored as they lie in memory.
#pragma once

#include <cstdint>

namespace overturn {

/// Why a trial has no verdict. Stored: never renumber.
enum class FailureReason : std::int64_t {
    none = 0,
    wave_failed = 1,
    wave_cannot_be_scaled = 2,
    no_convergence = 3,
    absurd_level = 4,
    wave_not_accepted = 5
};

/// One wave, as generated or read, before any scaling.
struct WaveRow {
    std::int64_t id = 0;
    std::int64_t failed = 0;
    double duration_s = 0;
    double pga_mps2 = 0, pgv_mps = 0, pgd_m = 0, arias_mps = 0;
    double transverse_pga_mps2 = 0, vertical_pga_mps2 = 0;
    std::int64_t matched = 0;
    std::int64_t match_iterations = 0;
    double match_mean_misfit = 0, match_max_misfit = 0, match_max_misfit_period_s = 0;
    double match_mean_ratio = 0, match_ratio_cov = 0;
    double match_long_mean_misfit = 0, match_long_max_misfit = 0;
    double match_lowest_ratio = 0, match_highest_ratio = 0;
    std::int64_t match_longest_below = 0;
    double match_worst_decade = 0, si_ratio = 0, psd_lowest_ratio = 0, psd_lowest_hz = 0;
    double transverse_match_mean_misfit = 0, transverse_match_worst_decade = 0;
    double vertical_match_mean_misfit = 0, vertical_match_worst_decade = 0;
    double duration_5_75_s = 0, duration_5_95_s = 0;
    double residual_velocity_mps = 0, residual_displacement_m = 0;
    double correlation = 0;
    std::int64_t accepted = -1;
    std::int64_t acceptance_failures = 0;
};

/// The energy measures of one wave for one body, before any scaling, and its match where that body rocks.
struct MeasureRow {
    double ou_v_e_mps = 0, v_wes_max_mps = 0, v_wes_time_s = 0;
    double band_mean_misfit = 0, band_max_misfit = 0, band_mean_ratio = 0, band_ratio_cov = 0;
    double other_unit_ou_v_e_mps = -1, other_unit_v_wes_max_mps = -1;
};

/// One trial: (wave, body, level) -> verdict.
struct TrialRow {
    std::int64_t wave = 0, body = 0, level = 0;
    double amplitude = 0, scale = 0;
    double mass_kg = 0, centre_height_m = 0, restitution = 0;
    double static_friction = -1, kinetic_friction = -1;
    std::int64_t verdict = 0, failure = 0;
    double peak_rotation_rad = 0, peak_rotation_ratio = 0, time_of_peak_s = -1;
    double peak_energy_ratio = 0;
    double overturn_time_s = -1, first_uplift_s = -1;
    std::int64_t impacts = 0;
    double friction_demand = 0, min_contact_force_ratio = 1;
    double contact_lost_s = -1;
    double peak_slip_m = 0, residual_slip_m = 0, friction_work_jpkg = 0;
    double v_wes_mps = 0, ou_v_e_mps = 0, v_ereq_mps = 0, v_resp_mps = 0;
    std::int64_t v_wes_safe = 0, ou_v_e_safe = 0;
    std::int64_t effects = 0, effects_called = 0, rung = 0;
    std::int64_t steps = 0;
};

}  // namespace overturn
