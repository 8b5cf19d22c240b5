/// Failing waves -> the pulses that they have in common.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "rare/mixture.hpp"

namespace overturn::rare {

struct FailedWave {
    std::vector<std::complex<double>> lines;  ///< Z_k = x_{2k-2} + i x_{2k-1}, k = 1, 2, ...
    Moment moment;
    double weight = 1;
};

/// Lengths in periods 2 pi / p of the body.
struct FitOptions {
    std::size_t pulses = 8;
    double before = 3.2;  ///< part of a wave kept before it fails; earlier parts have only noise in common
    double after = 0.4;
    double edge = 0.4;                      ///< of the window, half a cosine
    double arrival_kernel = 0.6;            ///< standard deviation of what smooths the times of failure
    double earliest = 0.08, latest = 0.95;  ///< parts of the duration between which a tenth arrives evenly
};

/// Waves are aligned in time and sign, windowed, grouped by weighted k-means from a start that follows from the waves
/// alone. Weights beyond three times their 90 % quantile are cut there, for the fit only. \pre at least one wave
[[nodiscard]] Mixture fit_pulses(PulseFrame const& frame, std::span<FailedWave const> waves, FitOptions const& options);

}  // namespace overturn::rare
