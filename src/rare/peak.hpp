/// The largest of many samples, not one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace overturn::rare {

/// max |x|; 0 of none. Eight maxima at a time: one alone would wait for itself at every sample.
[[nodiscard]] inline double peak_of_wave(std::span<double const> wave) {
    constexpr std::size_t together = 8;
    std::array<double, together> most{};
    std::size_t i = 0;
    for (; i + together <= wave.size(); i += together) {
        for (std::size_t lane = 0; lane < together; ++lane) {
            double const x = std::abs(wave[i + lane]);
            most[lane] = most[lane] < x ? x : most[lane];
        }
    }
    for (; i < wave.size(); ++i) {
        most[0] = std::max(most[0], std::abs(wave[i]));
    }
    return *std::max_element(most.begin(), most.end());
}

}  // namespace overturn::rare
