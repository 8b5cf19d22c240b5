/// Sinusoidal shaking, one wave for each frequency of a sweep.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// a(t) = amplitude sin(2 pi f t). Keys of [waves]: amplitude; one of frequency, period, frequencies, periods (the n-th
/// wave takes the n-th entry); cycles or duration; time_step (default 0.01 s); ramp (default 0 s: grows and fades
/// linearly over the first and last so many seconds). The last sample lies within half a time step of the end.
extern config::KeyTable const harmonic_table;
[[nodiscard]] std::unique_ptr<WaveSource> make_harmonic(config::Table const& waves, InputFiles& files);

/// The one period or the list of them that a table states under any one of the given keys, frequencies turned into
/// periods [s]. \throws InputError unless exactly one key is there and all values are positive.
extern config::KeyTable const grid_table;  ///< keys `period` and `periods` of waves on a grid
[[nodiscard]] std::vector<double> read_periods(config::Table const& waves, bool frequencies_too);

}  // namespace overturn
