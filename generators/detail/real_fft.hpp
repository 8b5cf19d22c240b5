/// Real series from their Fourier lines, and the lines of a series.
#pragma once

#include <complex>
#include <cstddef>
#include <span>

namespace overturn {

/// Transform of a fixed length.
class RealFft {
  public:
    explicit RealFft(std::size_t length) : length_(length) {}

    [[nodiscard]] std::size_t length() const { return length_; }

    /// The series whose Fourier lines are `lines`: x_n = sum_k Re(lines[k] exp(2 pi i k n / length)), k < length/2.
    void synthesise(std::span<std::complex<double> const> lines, std::span<double> series) const;

    /// The other way: the lines of a series, lines[0] its mean; a line at half the sampling frequency is dropped.
    void analyse(std::span<double const> series, std::span<std::complex<double>> lines) const;

    /// The smallest even length of factors 2, 3 and 5 that is at least `count`.
    [[nodiscard]] static std::size_t good_length(std::size_t count);

  private:
    std::size_t length_;
};

}  // namespace overturn
