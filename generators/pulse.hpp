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

/// Keys of [waves]: shape, amplitude, period or periods (the n-th wave takes the n-th), time_step (default 0.005 s: an
/// upper bound, shortened so that samples hit the pulse's ends and peaks), quiet_before, quiet_after (default 0 s).
/// A rectangle's ends are ramps of two steps centred on them, at half the amplitude: its area is amplitude x period
/// exactly; it begins at least one step after 0.
extern config::KeyTable const pulse_table;
[[nodiscard]] std::unique_ptr<WaveSource> make_pulse(config::Table const& waves, InputFiles& files);

}  // namespace overturn
