/// Fourier integrals of acceleration that is exactly linear between samples: no leakage rule, no oscillator run.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace overturn {

/// Filon's weights for straight lines between samples, x = w dt.
struct HatWeights {
    std::complex<double>
        right;         ///< int_0^1 (1-s) exp(-ixs) ds: the half hat of a first sample; its conjugate: a last one
    double whole = 1;  ///< right + conj(right): the hat of a sample between others

    /// Relative error below 1e-15 for any x >= 0, x -> 0 included.
    explicit HatWeights(double x);
};

/// int a exp(-iwt) dt over the whole wave [m/s], t = 0 at the first sample; one value per frequency [rad/s], w = 0
/// included. Few frequencies are summed in blocks that share one table of phases, many by one fast transform: within
/// 1e-12 of the integral of |a| on 1e6 samples.
[[nodiscard]] std::vector<std::complex<double>> fourier_amplitudes(std::span<double const> acceleration_mps2,
                                                                   double time_step_s,
                                                                   std::span<double const> frequencies_radps);

/// One frequency of fourier_amplitudes.
[[nodiscard]] std::complex<double> fourier_amplitude(std::span<double const> acceleration_mps2, double time_step_s,
                                                     double frequency_radps);

}  // namespace overturn
