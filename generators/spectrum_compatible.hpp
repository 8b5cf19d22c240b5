/// Random waves, or measured ones, whose response spectrum follows a target.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// Their keys in [waves].
extern config::KeyTable const spectrum_compatible_table;

/// The misfit that a match ends with is the mean one over all periods, and over any decade of them. Measured motions
/// (waves.seed) take the place of random draws, keep their phases, and need no envelope.
///
/// match = each: every wave is iterated to the target. ensemble: drawn from a density that is calibrated once, from the
/// campaign's text alone, so that the median spectrum of many waves meets the target; single waves scatter as noise
/// does (amplitudes are gaussian unless stated). none: drawn from the density as the formula gives it. Matching each
/// wave takes wave-to-wave variability away and makes fragility curves too steep.
///
/// Components other than the horizontal one are drawn anew, up to eight times, until no correlation exceeds 0.16.
[[nodiscard]] std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files);

}  // namespace overturn
