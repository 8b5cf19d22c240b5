/// The baseline of drawn waves: the ground ends at rest where it began, and does not wander off in between.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generators/detail/real_fft.hpp"

namespace overturn {

/// Removes motion slower than twice the longest period that a wave is drawn for: the skirts of its lines under the
/// envelope, and the correction that brings it to rest. It is some 0.01 m/s2, and most of the displacement. Removed is
/// g''(t), with g(t) the displacement behind a zero-phase Butterworth low-pass of order 4, 1 / (1 + (f / corner)^8),
/// the complement of the high-pass filter of records. The displacement is continued evenly beyond both ends (a cosine
/// series: no pads). g is the nearest to it for which g and g'' vanish there too; g' does in every cosine.
class HighPassBaseline {
  public:
    /// \param longest_s period [s] that stays, by 0.4 % of its displacement; the corner lies at twice that
    HighPassBaseline(std::size_t samples, double time_step_s, double longest_s);

    /// Corrects a wave of so many samples in place; velocity and displacement after the last one are 0.
    /// One shorter than the longest period, or of a few samples, is brought to rest and no more.
    void correct(std::span<double> acceleration_mps2) const;

  private:
    [[nodiscard]] std::vector<double> on_nodes(std::span<double const> acceleration_mps2) const;
    [[nodiscard]] std::vector<double> slow(std::vector<double> series) const;

    [[nodiscard]] std::size_t first_of(std::size_t node) const;

    RealFft fft_;                   // of the nodes, there and back
    double per_span_;               // samples from one node to the next: the last node is the last sample
    std::vector<double> low_pass_;  // of cosine m, m half turns over the nodes
    // Of the polynomials that bring the ground to rest: sums on the nodes.
    std::vector<double> bump_, wave_;
};

/// Share of the power of the displacement behind an acceleration that is slower than `period_s`, 0 to 1 [-].
[[nodiscard]] double slow_share(std::span<double const> acceleration_mps2, double time_step_s, double period_s);

}  // namespace overturn
