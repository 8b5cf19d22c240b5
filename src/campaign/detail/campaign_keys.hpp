/// Keys of a campaign, except waves, bodies, levels, limits and rare events, which describe their own.
#pragma once

#include <array>
#include <limits>

#include "campaign/body_spec.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/detail/limit_spec.hpp"
#include "campaign/site.hpp"
#include "campaign/withheld_inputs.hpp"
#include "config/table.hpp"
#include "contact/contact_accuracy.hpp"
#include "generators/wave_source.hpp"
#include "response/effects.hpp"
#include "rocking/rocking_accuracy.hpp"

namespace overturn {

inline constexpr std::array radius_units{
    config::Entry<RadiusUnit>{"cm", "T0 = 0.05 sqrt(R in cm)", RadiusUnit::centimetre},
    config::Entry<RadiusUnit>{"m", "T0 = 0.05 sqrt(R in m)", RadiusUnit::metre}};
inline constexpr std::array window_readings{
    config::Entry<WindowReading>{"restarted", "the oscillators start afresh with each window",
                                 WindowReading::restarted},
    config::Entry<WindowReading>{"running", "energy that running oscillators gain over the window",
                                 WindowReading::running}};
/// Measures of the registry that curves are not drawn over unless they are requested.
inline constexpr auto curve_measures = [] {
    constexpr auto is_asked = [](IntensityMeasure const& entry) { return entry.curves == Curves::asked; };
    std::array<config::Entry<Measure>, static_cast<std::size_t>(std::ranges::count_if(intensity_measures, is_asked))>
        entries{};
    std::size_t next = 0;
    for (auto const& entry : intensity_measures) {
        if (is_asked(entry)) {
            entries.at(next++) = {entry.name, entry.meaning, &entry};
        }
    }
    return entries;
}();
inline constexpr config::Range sa_periods{.low = 0.02, .high = 20};
inline constexpr config::Keys measure_keys{
    config::word_key<radius_units>("radius_unit", "unit of R in T0").otherwise("cm"),
    config::boolean_key("energy", "measure V_WES and ouV_E of every wave and body").otherwise(true),
    config::boolean_key("wave_quality", "measure match, durations, residuals and correlation of every wave")
        .otherwise(true),
    config::boolean_key("both_radius_units", "also measure energies with the other unit").otherwise(false),
    config::word_key<window_readings>("window", "energy in a window").otherwise("restarted"),
    config::numbers_key("sa_periods", Dimension::time, sa_periods, "up to 4 periods at which Sa is measured")
        .optional(),
    config::numbers_key("sa_band", Dimension::time, sa_periods, "range of periods [first, last] for the average of Sa")
        .optional(),
    config::words_key<curve_measures>("curves", "further intensity measures with fragility curves").optional(),
    config::number_key("slid_from", Dimension::length, config::Range::not_negative(),
                       "smallest slip of a trial with verdict slid")
        .otherwise(MovementSpec{}.slip_m),
    config::number_key("rocked_from", Dimension::length, config::Range::not_negative(),
                       "smallest rise of the edge of the base of a trial with verdict rocked")
        .otherwise(MovementSpec{}.uplift_m)};
inline constexpr config::KeyTable measures_table{.meaning = "intensity measures of every wave",
                                                 .keys = measure_keys.all};

inline constexpr std::array samplings{
    config::Entry<Sampling>{"independent", "independent draws for each wave", Sampling::independent},
    config::Entry<Sampling>{"latin-hypercube", "Latin hypercube: one draw from each of as many equal strata as waves",
                            Sampling::latin_hypercube}};
inline constexpr config::Keys scatter_keys{
    config::word_key<samplings>("sampling", "sampling of the draws over the waves").otherwise("independent")};
inline constexpr config::KeyTable scatter_table{.meaning = "sampling of uncertain body properties",
                                                .keys = scatter_keys.all};

inline constexpr config::Keys effect_keys{
    config::text_key("mode", "auto: effects that each trial requires; none: planar rocking only").otherwise("auto"),
    config::words_key<effects>("include", "effects that are simulated in every trial, in place of mode").optional()};
inline constexpr config::KeyTable effects_table{.meaning = "effects that are simulated", .keys = effect_keys.all};

// Read by response/accuracy.cpp, under these names; what it reads is held to this.
inline constexpr std::array restoring_words{config::Word{"nonlinear", "the block as it is"},
                                            config::Word{"linear", "for the closed forms of the literature"}};
inline constexpr config::Keys accuracy_keys{
    config::integer_key("taylor_order", 1, 99, "terms of the series of theta per step: 4, 6, 8, 10 or 12")
        .otherwise(RockingAccuracy{}.taylor_order),
    config::integer_key("substeps", 1, 1000, "steps per wave sample").otherwise(RockingAccuracy{}.substeps),
    config::number_key("step_tolerance", Dimension::none, {.low = 1e-16, .high = 1e-3},
                       "a step's last series term over alpha, at most")
        .otherwise(RockingAccuracy{}.step_tolerance),
    config::number_key("settle", Dimension::none, {.low = 0, .high = 1e-2, .low_open = true},
                       "bouncing slower than this times p is summed in closed form")
        .otherwise(RockingAccuracy{}.settle),
    config::word_key<restoring_words>("restoring", "restoring moment").otherwise("nonlinear"),
    config::number_key("contact_step", Dimension::none, {.low = 1e-4, .high = 1},
                       "largest step on points, times the pad's angular frequency")
        .otherwise(ContactAccuracy{}.step_ratio),
    config::number_key("panel_phase", Dimension::angle, {.low = 1, .high = 40},
                       "largest phase per panel of the energy integral")
        .otherwise(MeasureSpec{}.panel_phase_rad)};
inline constexpr config::KeyTable accuracy_table{.meaning = "numerical accuracy of trials", .keys = accuracy_keys.all};

inline constexpr config::Keys statistics_keys{
    config::number_key("confidence", Dimension::none, {.low = 0, .high = 1, .low_open = true, .high_open = true},
                       "confidence level of all intervals")
        .otherwise(0.95),
    config::number_key("beta_u", Dimension::none, {.low = 0, .high = 5, .low_open = true},
                       "beta_U of the fragility curves, beside what [scatter] samples: lognormal standard deviation of "
                       "their median from uncertain properties of the body; HCLPF needs it")
        .optional()};
inline constexpr config::KeyTable statistics_table{
    .meaning = "confidence intervals and stopping rules", .keys = statistics_keys.all, .also = {&precision_table}};

inline constexpr config::Keys campaign_keys{
    config::text_key("title", "title of pages and figures").optional(),
    config::text_key("question", "question that the campaign answers, for the cover of the page").optional(),
    config::text_key("prepared", "name of the person who prepared the calculation, for the cover").optional(),
    config::text_key("checked", "name of the person who checked it, for the cover").optional(),
    config::text_key("approved", "name of the person who approved it, for the cover").optional(),
    config::text_key("revision", "revision of the calculation, for the cover").optional(),
    config::text_key("hazard", "file (csv) of the seismic hazard curve, for annual frequencies").optional(),
    config::integer_key("seed", 0, std::numeric_limits<std::int64_t>::max(), "seed of all random numbers"),
    inputs_key,
    config::table_key("waves", &wave_tables, "ground motions"),
    config::tables_key<bodies_table>("bodies", "the bodies"),
    config::table_key<scatter_table>("scatter", "sampling of uncertain body properties").optional(),
    config::table_key<levels_table>("levels", "how strongly"),
    config::table_key<effects_table>("effects", "effects that are simulated").optional(),
    config::table_key<measures_table>("measures", "intensity measures of the waves").optional(),
    config::table_key<statistics_table>("statistics", "confidence intervals and stopping rules").optional(),
    config::table_key<site_table>("site", "surroundings: other casks, walls, edge of the pad").optional(),
    config::tables_key<limit_table>("limits", "further limit states besides overturning").optional(),
    config::table_key<rare_keys_table>("rare", "rare events").optional(),
    config::table_key<accuracy_table>("accuracy", "numerical accuracy of trials").optional()};

/// Text on the cover of a page. It decides no number: whoever changes it keeps every trial.
inline constexpr std::array cover_keys{campaign_keys["title"],   campaign_keys["question"], campaign_keys["prepared"],
                                       campaign_keys["checked"], campaign_keys["approved"], campaign_keys["revision"]};

}  // namespace overturn
