/// Closed forms of the linearised rocking block, with which the tests and `overturn qualify` compare the integration;
/// steady_harmonic_rotation is also the paper's Eq. 1.
#pragma once

namespace overturn {

/// Steady rocking under a = A sin(omega t), symmetric with one impact per half cycle (Spanos & Koh 1984).
struct HarmonicCase {
    double frequency_ratio = 0;  ///< sigma = omega / p
    double amplitude_ratio = 0;  ///< k = A / (g alpha)
    double restitution = 1;      ///< delta
};

/// theta / alpha in the middle of the half cycle; the true maximum is 0.03-0.75 % larger.
/// \throws InputError outside P^2 + 1 >= Q^2, where this steady state does not exist, or for sigma, k <= 0.
[[nodiscard]] double steady_harmonic_rotation(HarmonicCase const& c);

/// p times the period of undamped free rocking from phi0 = theta0/alpha: 4 acosh(1/(1 - phi0)) (Housner 1963, eq. 5).
/// \throws InputError unless 0 < phi0 < 1
[[nodiscard]] double free_rocking_period(double phi0);

/// Amplitude ratio after n impacts: 1 - sqrt(1 - e^2n [1 - (1 - phi0)^2]) (Housner 1963, eq. 8, with e = omega ratio).
[[nodiscard]] double free_rocking_amplitude(double phi0, double restitution, int impacts);

/// p times the longest rectangular pulse of height a = ratio g alpha that does not overturn:
/// cosh(p t) = 1 + 1 / [2 ratio (ratio - 1)] (Housner 1963, eq. 10). \throws InputError unless ratio > 1
[[nodiscard]] double rectangular_pulse_limit(double amplitude_ratio);

/// Amplitude over alpha g from which so many half cycles of a sine overturn the linearised block without an impact: it
/// uplifts at the phase x, of sine alpha g over the amplitude, and is at balance when the pulse ends:
/// cos x -/+ exp((x - n pi) p/omega) = (omega/p) sin x (Shi and others 1996 for one half cycle, Zhang and Makris 2001
/// for two).
[[nodiscard]] double sine_without_impact(double omega_over_p, int half_cycles);

}  // namespace overturn
