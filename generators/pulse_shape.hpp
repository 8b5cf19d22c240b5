/// Forms of single pulses, by their published formulas, and their samples.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "config/registry.hpp"

namespace overturn {

/// The one shape that has parameters.
inline constexpr char const* parametric_pulse = "mavroeidis-papageorgiou";

/// Parameters of `mavroeidis-papageorgiou` besides its period; the other shapes ignore them.
struct PulseParameters {
    double gamma = 2;      ///< duration in periods, above 1 [-]
    double phase_rad = 0;  ///< nu
};

/// One pulse of peak 1 and period T, from u = t/T = 0 to u = `length`.
struct PulseShape {
    double length;   ///< duration over period [-]
    double quarter;  ///< samples must hit whole multiples of this u: the ends and, where one may, the peaks
    bool jumps;      ///< from rest at its beginning and back to rest at its end
    std::function<double(double u)> at;
};

using PulseShapeMaker = PulseShape (*)(PulseParameters const& parameters);

/// one-sine sin(2 pi u), one-cosine cos(2 pi u), u to 1; half-sine sin(2 pi u), u to 1/2; rectangle 1, u to 1;
/// ricker (1 - 2 v) exp(-v), v = (pi (u-2))^2, u to 4 (Ricker 1953);
/// antisymmetric-ricker x (x^2 - 3) exp(-x^2/2) over its peak, x = 2 pi (u - length/2) / sqrt 3, u to 4.91 (Ricker 1944
/// as in Vassiliou and Makris 2011);
/// mavroeidis-papageorgiou: acceleration of the velocity [1 + cos(2 pi w/gamma)] cos(2 pi w + nu), w = u - gamma/2,
/// over its peak, u to gamma (Mavroeidis and Papageorgiou 2003, eqs 3 and 4).
[[nodiscard]] std::span<config::Entry<PulseShapeMaker> const> pulse_shapes();

/// Samples of a pulse of peak 1; half of the first and of the last value where it jumps.
struct SampledPulse {
    double time_step_s;
    std::vector<double> values;
};

/// \param longest_step_s the time step is shortened so that samples hit ends and peaks
[[nodiscard]] SampledPulse sample_pulse(PulseShape const& shape, double period_s, double longest_step_s);

/// The same of a motion that begins and ends with the pulse: ends that jump have their whole value, and no chord.
[[nodiscard]] SampledPulse sample_pulse_alone(PulseShape const& shape, double period_s, double longest_step_s);

}  // namespace overturn
