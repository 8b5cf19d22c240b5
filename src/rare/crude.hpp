/// Crude Monte Carlo: plain trials, counted. The only estimator that assumes nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rare/draw_key.hpp"
#include "rare/estimate.hpp"
#include "rare/problem.hpp"
#include "rare/workforce.hpp"

namespace overturn::rare {

/// Largest number of factors for one set of waves: one bit each in a stored row.
inline constexpr std::size_t most_factors = 64;

/// Request to an estimator.
struct Request {
    std::uint64_t seed = 0;
    std::uint64_t problem = 0;           ///< number of the limit state within the campaign
    double target_cov = 0.1;             ///< wanted standard error over probability
    std::int64_t max_runs = 10'000'000;  ///< of waves, per estimator
    std::int64_t replicates = 8;
};

/// Plain trials of a stage at several factors of the same waves. \param key of the stage; `first` to first + trials are
/// the indices. \pre at most most_factors
[[nodiscard]] std::vector<Count> count_failures(Problem const& problem, std::span<double const> factors, DrawKey key,
                                                std::int64_t first, std::int64_t trials, std::string const& name,
                                                Workforce& workers);

/// Fewer failures than this say no more than a bound.
inline constexpr std::int64_t fewest_failures = 10;

/// Waves of the first look at a factor by plain trials.
inline constexpr std::int64_t plain_look = 4000;

/// The same waves for all factors, as many as the rarest of them needs, within max_runs.
[[nodiscard]] std::vector<Estimate> estimate_crude(Problem const& problem, std::span<double const> factors,
                                                   Request const& request, Workforce& workers);

}  // namespace overturn::rare
