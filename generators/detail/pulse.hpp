/// Single pulses of acceleration, for closed-form checks and period sweeps.
#pragma once

#include <memory>

#include "generators/pulse_shape.hpp"
#include "generators/wave_source.hpp"

namespace overturn {

/// Their keys in [waves].
extern config::KeyTable const pulse_table;

/// The n-th wave is of the n-th period. The time step is shortened so that samples hit the pulse's ends and peaks.
/// Ends of a pulse that jumps, as a rectangle's, are ramps of two steps centred on them, at half the amplitude: a
/// rectangle's area is amplitude x period exactly; it begins at least one step after 0.
[[nodiscard]] std::unique_ptr<WaveSource> make_pulse(config::Table const& waves, InputFiles& files);

}  // namespace overturn
