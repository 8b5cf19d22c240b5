/// Random waves, or measured ones, whose response spectrum follows a target.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// Keys of [waves]: duration, time_step (default 0.01 s), match, match_tolerance (0.05: mean misfit over all periods
/// and over any decade), match_iterations (40), amplitudes (fixed | gaussian), acceptance (acceptance_rules). Tables:
/// waves.target (read_target, and `longest`: the longest matched period, by default the target's last but at most 10 s,
/// up to 20 s), waves.envelope (read_envelope), waves.vertical and waves.transverse (`ratio` of the horizontal target,
/// or a `target` of its own; phases of their own), waves.seed (keys of the records source: measured motions take the
/// place of random draws, keep their phases, and need no envelope).
///
/// match = each: every wave is iterated to the target. ensemble: drawn from a density that is calibrated once, from the
/// campaign's text alone, so that the median spectrum of many waves meets the target; single waves scatter as noise
/// does (amplitudes are gaussian unless stated). none: drawn from the density as the formula gives it. Matching each
/// wave takes wave-to-wave variability away and makes fragility curves too steep.
///
/// Components other than the horizontal one are drawn anew, up to eight times, until no correlation exceeds 0.16.
extern config::KeyTable const spectrum_compatible_table;
[[nodiscard]] std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files);

}  // namespace overturn
