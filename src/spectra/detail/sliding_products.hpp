/// Sums of products of a signal with short kernels at every sample, backwards and forwards in time.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace overturn {

struct SlidingProducts {
    std::vector<double> before;  ///< at n: sum_{d=1}^{m} kernel[d-1] signal[n-d]
    std::vector<double> after;   ///< at n: sum_{d=1}^{m} kernel[d-1] signal[n+d]
};

/// Kernels, all of one length m, ready for signals of one length; samples beyond the ends count as zero. Overlapping
/// blocks of fast Fourier transforms: errors stay within a block, relative to its largest sample.
class SlidingKernels {
  public:
    SlidingKernels(std::span<std::vector<double> const> kernels, std::size_t samples);

    /// One pair per kernel. \pre as many samples as stated
    [[nodiscard]] std::vector<SlidingProducts> products(std::span<double const> signal) const;

  private:
    std::size_t taps_, samples_, size_ = 0;
    std::vector<std::vector<std::complex<double>>> responses_;
};

}  // namespace overturn
