/// An interval as texts of results write it: its ends rounded outward, so that it may be quoted as it stands.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "stats/proportion.hpp"

namespace overturn::output {

/// "[0.0418, 0.269]".
[[nodiscard]] inline std::string interval_text(Interval const& interval) {
    return fmt::format("[{:.3g}, {:.3g}]", rounded_down(interval.lower), rounded_up(interval.upper));
}

/// Interval of a probability in columns: "[0.041799, 0.268702]".
[[nodiscard]] inline std::string millionths_text(Interval const& interval) {
    constexpr double millionth = 1e-6;
    constexpr double noise = 1e-6;  // of a millionth: 0.25 stays 0.25
    return fmt::format("[{:.6f}, {:.6f}]", std::floor(interval.lower / millionth + noise) * millionth,
                       std::ceil(interval.upper / millionth - noise) * millionth);
}

}  // namespace overturn::output
