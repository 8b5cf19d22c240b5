/// Measured waves, from files.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// Wave n is record n. Keys of [waves]: `files`, a list of names with unit, format and time_step for all of them; or
/// `records`, a list of tables ([[waves.records]]) with horizontal, transverse, vertical (names, the last two
/// optional), unit, format and time_step each. `unit` and `time_step` are for files that do not state them; `format` is
/// a name of record_formats() or "auto". Components from several files need one time step and are cut to the shortest
/// of them, which the wave's label then says. Nothing is filtered, shifted or corrected. All files are read at once,
/// here.
[[nodiscard]] std::unique_ptr<WaveSource> make_records(config::Table const& waves, InputFiles& files);

}  // namespace overturn
