/// Tables of amplitude, trials and overturned as stripes, and their fits.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "stats/fragility.hpp"

namespace overturn::testing {

inline std::vector<Stripe> table_of(std::vector<std::array<std::int64_t, 3>> const& rows) {
    std::vector<Stripe> stripes;
    stripes.reserve(rows.size());
    for (auto const& [amplitude, trials, overturned] : rows) {
        stripes.push_back({.amplitude = static_cast<double>(amplitude), .trials = trials, .overturned = overturned});
    }
    return stripes;
}

inline FragilityFit fit_of(std::vector<Stripe> const& stripes, std::vector<Quote> quotes = {}, double beta_u = 0) {
    FragilityRequest request;
    request.quotes = std::move(quotes);
    request.beta_u = beta_u;
    return fit_fragility(FragilityData::of_stripes(stripes), request);
}

}  // namespace overturn::testing
