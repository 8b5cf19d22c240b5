/// Intensity measures, each stated once: levels, curves, columns, figures, lists and messages take them from here.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

struct WaveRow;
struct MeasureRow;
struct TrialRow;
struct MeasureSpec;

/// Largest number of periods at which a campaign measures Sa.
inline constexpr std::size_t most_sa_periods = 4;

/// Levels above `most` are a mistake in the unit, by a factor of some two; where all are below `least` nothing moves.
struct PlausibleLevels {
    double most = 0;  ///< [SI]; 0: nothing is known
    std::string_view unit = {};
    double unit_si = 1;
    std::string_view known = {};  ///< by what
    double least = 0;             ///< [SI]
};

/// Over which measures a campaign has curves.
enum class Curves {
    asked,     ///< those that measures.curves names
    measured,  ///< wherever `measured` says that the campaign measures it
    none       ///< never
};

/// A function or none. Under GCC's sanitizer of undefined behaviour no function's address compares as a constant, which
/// a plain pointer would ask for.
template <class Function> using MaybeFunction = std::optional<Function*>;

/// One measure. A measure that is linear in the wave's scale has `of_wave`, or an `of_motion` that is `linear`.
struct IntensityMeasure {
    std::int64_t number;          ///< in files, beside the name: never renumber
    std::string_view name;        ///< of columns, files and JSON: "sa_average"
    std::string_view title;       ///< of figures: "V_WES"
    std::string_view level = {};  ///< as levels.measure states it; empty: no levels are stated by it
    Dimension dimension = Dimension::none;
    std::string_view meaning;
    Curves curves = Curves::asked;
    MaybeFunction<bool(MeasureSpec const&)> measured = {};
    /// Value for the wave before scaling and a body [SI]
    MaybeFunction<double(WaveRow const& wave, MeasureRow const& body)> of_wave = {};
    /// Value for the scaled wave and the body of a trial [SI]
    MaybeFunction<double(TrialRow const&)> of_trial = {};
    /// Value for the motion times a factor [SI]: gives /waves a column of this name, with a factor of 1
    MaybeFunction<double(GroundMotion const&, double scale)> of_motion = {};
    /// Is of_motion proportional to the factor? Where it is not, /trials has a column of this name if it is requested
    bool linear = true;
    bool criterion = false;                  ///< it is compared with V_Ereq
    bool drifts = false;                     ///< a baseline's drift is in it
    std::string_view other_unit_of = {};     ///< the measure that this is with R in the other unit
    std::optional<std::size_t> period = {};  ///< Sa: at this place of measures.sa_periods
    PlausibleLevels plausible = {};

    [[nodiscard]] constexpr bool has_wave_column() const { return of_motion.has_value(); }
    [[nodiscard]] constexpr bool has_trial_column() const { return of_motion && !linear; }
    /// [SI], "1" for a pure number
    [[nodiscard]] std::string units() const;
};

/// An entry of the registry; equal where it is the same one.
using Measure = IntensityMeasure const*;

/// \name What entries are made of: defined in intensity_measure.cpp.
/// @{
namespace measuring {
[[nodiscard]] double pga(WaveRow const& wave, MeasureRow const& /*body*/);
[[nodiscard]] double pgv(WaveRow const& wave, MeasureRow const& /*body*/);
[[nodiscard]] double pgd(WaveRow const& wave, MeasureRow const& /*body*/);
[[nodiscard]] double vector_pga(WaveRow const& wave, MeasureRow const& /*body*/);
[[nodiscard]] double sa_average(WaveRow const& wave, MeasureRow const& /*body*/);
[[nodiscard]] double sa(WaveRow const& wave, std::size_t period);
template <std::size_t period> [[nodiscard]] double sa_at(WaveRow const& wave, MeasureRow const& /*body*/) {
    return sa(wave, period);
}
[[nodiscard]] double one(WaveRow const& /*wave*/, MeasureRow const& /*body*/);
[[nodiscard]] double v_wes_other_unit(WaveRow const& /*wave*/, MeasureRow const& of_body);
[[nodiscard]] double ou_v_e_other_unit(WaveRow const& /*wave*/, MeasureRow const& of_body);
[[nodiscard]] double v_wes(TrialRow const& trial);
[[nodiscard]] double ou_v_e(TrialRow const& trial);
[[nodiscard]] double v_wes_ratio(TrialRow const& trial);
[[nodiscard]] double amplitude(TrialRow const& trial);
[[nodiscard]] double cav(GroundMotion const& motion, double scale);
[[nodiscard]] double standardised_cav(GroundMotion const& motion, double scale);

[[nodiscard]] bool always(MeasureSpec const& /*spec*/);
[[nodiscard]] bool with_energy(MeasureSpec const& spec);
[[nodiscard]] bool with_both_units(MeasureSpec const& spec);
[[nodiscard]] bool with_band(MeasureSpec const& spec);
[[nodiscard]] bool with_period(MeasureSpec const& spec, std::size_t period);
template <std::size_t period> [[nodiscard]] bool with_period_at(MeasureSpec const& spec) {
    return with_period(spec, period);
}

template <std::size_t i> [[nodiscard]] consteval IntensityMeasure sa_entry(std::string_view name) {
    constexpr std::int64_t first = 9;
    return {.number = first + static_cast<std::int64_t>(i),
            .name = name,
            .title = "Sa",
            .level = "sa",
            .dimension = Dimension::acceleration,
            .meaning = "pseudo-acceleration at levels.period, 5 % damping, of the horizontal component",
            .curves = Curves::measured,
            .measured = &with_period_at<i>,
            .of_wave = &sa_at<i>,
            .period = i};
}
}  // namespace measuring
/// @}

/// All measures, in the order in which curves over them are listed. A new one is an entry here and its function.
inline constexpr std::array intensity_measures{
    IntensityMeasure{.number = 5,
                     .name = "level",
                     .title = "level",
                     .meaning = "the levels' own measure, where curves over it have no name of their own",
                     .curves = Curves::none,
                     .of_trial = &measuring::amplitude},
    IntensityMeasure{.number = 0,
                     .name = "pga",
                     .title = "PGA",
                     .level = "pga",
                     .dimension = Dimension::acceleration,
                     .meaning = "peak horizontal acceleration",
                     .curves = Curves::measured,
                     .measured = &measuring::always,
                     .of_wave = &measuring::pga,
                     .plausible = {10 * g0, "gal", 0.01, "the strongest records stay below 5 g", 0.2}},
    IntensityMeasure{.number = 1,
                     .name = "pgv",
                     .title = "PGV",
                     .level = "pgv",
                     .dimension = Dimension::velocity,
                     .meaning = "peak horizontal velocity",
                     .curves = Curves::measured,
                     .measured = &measuring::always,
                     .of_wave = &measuring::pgv,
                     .drifts = true,
                     .plausible = {10, "kine", 0.01, "the strongest records stay below 4 m/s", 0.01}},
    IntensityMeasure{.number = 13,
                     .name = "pgd",
                     .title = "PGD",
                     .level = "pgd",
                     .dimension = Dimension::length,
                     .meaning = "peak horizontal displacement",
                     .of_wave = &measuring::pgd,
                     .drifts = true,
                     .plausible = {30, "cm", 0.01, "the strongest records stay below 10 m", 0.001}},
    IntensityMeasure{.number = 14,
                     .name = "vector_pga",
                     .title = "PGA of both axes",
                     .level = "vector-pga",
                     .dimension = Dimension::acceleration,
                     .meaning = "peak length of the horizontal acceleration, of both components together",
                     .of_wave = &measuring::vector_pga,
                     .plausible = {10 * g0, "gal", 0.01, "the strongest records stay below 5 g", 0.2}},
    IntensityMeasure{.number = 15,
                     .name = "cav",
                     .title = "CAV",
                     .level = "cav",
                     .dimension = Dimension::velocity,
                     .meaning = "cumulative absolute velocity, the integral of |a| of the horizontal component",
                     .of_motion = &measuring::cav},
    IntensityMeasure{.number = 16,
                     .name = "standardised_cav",
                     .title = "standardised CAV",
                     .dimension = Dimension::velocity,
                     .meaning = "CAV of the windows of 1 s in which the horizontal acceleration reaches 0.025 g",
                     .of_motion = &measuring::standardised_cav,
                     .linear = false},
    IntensityMeasure{.number = 8,
                     .name = "sa_average",
                     .title = "Sa, averaged",
                     .level = "sa-average",
                     .dimension = Dimension::acceleration,
                     .meaning = "geometric mean of the pseudo-acceleration over measures.sa_band",
                     .curves = Curves::measured,
                     .measured = &measuring::with_band,
                     .of_wave = &measuring::sa_average},
    measuring::sa_entry<0>("sa_1"),
    measuring::sa_entry<1>("sa_2"),
    measuring::sa_entry<2>("sa_3"),
    measuring::sa_entry<3>("sa_4"),
    IntensityMeasure{.number = 17,
                     .name = "factor",
                     .title = "factor",
                     .level = "factor",
                     .meaning = "a plain factor on the wave as it is",
                     .curves = Curves::none,
                     .of_wave = &measuring::one},
    IntensityMeasure{.number = 2,
                     .name = "v_wes",
                     .title = "V_WES",
                     .dimension = Dimension::velocity,
                     .meaning = "max over time of the window energy spectrum",
                     .curves = Curves::measured,
                     .measured = &measuring::with_energy,
                     .of_trial = &measuring::v_wes,
                     .criterion = true},
    IntensityMeasure{.number = 3,
                     .name = "ou_v_e",
                     .title = "ouV_E",
                     .dimension = Dimension::velocity,
                     .meaning = "Akiyama's mean input energy over the periods a body rocks through",
                     .curves = Curves::measured,
                     .measured = &measuring::with_energy,
                     .of_trial = &measuring::ou_v_e,
                     .criterion = true},
    IntensityMeasure{.number = 4,
                     .name = "v_wes_ratio",
                     .title = "V_WES / V_Ereq",
                     .meaning = "V_WES over the body's limit velocity",
                     .curves = Curves::measured,
                     .measured = &measuring::with_energy,
                     .of_trial = &measuring::v_wes_ratio},
    IntensityMeasure{.number = 6,
                     .name = "v_wes_other_unit",
                     .title = "V_WES, other unit of R",
                     .dimension = Dimension::velocity,
                     .meaning = "V_WES with R in the unit that measures.radius_unit does not name",
                     .curves = Curves::measured,
                     .measured = &measuring::with_both_units,
                     .of_wave = &measuring::v_wes_other_unit,
                     .criterion = true,
                     .other_unit_of = "v_wes"},
    IntensityMeasure{.number = 7,
                     .name = "ou_v_e_other_unit",
                     .title = "ouV_E, other unit of R",
                     .dimension = Dimension::velocity,
                     .meaning = "ouV_E with R in the unit that measures.radius_unit does not name",
                     .curves = Curves::measured,
                     .measured = &measuring::with_both_units,
                     .of_wave = &measuring::ou_v_e_other_unit,
                     .criterion = true,
                     .other_unit_of = "ou_v_e"}};

/// The measure of this name. \throws std::logic_error if there is none: of names in the program alone
[[nodiscard]] constexpr Measure measure_named(std::string_view name) {
    for (auto const& entry : intensity_measures) {
        if (entry.name == name) {
            return &entry;
        }
    }
    throw std::logic_error("no such intensity measure");
}

/// Sa at the campaign's i-th period, from 0. \pre i < most_sa_periods
[[nodiscard]] constexpr Measure sa_measure(std::size_t i) {
    return std::ranges::find(intensity_measures, std::optional(i), &IntensityMeasure::period);
}

/// The measure itself, in whichever unit R was taken.
[[nodiscard]] constexpr Measure in_any_unit(Measure measure) {
    return measure->other_unit_of.empty() ? measure : measure_named(measure->other_unit_of);
}

/// Number of measures with a column in /waves, and in /trials.
inline constexpr auto wave_measures =
    static_cast<std::size_t>(std::ranges::count_if(intensity_measures, &IntensityMeasure::has_wave_column));
inline constexpr auto trial_measures =
    static_cast<std::size_t>(std::ranges::count_if(intensity_measures, &IntensityMeasure::has_trial_column));

/// Before scaling, for a body [SI]. \pre the measure is linear in the scale
[[nodiscard]] double unscaled(Measure measure, WaveRow const& wave, MeasureRow const& of_body);
/// Is it known of a wave before scaling, and of a trial by its scale?
[[nodiscard]] constexpr bool is_linear(Measure measure) {
    return measure->of_wave || (measure->of_motion && measure->linear);
}
/// Value for a trial [SI]. \pre the measure is not linear in the scale
[[nodiscard]] double of_trial(Measure measure, TrialRow const& trial);

/// Measures that are functions of a motion alone, in the order of the registry [SI].
[[nodiscard]] std::vector<std::pair<Measure, double>> measures_of(GroundMotion const& motion);
/// Fills the columns that measures have in /waves.
void measure_motion(GroundMotion const& motion, WaveRow& row);
/// Fills those of a trial that the campaign requests.
void measure_scaled(std::span<Measure const> asked, GroundMotion const& motion, TrialRow& row);

}  // namespace overturn
