/// Fourier integrals of acceleration that is exactly linear between samples: no leakage rule, no oscillator run.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "spectra/detail/thinned_sums.hpp"

namespace overturn {

/// Filon's weights for straight lines between samples, x = w dt.
struct HatWeights {
    std::complex<double>
        right;         ///< int_0^1 (1-s) exp(-ixs) ds: the half hat of a first sample; its conjugate: a last one
    double whole = 1;  ///< right + conj(right): the hat of a sample between others

    /// Relative error below 1e-15 for any x >= 0, x -> 0 included.
    explicit HatWeights(double x);
};

/// int a exp(-iwt) dt over the whole wave [m/s], t = 0 at the first sample; one value per frequency [rad/s], w = 0
/// included. Few frequencies are summed in blocks that share one table of phases, many by one fast transform: within
/// 1e-12 of the integral of |a| on 1e6 samples. What does not depend on the wave is prepared once.
class FourierIntegrals {
  public:
    /// \param samples of every wave
    FourierIntegrals(std::size_t samples, double time_step_s, std::span<double const> frequencies_radps);

    /// \pre as many samples as stated
    [[nodiscard]] std::vector<std::complex<double>> of(std::span<double const> acceleration_mps2) const;

  private:
    struct Ends {
        double whole;
        std::complex<double> first, last;  // what the halves of the hats beyond the ends would add
    };
    std::size_t samples_;
    double time_step_s_;
    std::vector<double> phases_;
    std::vector<Ends> ends_;
    std::optional<ThinnedSums> fast_;
};

/// The same for one wave.
[[nodiscard]] std::vector<std::complex<double>> fourier_amplitudes(std::span<double const> acceleration_mps2,
                                                                   double time_step_s,
                                                                   std::span<double const> frequencies_radps);

}  // namespace overturn
