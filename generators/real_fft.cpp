#include "generators/real_fft.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"

namespace overturn {

RealFft::RealFft(std::size_t length)
    : length_(length),
      table_(gsl_fft_halfcomplex_wavetable_alloc(length), &gsl_fft_halfcomplex_wavetable_free),
      real_table_(gsl_fft_real_wavetable_alloc(length), &gsl_fft_real_wavetable_free) {}

void RealFft::synthesise(std::span<std::complex<double> const> lines, std::span<double> series) const {
    OVERTURN_EXPECT(lines.size() <= length_ / 2 && series.size() == length_);
    std::fill(series.begin(), series.end(), 0.0);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        double const share = k == 0 ? 1.0 : 0.5;  // GSL adds the conjugate line itself
        series[k == 0 ? 0 : 2 * k - 1] = share * lines[k].real();
        if (k > 0) {
            series[2 * k] = share * lines[k].imag();
        }
    }
    std::unique_ptr<gsl_fft_real_workspace, decltype(&gsl_fft_real_workspace_free)> const work(
        gsl_fft_real_workspace_alloc(length_), &gsl_fft_real_workspace_free);
    gsl_fft_halfcomplex_transform(series.data(), 1, length_, table_.get(), work.get());
}

void RealFft::analyse(std::span<double const> series, std::span<std::complex<double>> lines) const {
    OVERTURN_EXPECT(lines.size() <= length_ / 2 && series.size() == length_);
    std::vector<double> terms(series.begin(), series.end());
    std::unique_ptr<gsl_fft_real_workspace, decltype(&gsl_fft_real_workspace_free)> const work(
        gsl_fft_real_workspace_alloc(length_), &gsl_fft_real_workspace_free);
    gsl_fft_real_transform(terms.data(), 1, length_, real_table_.get(), work.get());
    double const mean = 1 / static_cast<double>(length_);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines[k] = k == 0 ? std::complex(mean * terms[0]) : 2 * mean * std::complex(terms[2 * k - 1], terms[2 * k]);
    }
}

std::size_t RealFft::good_length(std::size_t count) {
    auto const smooth = [](std::size_t n) {
        for (std::size_t const factor : {2U, 3U, 5U}) {
            while (n % factor == 0) {
                n /= factor;
            }
        }
        return n == 1;
    };
    std::size_t length = std::max<std::size_t>(2, count + count % 2);
    while (!smooth(length)) {
        length += 2;
    }
    return length;
}

}  // namespace overturn
