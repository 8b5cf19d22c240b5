/// A first look at a limit state: the factor at which it is common, and whether its driver leads there.
#pragma once

#include <cstdint>
#include <string>

#include "rare/crude.hpp"

namespace overturn::rare {

struct Scouted {
    double factor = 0;  ///< factor at which failure is common, at least the first one
    Count count{};      ///< of plain trials at that factor
    Count at_first{};   ///< of those at the factor it began with
    double missed = 0;  ///< share of failures that lie below the highest 2 x failures of the driver [-]
    std::int64_t runs = 0;
    bool found = false;
    std::string reason{};  ///< why not
};

/// Largest share of failures that a nested driver may miss. Peak energy misses none, window energy a third.
inline constexpr double most_missed = 0.02;

/// Waves of an attempt at one factor.
inline constexpr std::int64_t scout_trials = 2048;

/// Raises the factor from `factor` on by a seventh at a time until one wave in twenty fails. Plain trials.
[[nodiscard]] Scouted scout(Problem const& problem, double factor, Request const& request, Workforce& workers);

}  // namespace overturn::rare
