/// Single pulses of acceleration, for closed-form checks and period sweeps.
#pragma once

#include <memory>
#include <span>

#include "generators/wave_source.hpp"

namespace overturn {

/// One pulse of peak 1 and period T, from u = t/T = 0 to u = `length`.
struct PulseShape {
    double length;   ///< duration over period [-]
    double quarter;  ///< samples must hit whole multiples of this u: the ends and the peaks
    double (*at)(double u);
};

/// one-sine sin(2 pi u), u to 1; half-sine sin(2 pi u), u to 1/2; ricker (1 - 2 v) exp(-v), v = (pi (u-2))^2, u to 4;
/// rectangle 1, u to 1.
[[nodiscard]] std::span<config::Entry<PulseShape> const> pulse_shapes();

/// What [waves] may state of them.
extern config::KeyTable const pulse_table;

/// The n-th wave is of the n-th period. The time step is shortened so that samples hit the pulse's ends and peaks.
/// A rectangle's ends are ramps of two steps centred on them, at half the amplitude: its area is amplitude x period
/// exactly; it begins at least one step after 0.
[[nodiscard]] std::unique_ptr<WaveSource> make_pulse(config::Table const& waves, InputFiles& files);

}  // namespace overturn
