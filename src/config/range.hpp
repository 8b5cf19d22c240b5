/// The values a number of a campaign may have.
#pragma once

#include <limits>
#include <string>

namespace overturn::config {

/// The allowed values of a number, in SI units.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;   ///< true: low itself is refused
    bool high_open = false;  ///< true: high itself is refused

    [[nodiscard]] static constexpr Range any() { return {}; }
    [[nodiscard]] static constexpr Range positive() { return {.low = 0, .low_open = true}; }
    [[nodiscard]] static constexpr Range not_negative() { return {.low = 0}; }
    [[nodiscard]] static constexpr Range between(double low, double high) { return {.low = low, .high = high}; }

    [[nodiscard]] bool holds(double value) const;
    [[nodiscard]] std::string text() const;
};

}  // namespace overturn::config
