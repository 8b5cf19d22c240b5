/// sum_j a_j exp(-i x j) at many arbitrary x at once.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace overturn {

/// By one fast Fourier transform on a grid at least twice as fine as the signal needs and Gaussian interpolation
/// between its points (Dutt & Rokhlin 1993; Greengard & Lee 2004): error below 3e-13 of sum |a|. Costs a few direct
/// sums. What does not depend on the signal is prepared once.
class PhaseSums {
  public:
    /// \param samples of every signal
    PhaseSums(std::size_t samples, std::span<double const> x);

    /// One sum per x. \pre as many samples as stated
    [[nodiscard]] std::vector<std::complex<double>> of(std::span<double const> signal) const;

  private:
    // Shares of the grid's points around a place: share, share ratio, share ratio^2 ... times the bell.
    struct Place {
        std::size_t from;  // in the stretch of the grid that is looked at
        double share, ratio;
        std::complex<double> scale;
    };

    std::size_t samples_, size_;
    std::vector<double> sharpening_;  // over the Gaussian's own transform, per sample
    std::ptrdiff_t first_ = 0;        // of the stretch
    std::size_t stretch_ = 0;
    std::vector<Place> places_;
};

}  // namespace overturn
