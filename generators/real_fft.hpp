/// Discrete Fourier transforms of real series in plain C (GSL mixed radix): the same bits on every machine.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>

namespace overturn {

/// Tables for one length; const use from several threads is safe.
class RealFft {
  public:
    explicit RealFft(std::size_t length);

    [[nodiscard]] std::size_t length() const { return length_; }

    /// The series whose Fourier lines are `lines`: x_n = sum_k Re(lines[k] exp(2 pi i k n / length)), k < length/2.
    void synthesise(std::span<std::complex<double> const> lines, std::span<double> series) const;

    /// The other way: the lines of a series, lines[0] its mean; a line at half the sampling frequency is dropped.
    void analyse(std::span<double const> series, std::span<std::complex<double>> lines) const;

    /// The smallest even length of factors 2, 3 and 5 that is at least `count`.
    [[nodiscard]] static std::size_t good_length(std::size_t count);

  private:
    std::size_t length_;
    std::unique_ptr<gsl_fft_halfcomplex_wavetable, decltype(&gsl_fft_halfcomplex_wavetable_free)> table_;
    std::unique_ptr<gsl_fft_real_wavetable, decltype(&gsl_fft_real_wavetable_free)> real_table_;
};

}  // namespace overturn
