/// The estimator that a problem calls for, and another one where the first cannot be trusted.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rare/pulse_mixture.hpp"
#include "rare/subset.hpp"

namespace overturn::rare {

/// From here on plain trials are as good as anything.
inline constexpr double common_probability = 1e-2;
/// Plain waves by which the mixture, where it is asked for, finds factors at which nearly all fail.
inline constexpr std::int64_t certain_look = 200;

/// Record of the stages behind the estimates: enough to draw every trial again.
struct Record {
    std::vector<PulseResult> mixtures;
    std::vector<SubsetResult> subsets;
};

/// Estimates at all factors of one limit state, in their order. \param method empty: crude where P >= 1e-2; the pulse
/// mixture for what is rarer if the problem has a frame; what that cannot be trusted with, with pulses of its own; what
/// is then left, and all of a problem without a frame, by subset simulation. The pulse mixture, where it is asked for,
/// leaves to plain trials what nine in ten of 200 waves pass. \pre the request's problem is below 2^16
[[nodiscard]] std::vector<Estimate> estimate(Problem const& problem, std::span<double const> factors,
                                             std::optional<Method> method, Request const& request, Workforce& workers,
                                             Record* record = nullptr);

}  // namespace overturn::rare
