/// Sinusoidal shaking, one wave for each frequency of a sweep.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// Their keys in [waves].
extern config::KeyTable const harmonic_table;

/// a(t) = amplitude sin(2 pi f t), the n-th wave of the n-th frequency or period. The ramp grows and fades linearly.
/// The last sample lies within half a time step of the end.
[[nodiscard]] std::unique_ptr<WaveSource> make_harmonic(config::Table const& waves, InputFiles& files);

/// Keys `period` and `periods` of waves on a grid.
extern config::KeyTable const grid_table;

/// The one period or the list of them that a table states under any one of the given keys, frequencies turned into
/// periods [s]. \throws InputError unless exactly one key is there and all values are positive.
[[nodiscard]] std::vector<double> read_periods(config::Table const& waves, bool frequencies_too);

}  // namespace overturn
