#include "spectra/detail/phase_sums.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/transform.hpp"

namespace overturn {
namespace {

constexpr int reach = 15;                         // grid points on either side: exp(-2 pi reach / 3) is rounding
constexpr double breadth = 4.0 / 3 * reach / pi;  // of the Gaussian, for a grid twice as fine

// The smallest of 2^k and 3 2^k that is twice as fine as the signal needs.
std::size_t grid_size(std::size_t samples) {
    constexpr std::size_t least = 64;  // more than twice the reach
    std::size_t const wanted = std::max(least, 2 * samples);
    std::size_t const size = std::bit_ceil(wanted);
    std::size_t const between = size / 4 * 3;
    return between >= wanted ? between : size;
}

// The transform of a real signal of `size` points, at any integer frequency.
std::complex<double> line_at(std::span<std::complex<double> const> lines, std::size_t size, std::ptrdiff_t frequency) {
    std::ptrdiff_t const n = size;
    std::size_t const l = ((frequency % n) + n) % n;
    return l < lines.size() ? lines[l] : std::conj(lines[size - l]);
}

using Bell = std::array<double, std::size_t{2} * reach>;  // exp(-q^2 / breadth)
Bell bell() {
    Bell values{};
    for (int q = 1 - reach; q <= reach; ++q) {
        values.at(q + reach - 1) = std::exp(-q * q / breadth);
    }
    return values;
}

}  // namespace

PhaseSums::PhaseSums(std::size_t samples, std::span<double const> x)
    : samples_(samples), size_(grid_size(samples)), sharpening_(samples) {
    auto const half = samples / 2;
    auto const middle = static_cast<double>(half);
    for (std::size_t j = 0; j < samples; ++j) {
        double const angle = pi * (static_cast<double>(j) - middle) / static_cast<double>(size_);
        sharpening_[j] = std::exp(breadth * angle * angle);
    }
    if (x.empty()) {
        return;
    }
    double const points = static_cast<double>(size_) / (2 * pi);
    auto const [least, most] = std::ranges::minmax(x);
    first_ = static_cast<std::ptrdiff_t>(std::floor(least * points)) + 1 - reach;
    stretch_ = static_cast<std::ptrdiff_t>(std::floor(most * points)) + reach - first_ + 1;
    places_.reserve(x.size());
    for (double const phase : x) {
        double const place = phase * points;
        double const below = std::floor(place);
        double const f = place - below;
        places_.push_back({.from = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(below) + 1 - reach - first_),
                           .share = std::exp((1 - reach) * (2 * f / breadth) - f * f / breadth),
                           .ratio = std::exp(2 * f / breadth),
                           .scale = std::polar(1 / std::sqrt(pi * breadth), -phase * middle)});
    }
}

std::vector<std::complex<double>> PhaseSums::of(std::span<double const> signal) const {
    OVERTURN_EXPECT(signal.size() == samples_);
    std::vector<std::complex<double>> sums(places_.size());
    if (sums.empty()) {
        return sums;
    }
    auto const grid = real_analysis(size_);
    auto const middle = samples_ / 2;
    std::fill(grid.in.begin() + (samples_ - middle), grid.in.end() - middle, 0.0);
    for (std::size_t j = 0; j < samples_; ++j) {  // counted from the middle
        grid.in[j < middle ? j + size_ - middle : j - middle] = signal[j] * sharpening_[j];
    }
    grid.run();
    std::vector<std::complex<double>> near(stretch_);
    for (std::size_t l = 0; l < stretch_; ++l) {
        near[l] = line_at(grid.out, size_, first_ + static_cast<std::ptrdiff_t>(l));
    }
    static Bell const shape = bell();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        auto const& place = places_[i];
        auto const* const from = near.data() + place.from;
        // Two chains of shares, as one would wait for itself.
        double const twice = place.ratio * place.ratio;
        std::array<double, 2> share{place.share, place.share * place.ratio};
        std::array<double, 2> re{}, im{};
        for (std::size_t q = 0; q < shape.size(); q += 2) {
            for (std::size_t c = 0; c < 2; ++c) {
                double const weight = share[c] * shape[q + c];
                re[c] += weight * from[q + c].real();
                im[c] += weight * from[q + c].imag();
                share[c] *= twice;
            }
        }
        sums[i] = std::complex<double>(re[0] + re[1], im[0] + im[1]) * place.scale;
    }
    return sums;
}

}  // namespace overturn
