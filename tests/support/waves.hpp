/// Waves that tests make for themselves, by formula.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace overturn::testing {

/// A sum of 40 sinusoids between 0.1 and 15 Hz under a rise of 5 s and a slow decay; nothing in it is round.
inline std::vector<double> broad_wave(std::size_t samples, double time_step_s) {
    std::vector<double> wave(samples, 0.0);
    for (std::size_t n = 0; n < samples; ++n) {
        double const t = time_step_s * static_cast<double>(n);
        double sum = 0;
        for (int k = 0; k < 40; ++k) {
            double const frequency = 0.1 * std::pow(150.0, (k + 0.5) / 40);
            sum += std::sin(6.283185307179586 * (frequency * t + 0.6180339887498949 * k * k));
        }
        wave[n] = 0.3 * std::min(1.0, t / 5) * std::exp(-0.01 * t) * sum;
    }
    return wave;
}

}  // namespace overturn::testing
