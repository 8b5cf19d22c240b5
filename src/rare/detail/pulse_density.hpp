/// Likelihood of a wave under a pulse, relative to none.
#pragma once

#include <span>

namespace overturn::rare {

/// sum_j arrival[j] mean over kappa in pulse_strengths of exp(-kappa^2 square / 2) cosh(kappa correlation[j]), in
/// an order of its own that is the same on every machine. \pre sizes agree and are a multiple of 8
[[nodiscard]] double pulse_density(std::span<double const> arrival, std::span<double const> correlation, double square);

}  // namespace overturn::rare
