/// The stationary noise whose oscillators peak, on the median, at a target spectrum.
#pragma once

#include <span>
#include <vector>

#include "spectra/target_spectrum.hpp"

namespace overturn {

/// One-sided density G(w) [m2/s3] at rising frequencies [rad/s], from the target's psa through first-passage statistics
/// over `strong_s` seconds (Vanmarcke and Gasparini 1976):
///     G(w) w (pi/(4 z_s) - 1) = (psa/r)^2 - int_0^w G,   z_s = z / (1 - exp(-2 z w strong_s)),
/// r the median peak factor. For an energy target V_E^2 = pi G strong_s, its mean without damping. Where the right side
/// vanishes a hundredth of (psa/r)^2 stands in, so that no line is 0.
[[nodiscard]] std::vector<double> density_of(TargetSpectrum const& target, std::span<double const> frequencies_radps,
                                             double strong_s);

/// Brings `density` to where every oscillator's own variance, int G |H|^2 dw with the same z_s, times its median peak
/// factor gives the target: near a bend of the target the formula above takes the neighbourhood for white, which it is
/// not. Multiplies where it is too low or too high, eight times, judged by periods up to `longest_s`; a target that no
/// noise has is met as far as it can be.
void refine_density(std::vector<double>& density, TargetSpectrum const& target,
                    std::span<double const> frequencies_radps, double strong_s, double longest_s);

}  // namespace overturn
