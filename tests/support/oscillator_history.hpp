/// The motion of one oscillator, sample by sample: what the sweeps over many of them are held to.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/units.hpp"
#include "spectra/oscillator.hpp"

namespace overturn::testing {

/// Relative motion at the samples, starting at rest.
struct OscillatorHistory {
    std::vector<double> displacement_m;     ///< y [m]
    std::vector<double> velocity_mps;       ///< y' [m/s]
    std::vector<double> acceleration_mps2;  ///< absolute: y'' + a = -(2 zeta w y' + w^2 y) [m/s2]
};

/// \pre the period is positive
[[nodiscard]] inline OscillatorHistory oscillator_history(std::span<double const> acceleration_mps2, double time_step_s,
                                                          double period_s, double damping) {
    double const w = 2 * pi / period_s;
    OscillatorStep const step(w, damping, time_step_s);
    auto const n = acceleration_mps2.size();
    OscillatorHistory history{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    double y = 0;
    double v = 0;
    for (std::size_t i = 1; i < n; ++i) {
        double const a0 = acceleration_mps2[i - 1];
        double const a1 = acceleration_mps2[i];
        double const y1 = step.yy * y + step.yv * v + step.ya0 * a0 + step.ya1 * a1;
        v = step.vy * y + step.vv * v + step.va0 * a0 + step.va1 * a1;
        y = y1;
        history.displacement_m[i] = y;
        history.velocity_mps[i] = v;
        history.acceleration_mps2[i] = -(2 * damping * w * v + w * w * y);
    }
    return history;
}

}  // namespace overturn::testing
