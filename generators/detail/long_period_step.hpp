/// Changes of a wave's slow Fourier lines (amplitudes and phases) that bring slow oscillators to their target peaks.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "generators/detail/noise_lines.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {

/// A Gauss-Newton step on slow lines: to first order, each oscillator's peak is the sum of what the
/// lines put into it up to that instant, here by convolution with its own memory (Duhamel's integral), so that it holds
/// where the memory is as long as the wave: at 5 % damping 1/(zeta w) is 3 s at a period of 1 s and 32 s at 10 s, where
/// the stationary sums of LineGains are no longer those of the wave. With amplitudes alone the few slow lines of a
/// short wave cannot follow a target at 100 periods a decade; their phases are as many unknowns again. The least change
/// that brings all peaks to their goals (ridge regression).
class LongPeriodStep {
  public:
    /// \param periods_s rising; those from `from_s` on are brought to their goals
    LongPeriodStep(std::vector<double> periods_s, double damping, NoiseLines const& noise);

    static constexpr double from_s = 0.5;

    /// Multiplies slow `lines` by complex gains. \param peaks one per period \param ratios wanted over present peak
    /// \param envelope the wave's, per sample
    /// \param noise that the lines were drawn from
    void apply(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
               std::span<double const> envelope, NoiseLines const& noise) const;

  private:
    [[nodiscard]] Lines into_peak(double period_s, double time_s, std::span<double const> envelope,
                                  NoiseLines const& noise) const;

    std::vector<double> periods_s_;
    double damping_;
    std::size_t first_row_, end_line_;
};

}  // namespace overturn
