/// Sums of products of a signal with short kernels at every sample, backwards and forwards in time.
#pragma once

#include <span>
#include <vector>

namespace overturn {

struct SlidingProducts {
    std::vector<double> before;  ///< at n: sum_{d=1}^{m} kernel[d-1] signal[n-d]
    std::vector<double> after;   ///< at n: sum_{d=1}^{m} kernel[d-1] signal[n+d]
};

/// One pair per kernel, all of one length m; samples beyond the ends count as zero. Overlapping blocks of fast Fourier
/// transforms: errors stay within a block, relative to its largest sample.
[[nodiscard]] std::vector<SlidingProducts> sliding_products(std::span<double const> signal,
                                                            std::span<std::vector<double> const> kernels);

}  // namespace overturn
