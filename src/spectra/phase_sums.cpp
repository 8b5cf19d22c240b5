#include "spectra/phase_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/units.hpp"
#include "spectra/transform.hpp"

namespace overturn {
namespace {

constexpr int reach = 15;                         // grid points on either side: exp(-2 pi reach / 3) is rounding
constexpr double breadth = 4.0 / 3 * reach / pi;  // of the Gaussian, for a grid twice as fine

// The transform of a real signal of `size` points, at any integer frequency.
std::complex<double> line_at(std::span<std::complex<double> const> lines, std::size_t size, std::ptrdiff_t frequency) {
    auto const n = static_cast<std::ptrdiff_t>(size);
    auto const l = static_cast<std::size_t>(((frequency % n) + n) % n);
    return l < lines.size() ? lines[l] : std::conj(lines[size - l]);
}

// The signal, counted from its middle and divided by the Gaussian's own transform.
void sharpen(std::span<double const> samples, std::span<double> signal) {
    std::fill(signal.begin(), signal.end(), 0.0);
    auto const size = signal.size();
    auto const middle = samples.size() / 2;
    for (std::size_t j = 0; j < samples.size(); ++j) {
        double const k = static_cast<double>(j) - static_cast<double>(middle);
        double const angle = pi * k / static_cast<double>(size);
        signal[j < middle ? j + size - middle : j - middle] = samples[j] * std::exp(breadth * angle * angle);
    }
}

}  // namespace

std::vector<std::complex<double>> fast_phase_sums(std::span<double const> samples, std::span<double const> x) {
    std::size_t size = 64;  // more than twice the reach
    while (size < 2 * samples.size()) {
        size *= 2;
    }
    auto const grid = real_analysis(size);
    sharpen(samples, grid.in);
    grid.run();
    std::array<double, std::size_t{2} * reach> bell{};  // exp(-q^2 / breadth)
    for (int q = 1 - reach; q <= reach; ++q) {
        bell.at(static_cast<std::size_t>(q + reach - 1)) = std::exp(-q * q / breadth);
    }
    if (x.empty()) {
        return {};
    }
    // The stretch of the grid that is looked at, unwound.
    double const points = static_cast<double>(size) / (2 * pi);
    auto const [least, most] = std::ranges::minmax(x);
    auto const first = static_cast<std::ptrdiff_t>(std::floor(least * points)) + 1 - reach;
    auto const last = static_cast<std::ptrdiff_t>(std::floor(most * points)) + reach;
    std::vector<std::complex<double>> near;
    near.reserve(static_cast<std::size_t>(last - first + 1));
    for (auto l = first; l <= last; ++l) {
        near.push_back(line_at(grid.out, size, l));
    }
    auto const half = samples.size() / 2;
    auto const middle = static_cast<double>(half);
    std::vector<std::complex<double>> sums;
    sums.reserve(x.size());
    for (double const phase : x) {
        double const place = phase * points;
        double const below = std::floor(place);
        double const f = place - below;
        auto const* const from = near.data() + (static_cast<std::ptrdiff_t>(below) + 1 - reach - first);
        double const ratio = std::exp(2 * f / breadth);
        double power = std::exp((1 - reach) * (2 * f / breadth) - f * f / breadth);
        double re = 0;
        double im = 0;
        for (std::size_t q = 0; q < bell.size(); ++q) {
            double const share = power * bell[q];
            re += share * from[q].real();
            im += share * from[q].imag();
            power *= ratio;
        }
        std::complex<double> const sum(re, im);
        sums.push_back(sum / std::sqrt(pi * breadth) * std::polar(1.0, -phase * middle));
    }
    return sums;
}

}  // namespace overturn
