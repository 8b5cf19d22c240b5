/// Target spectrum as a campaign states it.
#pragma once

#include "config/table.hpp"
#include "core/input_files.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Keys of a target.
extern config::KeyTable const target_table;

/// `points` and `file` hold periods in s and values in m/s2, m/s or m, or in `unit`; `points` may carry units instead,
/// a file's header may state them. Waves are matched at `damping`; a spectrum that is stated for another one is carried
/// over by `damping_rule`, which has no default. Does not call finish(). \throws InputError at the key concerned.
/// \param beside the table of the horizontal target: a published spectrum that is printed for 1 g takes its pga where
/// it states none, and is refused where that target has none to take
[[nodiscard]] TargetSpectrum read_target(config::Table const& table, InputFiles& files,
                                         config::Table const* beside = nullptr);

}  // namespace overturn
