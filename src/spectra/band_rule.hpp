/// The band of periods that matters to a rocking body, and the quadrature over it.
#pragma once

#include <vector>

#include "core/units.hpp"

namespace overturn {

/// The periods a rocking body runs through [s].
struct PeriodBand {
    double t0_s = 0;  ///< the shortest, T0
    double t1_s = 0;  ///< the longest, T1; also the length of the window
};

/// Unit of the length `a` in T0 = 0.05 sqrt(a), T1 = 0.5 sqrt(a). The sources do not print it; only with centimetres
/// does the band span the rocking amplitudes 0.055 to 0.93 of the critical angle by Housner's period.
enum class RadiusUnit { centimetre, metre };
/// "cm" or "m"
[[nodiscard]] constexpr char const* name_of(RadiusUnit unit) { return unit == RadiusUnit::metre ? "m" : "cm"; }
[[nodiscard]] constexpr RadiusUnit other(RadiusUnit unit) {
    return unit == RadiusUnit::metre ? RadiusUnit::centimetre : RadiusUnit::metre;
}

/// Band of a body whose centre of gravity lies `radius_m` from its edge [m]. The factors are the paper's, for `g0`;
/// where gravity differs they go as the body's own periods, as 1 / sqrt(g). A campaign's body:
/// campaign/rocking_band.hpp.
[[nodiscard]] PeriodBand rocking_period_band(double radius_m, RadiusUnit unit = RadiusUnit::centimetre,
                                             double gravity_mps2 = g0);

/// Nodes for int f(T) g(T) dT over the band, f = 2 (T1-T)/(T1-T0)^2, in whole groups of 16: sum weight g(2 pi/w).
struct BandRule {
    std::vector<double> frequency_radps;
    std::vector<double> weight;
};

/// \throws InputError unless 0 < T0 < T1 and the panel phase is positive.
void validate_band(PeriodBand const& band, double panel_phase_rad);

/// Gauss panels of 16 nodes, equal in frequency, none spanning more than `panel_phase_rad` of w `length_s`.
/// \throws as validate_band
[[nodiscard]] BandRule band_rule(PeriodBand const& band, double length_s, double panel_phase_rad);

}  // namespace overturn
