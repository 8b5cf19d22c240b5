/// sum_j a_j exp(-i x j) at a few arbitrary x.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace overturn {

/// Term by term, sixteen x at once. PhaseSums is faster from some sixty x on.
[[nodiscard]] std::vector<std::complex<double>> direct_sums(std::span<double const> signal, std::span<double const> x);

}  // namespace overturn
