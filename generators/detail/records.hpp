/// Measured waves, from files.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

extern config::KeyTable const records_table;       ///< [waves] of source records
extern config::KeyTable const record_files_table;  ///< keys that choose records and their reading

/// Wave n is record n. Keys of [waves]: `files`, a list of names with the keys below for all of them; or `records`, a
/// list of tables ([[waves.records]]) with horizontal, transverse, vertical (names, the last two optional) and those
/// keys each:
/// - `unit`, `format`: for files that do not state them; `format` is a name of record_formats() or "auto".
/// - `component`: which one of a file of several goes into the rocking plane ("EW", "90 DEG"); by default the first
///   horizontal one.
/// - `components`: "file" (default: every component that the file holds), "horizontal" (one only) or "station" (also
///   those of the same station in the files beside it, see StationFiles).
/// - `time_step`: for files that state none; a record with another step is resampled to it by resample(), to a longer
///   one only with `resample` = "coarser".
/// - `baseline`: how its baseline is corrected (read_baseline; default: not at all), before axes and scale.
/// - `time_scale`: of a model whose time runs so many times the prototype's (s^1/2): the time step times it,
/// accelerations
///   as they are, after baseline and axes (default 1).
/// - `scale`: a factor on all components (default 1).
/// `folder`, of all of them: where the files lie, relative to the campaign unless absolute (default: beside it).
/// Components from several files need one time step and are cut to the shortest of them. The wave's label says which
/// files were used and what was cut, resampled, corrected or scaled. All files are read
/// at once, here.
[[nodiscard]] std::unique_ptr<WaveSource> make_records(config::Table const& waves, InputFiles& files);

}  // namespace overturn
