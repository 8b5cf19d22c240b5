/// sum_j a_j exp(-i x j) at many arbitrary x that are slow beside the samples.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "spectra/detail/phase_sums.hpp"

namespace overturn {

/// The same sums as PhaseSums, as exact. Where every |x| is below pi / 4 and the signal is longer than a few kernels,
/// it is first smoothed by a Kaiser-Bessel kernel that leaves nothing of what thinning would fold onto them, then
/// thinned; each sum is divided by the kernel's own. The fastest x decides the thinning, and so the last bits of all.
/// All that does not depend on the signal is prepared once.
class ThinnedSums {
  public:
    /// \param samples of every signal
    ThinnedSums(std::size_t samples, std::span<double const> x);

    /// One sum per x. \pre as many samples as stated
    [[nodiscard]] std::vector<std::complex<double>> of(std::span<double const> signal) const;

  private:
    [[nodiscard]] std::vector<double> thinned(std::span<double const> signal) const;

    std::size_t samples_;
    std::size_t stride_ = 1;      ///< samples to one of the thinned signal; 1: nothing is thinned
    std::size_t half_ = 0;        ///< of the kernel
    std::size_t length_ = 0;      ///< of the thinned signal
    std::vector<double> kernel_;  ///< filled up with zeros
    std::vector<std::complex<double>> scale_;
    std::optional<PhaseSums> sums_;
};

}  // namespace overturn
