/// Random motions of two components.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "core/units.hpp"
#include "spatial/cases.hpp"

namespace overturn::testing {

/// Noise of 40 s along both axes, with a peak of 1 m/s2 along each.
class TwoNoises {
  public:
    [[nodiscard]] Shaking shaking(double level) const { return {x_, y_, step_s, level}; }
    explicit TwoNoises(std::mt19937_64& random) : x_(drawn(random)), y_(drawn(random)) {}
    [[nodiscard]] TwoNoises turned(double angle_rad) const {
        auto other = *this;
        double const c = std::cos(angle_rad);
        double const s = std::sin(angle_rad);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            other.x_[i] = c * x_[i] - s * y_[i];
            other.y_[i] = s * x_[i] + c * y_[i];
        }
        return other;
    }

  private:
    static constexpr double step_s = 0.01;
    // Filtered by a soil of 1.8 Hz, below 0.2 Hz and above 8 Hz, with a peak of 1.
    static std::vector<double> drawn(std::mt19937_64& random) {
        std::vector<double> wave(4001, 0.0);
        constexpr int lines = 80;
        for (int k = 0; k < lines; ++k) {
            double const f = 0.08 * std::pow(150.0, (k + 0.5) / lines);
            double const phase = 2 * pi * static_cast<double>(random() >> 11U) * 0x1p-53;
            double const r = 0.55 * f;
            double const z2 = 1.44 * r * r;
            double const q2 = 36 * f * f;
            double const power = (1 + z2) / ((1 - r * r) * (1 - r * r) + z2) * q2 * q2
                                 / ((1 - q2) * (1 - q2) + 1.44 * q2) / std::pow(1 + f * f / 64, 2);
            for (std::size_t i = 0; i < wave.size(); ++i) {
                wave[i] += std::sqrt(power * f) * std::cos(2 * pi * f * step_s * static_cast<double>(i) + phase);
            }
        }
        double peak = 0;
        for (std::size_t i = 0; i < wave.size(); ++i) {
            double const t = step_s * static_cast<double>(i);
            wave[i] *= std::min({1.0, t * t / 16, std::exp(-0.12 * (t - 20)), (40 - t) / 3});
            peak = std::max(peak, std::abs(wave[i]));
        }
        for (double& value : wave) {
            value /= peak;
        }
        return wave;
    }

    std::vector<double> x_, y_;
};

inline std::vector<TwoNoises> noises(std::size_t count) {
    std::mt19937_64 random(606);
    std::vector<TwoNoises> waves;
    for (std::size_t i = 0; i < count; ++i) {
        waves.emplace_back(random);
    }
    return waves;
}

}  // namespace overturn::testing
