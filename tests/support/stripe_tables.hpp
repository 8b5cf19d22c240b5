/// Tables of amplitude, trials and overturned as stripes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "stats/stripe.hpp"

namespace overturn::testing {

inline std::vector<Stripe> table_of(std::vector<std::array<std::int64_t, 3>> const& rows) {
    std::vector<Stripe> stripes;
    stripes.reserve(rows.size());
    for (auto const& [amplitude, trials, overturned] : rows) {
        stripes.push_back({.amplitude = static_cast<double>(amplitude), .trials = trials, .overturned = overturned});
    }
    return stripes;
}

}  // namespace overturn::testing
