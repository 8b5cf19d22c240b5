/// V_WES^2 as a quadratic form of the samples in the window: one kernel over time differences replaces the oscillators.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spectra/band_rule.hpp"
#include "spectra/detail/sliding_products.hpp"

namespace overturn {

/// sum_i weight_i |int over the last `window` samples of a exp(-i w_i t) dt|^2 at every sample [m2/s2], the window cut
/// at the first sample. Equal to the sweep over the oscillators (window_sweep.hpp) to rounding of the strongest part
/// within ten windows, at a cost that hardly depends on the number of frequencies. Products of samples are weighted by
/// K(d) = sum_i weight_i |hat_i|^2 cos(w_i d dt) and summed over each sample's window by fast convolution; the window
/// then slides, one sample in and one out, in twice the working precision, and is summed anew every eighth window. What
/// does not depend on the wave is prepared once.
class WindowKernel {
  public:
    /// \param samples of every wave \pre window >= 1 and time_step_s > 0
    WindowKernel(std::size_t samples, double time_step_s, std::size_t window, BandRule const& rule);

    /// \pre as many samples as stated
    [[nodiscard]] std::vector<double> squares(std::vector<double> acceleration_mps2) const;

  private:
    // Weights of products of two samples, d = 0 ... window samples apart: both inside the window, one at its end, both
    // at its ends.
    struct Weights {
        std::vector<double> inside, edge, edges;
    };
    static Weights weights_of(BandRule const& rule, double time_step_s, std::size_t window);
    [[nodiscard]] double all_pairs(std::span<double const> samples) const;

    std::size_t samples_, window_;
    Weights weights_;
    double edge_alone_ = 0;  // of an edge with itself
    SlidingKernels sliding_;
    std::size_t pairs_size_;
    std::vector<double> pairs_;  // weights of the power of a whole window's transform
};

}  // namespace overturn
