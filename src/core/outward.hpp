/// Numbers rounded to the side that is safe to quote.
#pragma once

#include <cmath>

namespace overturn {

/// \param digits significant ones \return the nearest number of so many digits that is not below (above) `value`
[[nodiscard]] inline double rounded_up(double value, int digits = 3) {
    if (value == 0 || !std::isfinite(value)) {
        return value;
    }
    constexpr double noise = 1e-12;  // a number that has so few digits stays as it is
    auto const place = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::ceil(value * place - noise * std::abs(value * place)) / place;
}
[[nodiscard]] inline double rounded_down(double value, int digits = 3) { return -rounded_up(-value, digits); }

}  // namespace overturn
