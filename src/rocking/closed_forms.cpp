#include "rocking/closed_forms.hpp"

#include <cmath>

#include "core/boundary.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {

double steady_harmonic_rotation(HarmonicCase const& c) {
    validate(c.frequency_ratio > 0 && c.amplitude_ratio > 0 && c.restitution > 0 && c.restitution <= 1,
             "harmonic case sigma {}, k {}, restitution {} (sigma and k must be positive, restitution in (0, 1])",
             c.frequency_ratio, c.amplitude_ratio, c.restitution);
    double const half = pi / (2 * c.frequency_ratio);  // p times a quarter of the forcing period
    double const C = c.amplitude_ratio / (1 + c.frequency_ratio * c.frequency_ratio);
    double const r = (1 - c.restitution) / (1 + c.restitution);
    double const d = std::tanh(half);
    double const P = r * c.frequency_ratio * d;
    double const Q = r * d * d / C;
    double const inside = P * P + 1 - Q * Q;
    validate(inside >= 0, "harmonic case sigma {}, k {}, restitution {} (no such steady state). Raise k",
             c.frequency_ratio, c.amplitude_ratio, c.restitution);
    return 1 - 1 / std::cosh(half) - C * (P * Q - std::sqrt(inside)) / (P * P + 1);
}

double free_rocking_period(double phi0) {
    validate(phi0 > 0 && phi0 < 1, "start ratio {} (must lie in (0, 1): beyond 1 the block falls)", phi0);
    return 4 * std::acosh(1 / (1 - phi0));
}

double free_rocking_amplitude(double phi0, double restitution, int impacts) {
    double const left = (1 - phi0) * (1 - phi0);
    return 1 - std::sqrt(1 - std::pow(restitution, 2 * impacts) * (1 - left));
}

double rectangular_pulse_limit(double amplitude_ratio) {
    validate(amplitude_ratio > 1, "amplitude ratio {} (at or below 1 the block does not uplift)", amplitude_ratio);
    return std::acosh(1 + 1 / (2 * amplitude_ratio * (amplitude_ratio - 1)));
}

double sine_without_impact(double omega_over_p, int half_cycles) {
    double const end = half_cycles * pi;
    auto const too_late = [&](double x) {
        return std::cos(x) - std::cos(end) * std::exp((x - end) / omega_over_p) <= omega_over_p * std::sin(x);
    };
    return 1 / std::sin(boundary(0, 0.5 * pi, too_late));
}

}  // namespace overturn
