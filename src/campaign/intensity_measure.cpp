#include "campaign/intensity_measure.hpp"

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "core/error.hpp"
#include "motion/cumulative_velocity.hpp"

namespace overturn {

namespace measuring {

double pga(WaveRow const& wave, MeasureRow const& /*body*/) { return wave.pga_mps2; }
double pgv(WaveRow const& wave, MeasureRow const& /*body*/) { return wave.pgv_mps; }
double pgd(WaveRow const& wave, MeasureRow const& /*body*/) { return wave.pgd_m; }
double vector_pga(WaveRow const& wave, MeasureRow const& /*body*/) { return wave.vector_pga_mps2; }
double sa_average(WaveRow const& wave, MeasureRow const& /*body*/) { return wave.sa_average_mps2; }
double sa(WaveRow const& wave, std::size_t period) { return wave.sa_mps2.at(period); }
double one(WaveRow const& /*wave*/, MeasureRow const& /*body*/) { return 1; }
double v_wes_other_unit(WaveRow const& /*wave*/, MeasureRow const& of_body) { return of_body.other_unit_v_wes_max_mps; }
double ou_v_e_other_unit(WaveRow const& /*wave*/, MeasureRow const& of_body) { return of_body.other_unit_ou_v_e_mps; }

double v_wes(TrialRow const& trial) { return trial.v_wes_mps; }
double ou_v_e(TrialRow const& trial) { return trial.ou_v_e_mps; }
double v_wes_ratio(TrialRow const& trial) { return trial.v_wes_mps / trial.v_ereq_mps; }
double amplitude(TrialRow const& trial) { return trial.amplitude; }

double cav(GroundMotion const& motion, double scale) {
    return scale * cav_mps(motion.horizontal_mps2, motion.time_step_s);
}
double standardised_cav(GroundMotion const& motion, double scale) {
    return standardised_cav_mps(motion.horizontal_mps2, motion.time_step_s, scale);
}

bool always(MeasureSpec const& /*spec*/) { return true; }
bool with_energy(MeasureSpec const& spec) { return spec.energy; }
bool with_both_units(MeasureSpec const& spec) { return spec.both_radius_units; }
bool with_band(MeasureSpec const& spec) { return spec.sa_band.has_value(); }
bool with_period(MeasureSpec const& spec, std::size_t period) { return period < spec.sa_periods_s.size(); }

}  // namespace measuring

namespace {

// Every number once, from 0 on, and every name; a value from one place; levels only by what is linear in the scale.
consteval bool is_sound() {
    for (std::size_t number = 0; number < intensity_measures.size(); ++number) {
        if (std::ranges::count(intensity_measures, static_cast<std::int64_t>(number), &IntensityMeasure::number) != 1) {
            return false;
        }
    }
    return std::ranges::all_of(intensity_measures, [](IntensityMeasure const& entry) {
        int const sources = (entry.of_wave ? 1 : 0) + (entry.of_trial ? 1 : 0) + (entry.of_motion ? 1 : 0);
        return sources == 1 && std::ranges::count(intensity_measures, entry.name, &IntensityMeasure::name) == 1
               && (entry.level.empty() || is_linear(&entry))
               && (entry.curves == Curves::measured) == entry.measured.has_value();
    });
}
static_assert(is_sound());

// Where a measure's column lies among those that `has` picks.
std::size_t place_among(Measure measure, bool (IntensityMeasure::*has)() const) {
    return std::count_if(intensity_measures.data(), measure,
                         [&](IntensityMeasure const& before) { return (before.*has)(); });
}

}  // namespace

std::string IntensityMeasure::units() const {
    auto const symbol = si_symbol(dimension);
    return symbol.empty() ? "1" : std::string(symbol);
}

std::vector<std::pair<Measure, double>> measures_of(GroundMotion const& motion) {
    std::vector<std::pair<Measure, double>> values;
    for (auto const& measure : intensity_measures) {
        if (measure.of_motion) {
            values.emplace_back(&measure, (*measure.of_motion)(motion, 1));
        }
    }
    return values;
}

double unscaled(Measure measure, WaveRow const& wave, MeasureRow const& of_body) {
    OVERTURN_EXPECT(is_linear(measure));
    return measure->of_wave ? (*measure->of_wave)(wave, of_body)
                            : wave.measured.at(place_among(measure, &IntensityMeasure::has_wave_column));
}

double of_trial(Measure measure, TrialRow const& trial) {
    OVERTURN_EXPECT(!is_linear(measure));
    return measure->of_trial ? (*measure->of_trial)(trial)
                             : trial.measured.at(place_among(measure, &IntensityMeasure::has_trial_column));
}

void measure_motion(GroundMotion const& motion, WaveRow& row) {
    for (auto const& entry : intensity_measures) {
        if (entry.has_wave_column()) {
            row.measured.at(place_among(&entry, &IntensityMeasure::has_wave_column)) = (*entry.of_motion)(motion, 1);
        }
    }
}

void measure_scaled(std::span<Measure const> asked, GroundMotion const& motion, TrialRow& row) {
    for (auto const* const measure : asked) {
        if (measure->has_trial_column()) {
            row.measured.at(place_among(measure, &IntensityMeasure::has_trial_column)) =
                (*measure->of_motion)(motion, row.scale);
        }
    }
}

}  // namespace overturn
