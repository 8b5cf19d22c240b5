/// Similar failing waves, put together.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace overturn::rare {

using Lines = std::vector<std::complex<double>>;

struct Groups {
    std::vector<std::size_t> of;  ///< group of every wave
    std::vector<Lines> means;     ///< of the groups, brought nearer to the mean of all by what chance explains
};

/// Weighted k-means of aligned waves. It starts from all waves in one group, the heaviest group being parted again and
/// again where it is widest: an outlier, whose weight is small, founds no group of its own. \pre at least one wave
[[nodiscard]] Groups grouped(std::vector<Lines> const& waves, std::span<double const> weights, std::size_t count);

}  // namespace overturn::rare
