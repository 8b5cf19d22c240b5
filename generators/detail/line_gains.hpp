/// Changes of the amplitudes of a wave's Fourier lines that bring the peaks of its oscillators to their targets.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "spectra/peak_response.hpp"

namespace overturn {

/// A Gauss-Newton step on a wave envelope(t) sum_k Re(L_k exp(i w_k t)): each oscillator's largest displacement is, to
/// first order, the sum of what the lines put into it at that instant, and real gains on bands of lines (100 a decade,
/// single lines where those lie farther apart) are found that bring all peaks to their goals, with the least change
/// (conjugate gradients on damped normal equations). Phases stay as they are. The envelope is taken to hold still over
/// an oscillator's memory; each oscillator's contributions are scaled to add up to its true peak.
class LineGains {
  public:
    /// \param spacing_radps of the lines, line k at k spacing \param usable lines [first, last) may be changed
    LineGains(std::vector<double> periods_s, double damping, double spacing_radps, std::size_t first_line,
              std::size_t last_line);

    /// In the linear step: how far it may leave the wave's own phases and envelope for a better fit.
    enum class Trust { little, much };

    /// Multiplies `lines` by the gains. \param ratios wanted over present peak, per period \param envelope at the
    /// peaks
    void apply(std::span<std::complex<double>> lines, std::span<PeakDisplacement const> peaks,
               std::span<double const> envelope, std::span<double const> ratios, Trust trust) const;

  private:
    // What each band of lines puts into each peak, in parts of it; bands beyond an oscillator's reach are left out.
    struct Matrix {
        std::vector<float> values;
        std::vector<std::size_t> used;  // bands per row
    };
    [[nodiscard]] Matrix contributions(std::span<std::complex<double> const> lines,
                                       std::span<PeakDisplacement const> peaks, std::span<double const> envelope) const;
    [[nodiscard]] std::vector<float> solve(Matrix const& matrix, std::vector<float> residual, Trust trust) const;

    std::vector<double> periods_s_;
    double damping_, spacing_radps_;
    std::size_t first_line_;
    std::vector<std::size_t> band_end_;  // first line beyond each band
};

}  // namespace overturn
