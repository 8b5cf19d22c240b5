/// Two motions by formula, 164 s at 0.01 s, long-period (A) and broad-band (B), each with a peak of 1 m/s2.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace overturn::testing {

struct SoilFilter {
    double period_s;
    double damping;
};
inline constexpr SoilFilter set_a{3.3, 0.8};
inline constexpr SoilFilter set_b{0.45, 0.3};

/// sum of 160 cosines with a Kanai-Tajimi type spectrum and golden-ratio phases under a trapezoid-like envelope.
inline std::vector<double> filtered_wave(SoilFilter const& soil) {
    constexpr std::size_t samples = 16384;
    constexpr double dt = 0.01;
    std::vector<double> a(samples, 0.0);
    for (int k = 0; k < 160; ++k) {
        double const f = 0.05 * std::pow(160.0, (k + 0.5) / 160);
        double const golden = 0.6180339887498949 * k * k;
        double const phase = 2 * std::numbers::pi * (golden - std::floor(golden));
        double const r = f * soil.period_s;
        double const q = 14 * f;
        double const z2 = 4 * soil.damping * soil.damping * r * r;
        double const q2 = q * q;
        double const s = (1 + z2) / ((1 - r * r) * (1 - r * r) + z2) * (q2 * q2) / ((1 - q2) * (1 - q2) + 1.44 * q2)
                         / ((1 + f * f / 25) * (1 + f * f / 25));
        double const amplitude = std::sqrt(s * f);
        for (std::size_t i = 0; i < samples; ++i) {
            a[i] += amplitude * std::cos(2 * std::numbers::pi * f * static_cast<double>(i) * dt + phase);
        }
    }
    double peak = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        double const t = static_cast<double>(i) * dt;
        double envelope = t < 10 ? t * t / 100 : t < 60 ? 1.0 : std::exp(-0.03 * (t - 60));
        if (t > 153.84) {
            envelope *= std::max(0.0, (163.84 - t) / 10);
        }
        a[i] *= envelope;
        peak = std::max(peak, std::abs(a[i]));
    }
    for (double& value : a) {
        value /= peak;
    }
    a[0] = 0;
    return a;
}

/// The levels of set A: rest, scarcely rocking, rocking, overturning [m/s2].
inline std::vector<double> levels_a() {
    std::vector<double> levels{2.3, 2.45};
    for (int i = 0; i < 14; ++i) {
        levels.push_back(2.52 + (3.52 - 2.52) * i / 13.0);
    }
    for (int i = 0; i < 8; ++i) {
        levels.push_back(3.6 * std::pow(12 / 3.6, i / 7.0));
    }
    return levels;
}

/// The levels of set B: dense rocking, hundreds of impacts [m/s2].
inline std::vector<double> levels_b() {
    std::vector<double> levels;
    for (int i = 0; i < 24; ++i) {
        levels.push_back(3.0 + (4.8 - 3.0) * i / 23.0);
    }
    return levels;
}

}  // namespace overturn::testing
