#include "generators/detail/real_fft.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "spectra/transform.hpp"

namespace overturn {

void RealFft::synthesise(std::span<std::complex<double> const> lines, std::span<double> series) const {
    OVERTURN_EXPECT(lines.size() <= length_ / 2 && series.size() == length_);
    auto const transform = real_synthesis(length_);
    std::fill(transform.in.begin(), transform.in.end(), 0.0);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        transform.in[k] = k == 0 ? lines[k].real() : 0.5 * lines[k];  // the conjugate line adds as much
    }
    transform.run();
    std::copy(transform.out.begin(), transform.out.end(), series.begin());
}

void RealFft::analyse(std::span<double const> series, std::span<std::complex<double>> lines) const {
    OVERTURN_EXPECT(lines.size() <= length_ / 2 && series.size() == length_);
    auto const transform = real_analysis(length_);
    std::copy(series.begin(), series.end(), transform.in.begin());
    transform.run();
    double const mean = 1 / static_cast<double>(length_);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines[k] = k == 0 ? mean * transform.out[k].real() : 2 * mean * transform.out[k];
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
