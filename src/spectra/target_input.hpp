/// How a campaign states a target spectrum.
#pragma once

#include "config/table.hpp"
#include "core/input_files.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Reads one of: `spectrum` (a named target, with `pga` where it is printed for 1 g); `kind` with `points`; `kind` with
/// `file`. Also `damping` (default 0.05), `scale` and `time_scale` (default 1). `points` and `file` hold periods in s
/// and values in m/s2, m/s or m, or in `unit`; `points` may carry units instead, a file's header may state them. Waves
/// are matched at `damping`; a spectrum that is stated for another one says so in `stated_damping` and is carried over
/// by `damping_rule` (damping_rules), which has no default. Reads nothing else and does not call finish(). \throws
/// InputError at the key concerned.
extern config::KeyTable const target_table;
[[nodiscard]] TargetSpectrum read_target(config::Table const& table, InputFiles& files);

}  // namespace overturn
