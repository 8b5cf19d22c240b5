#include "campaign/detail/wave_rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "campaign/rocking_band.hpp"
#include "core/units.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

// A wave, or a component of it, that was compared with no target has no figures of a match.
bool was_compared(MatchFigures const& figures) { return figures.mean_ratio > 0; }
double if_compared(MatchFigures const& figures, double value) { return was_compared(figures) ? value : never; }

// A ratio of spectra that do not cover what it is taken over.
double if_covered(double ratio) { return ratio > 0 ? ratio : never; }

ComponentMatch match_of(MatchReport const& match) {
    if (!was_compared(match.all)) {
        return {never, never, never, never, never, never, never, never, never};
    }
    return {.lowest_ratio = match.all.lowest_ratio,
            .lowest_period_s = match.all.lowest_period_s,
            .highest_ratio = match.all.highest_ratio,
            .highest_period_s = match.all.highest_period_s,
            .longest_below = static_cast<double>(match.all.longest_below),
            .longest_below_to_s = match.all.longest_below_to_s,
            .si_ratio = if_covered(match.intensity_ratio),
            .ratio_cov = match.all.cov,
            .mean_ratio = match.all.mean_ratio};
}

std::int64_t failures_of(std::span<Clause const> clauses, std::string_view component) {
    std::vector<Clause> own;
    std::ranges::copy_if(clauses, std::back_inserter(own),
                         [&](Clause const& clause) { return clause.component == component; });
    return failed_clauses(own);
}

}  // namespace

void describe_match(WaveRow& row, GeneratedWave const& wave) {
    auto const& match = wave.match;
    row.matched = match.matched ? 1 : 0;
    row.match_iterations = match.iterations;
    row.match_mean_misfit = if_compared(match.all, match.all.mean_misfit);
    row.match_max_misfit = if_compared(match.all, match.all.max_misfit);
    row.match_max_misfit_period_s = if_compared(match.all, match.all.max_misfit_period_s);
    row.match_mean_ratio = if_compared(match.all, match.all.mean_ratio);
    row.match_ratio_cov = if_compared(match.all, match.all.cov);
    row.match_long_mean_misfit = if_compared(match.long_period, match.long_period.mean_misfit);
    row.match_long_max_misfit = if_compared(match.long_period, match.long_period.max_misfit);
    row.match_lowest_ratio = if_compared(match.all, match.all.lowest_ratio);
    row.match_highest_ratio = if_compared(match.all, match.all.highest_ratio);
    row.match_lowest_period_s = if_compared(match.all, match.all.lowest_period_s);
    row.match_highest_period_s = if_compared(match.all, match.all.highest_period_s);
    row.match_longest_below = match.all.longest_below;
    row.match_longest_below_to_s = if_compared(match.all, match.all.longest_below_to_s);
    row.transverse_match = match_of(wave.transverse_match);
    row.vertical_match = match_of(wave.vertical_match);
    row.match_worst_decade = if_compared(match.all, match.worst_decade);
    row.si_ratio = if_covered(match.intensity_ratio);
    row.psd_lowest_ratio = if_covered(match.psd_lowest_ratio);
    row.psd_lowest_hz = if_covered(match.psd_lowest_hz);
    row.transverse_match_mean_misfit = if_compared(wave.transverse_match.all, wave.transverse_match.all.mean_misfit);
    row.transverse_match_worst_decade = if_compared(wave.transverse_match.all, wave.transverse_match.worst_decade);
    row.vertical_match_mean_misfit = if_compared(wave.vertical_match.all, wave.vertical_match.all.mean_misfit);
    row.vertical_match_worst_decade = if_compared(wave.vertical_match.all, wave.vertical_match.worst_decade);
}

void describe_motion(WaveRow& row, GroundMotion const& motion, Intensity const& intensity) {
    row.duration_s = motion.duration_s();
    row.pga_mps2 = intensity.pga_mps2;
    row.pgv_mps = intensity.pgv_mps;
    row.pgd_m = intensity.pgd_m;
    row.arias_mps = intensity.arias_mps;
    row.vector_pga_mps2 = intensity.vector_pga_mps2;
    row.transverse_pga_mps2 = peak_of(motion.transverse_mps2);
    row.vertical_pga_mps2 = peak_of(motion.vertical_mps2);
    measure_motion(motion, row);
}

void measure_sa(MeasureSpec const& measures, PreparedWave& wave) {
    constexpr double damping = 0.05;
    constexpr double per_decade = 30;
    auto const psa_at = [&](std::vector<double> const& periods_s) {
        auto values = displacement_spectrum(wave.motion.horizontal_mps2, wave.motion.time_step_s, periods_s, damping);
        for (std::size_t i = 0; i < values.size(); ++i) {
            double const w = 2 * pi / periods_s[i];
            values[i] *= w * w;
        }
        return values;
    };
    if (!measures.sa_periods_s.empty()) {
        std::ranges::copy(psa_at(measures.sa_periods_s), wave.row.sa_mps2.begin());
    }
    if (measures.sa_band) {
        double sum = 0;
        auto const values = psa_at(log_periods_per_decade(measures.sa_band->t0_s, measures.sa_band->t1_s, per_decade));
        for (double const value : values) {
            sum += std::log(value);
        }
        // A wave of silence has none.
        double const mean = std::exp(sum / static_cast<double>(values.size()));
        wave.row.sa_average_mps2 = mean;
    }
}

void describe_drawn(WaveRow& row, DrawnTarget const& drawn) {
    row.target = drawn.number;
    row.event = drawn.event;
    row.epsilon = drawn.epsilon;
    row.epsilon_between = drawn.epsilon_between;
    row.epsilon_within = drawn.epsilon_within;
}

void describe_check(PreparedWave& wave, WaveCheck const& check) {
    auto& row = wave.row;
    row.duration_5_75_s = check.quality.duration_5_75_s;
    row.duration_5_95_s = check.quality.duration_5_95_s;
    row.residual_velocity_mps = check.quality.residual_velocity_mps;
    row.residual_displacement_m = check.quality.residual_displacement_m;
    row.correlation = check.quality.correlation;
    if (!check.clauses.empty()) {
        row.accepted = all_passed(check.clauses) ? Accepted::yes : Accepted::no;
        row.acceptance_failures = failed_clauses(check.clauses);
        row.horizontal_failures = failures_of(check.clauses, "horizontal");
        row.transverse_failures = failures_of(check.clauses, "transverse");
        row.vertical_failures = failures_of(check.clauses, "vertical");
    }
    for (std::size_t b = 0; b < wave.measures.size(); ++b) {
        auto const& band = check.bands[b];
        wave.measures[b].band_mean_misfit = if_compared(band, band.mean_misfit);
        wave.measures[b].band_max_misfit = if_compared(band, band.max_misfit);
        wave.measures[b].band_mean_ratio = if_compared(band, band.mean_ratio);
        wave.measures[b].band_ratio_cov = if_compared(band, band.cov);
    }
}

void measure_energy(MeasureSpec const& spec, GroundMotion const& motion, RigidBody const& body, MeasureRow& row) {
    WindowOptions const options{
        .reading = spec.window, .smoothed = true, .keep_history = false, .panel_phase_rad = spec.panel_phase_rad};
    auto const energy_over = [&](RadiusUnit unit) {
        return window_energy(motion.horizontal_mps2, motion.time_step_s, rocking_band(body, unit), options);
    };
    auto const energy = energy_over(spec.radius_unit);
    row.ou_v_e_mps = energy.ou_v_e_mps;
    row.v_wes_max_mps = energy.v_wes_max_mps;
    row.v_wes_time_s = energy.v_wes_time_s;
    if (spec.both_radius_units) {
        auto const with_other = energy_over(other(spec.radius_unit));
        row.other_unit_ou_v_e_mps = with_other.ou_v_e_mps;
        row.other_unit_v_wes_max_mps = with_other.v_wes_max_mps;
    }
}

}  // namespace overturn
