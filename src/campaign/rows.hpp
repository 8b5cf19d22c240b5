/// The rows of the results file, with the table of their fields. Every field is 8 bytes, so that rows travel and are
/// stored as they lie in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "campaign/intensity_measure.hpp"
#include "generators/drawn_target.hpp"
#include "response/response.hpp"

namespace overturn {

/// Does a wave meet waves.acceptance? Stored: never renumber.
enum class Accepted : std::int64_t { no = 0, yes = 1, not_asked = 2 };

/// Values of measures of which none is known yet.
template <std::size_t count> [[nodiscard]] consteval std::array<double, count> unknown() {
    std::array<double, count> values{};
    values.fill(never);
    return values;
}

/// Match of a component to its target, as far as a rule checks it; all 0 without a target.
struct ComponentMatch {
    double lowest_ratio = 0, lowest_period_s = 0;
    double highest_ratio = 0, highest_period_s = 0;
    double longest_below = 0, longest_below_to_s = 0;
    double si_ratio = 0, ratio_cov = 0, mean_ratio = 0;
};

/// One wave, as generated or read, before any scaling.
struct WaveRow {
    std::int64_t id = 0;
    std::int64_t failed = 0;
    double duration_s = 0;
    double pga_mps2 = 0, pgv_mps = 0, pgd_m = 0, arias_mps = 0;
    double transverse_pga_mps2 = 0, vertical_pga_mps2 = 0, vector_pga_mps2 = 0;
    std::int64_t matched = 0;
    std::int64_t match_iterations = 0;
    double match_mean_misfit = 0, match_max_misfit = 0, match_max_misfit_period_s = 0;
    double match_mean_ratio = 0, match_ratio_cov = 0;
    double match_long_mean_misfit = 0, match_long_max_misfit = 0;
    double match_lowest_ratio = 0, match_highest_ratio = 0;
    double match_lowest_period_s = 0, match_highest_period_s = 0;
    std::int64_t match_longest_below = 0;
    double match_longest_below_to_s = 0;
    double match_worst_decade = 0, si_ratio = 0, psd_lowest_ratio = 0, psd_lowest_hz = 0;
    double transverse_match_mean_misfit = 0, transverse_match_worst_decade = 0;
    double vertical_match_mean_misfit = 0, vertical_match_worst_decade = 0;
    ComponentMatch transverse_match{}, vertical_match{};
    double duration_5_75_s = 0, duration_5_95_s = 0;
    double residual_velocity_mps = 0, residual_displacement_m = 0;
    double correlation = 0;
    double turned_rad = 0;
    std::int64_t target = 0, event = 0;
    Epsilons epsilon{}, epsilon_between{}, epsilon_within{};
    std::array<double, most_sa_periods> sa_mps2{};
    double sa_average_mps2 = 0;
    std::array<double, wave_measures> measured = unknown<wave_measures>();  ///< in the order of intensity_measures
    Accepted accepted = Accepted::not_asked;
    std::int64_t acceptance_failures = 0;
    std::int64_t horizontal_failures = 0, transverse_failures = 0,
                 vertical_failures = 0;  ///< the part of them that their spectra miss
};

/// The energy measures of one wave for one body, before any scaling, and its match where that body rocks.
struct MeasureRow {
    double ou_v_e_mps = never, v_wes_max_mps = never, v_wes_time_s = never;
    double band_mean_misfit = 0, band_max_misfit = 0, band_mean_ratio = 0, band_ratio_cov = 0;
    double other_unit_ou_v_e_mps = never, other_unit_v_wes_max_mps = never;
};

/// One trial: (wave, body, level) -> what became of it. What a model has more to say lies in rows of its own.
struct TrialRow : Response {
    std::int64_t wave = 0, body = 0, level = 0;
    double amplitude = 0, scale = never;
    double mass_kg = 0, centre_height_m = 0, restitution = 0;
    double static_friction = never, kinetic_friction = never;
    double v_wes_mps = never, ou_v_e_mps = never, v_ereq_mps = 0;
    std::int64_t v_wes_safe = 0, ou_v_e_safe = 0;
    double least_clearance_m = never, edge_margin_m = never;                  ///< of [site]
    std::array<double, trial_measures> measured = unknown<trial_measures>();  ///< of the scaled wave, in that order
};

/// Rows of trials, and for each the record of what models have to say of their own (ModelSelector::extra_parts).
struct TrialRows {
    std::vector<TrialRow> rows;
    std::vector<std::byte> extra;
};

/// Is a column of /waves a figure of the match to a target? NaN where a wave was compared with none; files of
/// program 1.0.0 may have 0 there.
[[nodiscard]] bool is_match_figure(std::string_view column);

template <> [[nodiscard]] Fields const& fields_of<WaveRow>();
template <> [[nodiscard]] Fields const& fields_of<MeasureRow>();
template <> [[nodiscard]] Fields const& fields_of<TrialRow>();

}  // namespace overturn
