/// The Fourier integral of a wave at one frequency.
#pragma once

#include <complex>
#include <span>

#include "spectra/detail/fourier.hpp"

namespace overturn::testing {

/// One frequency of fourier_amplitudes.
[[nodiscard]] inline std::complex<double> fourier_amplitude(std::span<double const> acceleration_mps2,
                                                            double time_step_s, double frequency_radps) {
    return fourier_amplitudes(acceleration_mps2, time_step_s, std::span(&frequency_radps, 1)).front();
}

}  // namespace overturn::testing
