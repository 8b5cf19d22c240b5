/// Keys of records: their files, and how these are read.
#pragma once

#include <array>

#include "config/table.hpp"
#include "core/units.hpp"
#include "generators/detail/axes.hpp"
#include "generators/record_baseline.hpp"
#include "motion/recording.hpp"
#include "motion/resample.hpp"

namespace overturn {

inline constexpr std::array coarsenings{
    config::Entry<Coarsening>{"finer", "only to a shorter step", Coarsening::refused},
    config::Entry<Coarsening>{"coarser", "also to a longer step", Coarsening::accepted}};
inline constexpr config::Keys reading_keys{
    config::text_key("format", "one of the record formats (overturn list formats); auto: recognised from the content")
        .otherwise("auto"),
    config::text_key(
        "unit",
        R"(unit of the accelerations, if the files do not state it: "gal", "g", "m/s2"; for counts "2.4e-6 m/s2")")
        .optional(),
    config::number_key("time_step", Dimension::time, config::Range::positive(),
                       "time step, if the files do not state it; otherwise the step to which they are resampled")
        .optional(),
    config::text_key("columns", R"(meaning of the columns, if their names do not state it: "time,h1,h2,v")").optional(),
    config::text_key("component", R"(component in the rocking plane, if the file has several: "EW", "NS", ...)")
        .optional(),
    config::word_key<component_choices>("components", "further components that are used").otherwise("file"),
    config::word_key<coarsenings>("resample", "time steps to which records may be resampled").otherwise("finer"),
    baseline_key,
    axes_key,
    config::number_key("scale", Dimension::none, {.low = 0, .high = 1000, .low_open = true}, "factor on all components")
        .otherwise(1),
    config::number_key("time_scale", Dimension::none, {.low = 0, .high = 100, .low_open = true},
                       "factor on the time step, for a scale model")
        .otherwise(1)};
inline constexpr config::KeyTable reading_table{.meaning = "how records are read", .keys = reading_keys.all};
inline constexpr config::Keys record_keys{
    config::text_key("horizontal", "file of the component in the rocking plane"),
    config::text_key("transverse", "file of the other horizontal component").optional(),
    config::text_key("vertical", "file of the vertical component").optional()};
inline constexpr config::KeyTable record_table{
    .meaning = "one record, with one file for each component", .keys = record_keys.all, .also = {&reading_table}};
inline constexpr config::Keys record_files_keys{
    config::text_key("folder", "folder of the files, relative to the campaign").optional(),
    config::texts_key("files", "names of files, one record each; or state records").optional(),
    config::tables_key<record_table>("records", "one table for each record; or state files").optional()};

}  // namespace overturn
