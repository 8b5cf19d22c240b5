/// A mainshock and, after a quiet pause, a second shock of the same source: one wave to everything that follows.
#pragma once

#include <memory>

#include "config/table.hpp"
#include "generators/wave_source.hpp"

namespace overturn {

/// Key `aftershock` of [waves], for waves that are drawn.
extern config::KeyTable const aftershock_table;

/// The source, whose waves [waves.aftershock] lengthens by a pause without shaking and a second, independent wave of
/// its own times `scale`. The first shock keeps every bit of the wave without the key; a body stands, lies or still
/// rocks through the pause as the first shock left it. Intensities, levels, energies, drifts and durations are those of
/// the whole wave; the match and the drawn target reported are the mainshock's; both shocks must pass the source's
/// acceptance rule. A second shock that begins abruptly, under an envelope that does not rise from nothing, leaves the
/// ground moving: quiet and its first sample are joined by a straight line, which adds half of that sample times the
/// step (some 1e-3 m/s).
/// \throws InputError unless the source draws its waves
[[nodiscard]] std::unique_ptr<WaveSource> with_aftershock(config::Table const& waves,
                                                          std::unique_ptr<WaveSource> source);

}  // namespace overturn
