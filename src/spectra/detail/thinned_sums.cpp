#include "spectra/detail/thinned_sums.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_sf_bessel.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "simd/lane_values.hpp"
#include "spectra/detail/smoothing.hpp"

namespace overturn {
namespace {

constexpr double shape = 38;  // of the kernel: beyond its main lobe it is below exp(-shape) of its middle

// The next multiple of the lanes a kernel is summed in.
std::size_t filled_up(std::size_t taps) {
    return (taps + simd::sweep_lanes - 1) / simd::sweep_lanes * simd::sweep_lanes;
}

}  // namespace

ThinnedSums::ThinnedSums(std::size_t samples, std::span<double const> x) : samples_(samples) {
    double fastest = 0;
    for (double const phase : x) {
        fastest = std::max(fastest, std::abs(phase));
    }
    constexpr std::size_t most = 64;
    while (stride_ < most && fastest * static_cast<double>(4 * stride_) <= pi) {
        stride_ *= 2;
    }
    // The kernel's main lobe ends where the nearest phase is that folds onto the fastest one.
    auto const half_for = [&](std::size_t stride) {
        return static_cast<std::size_t>(std::ceil(shape / (2 * pi / static_cast<double>(stride) - fastest)));
    };
    while (stride_ > 1 && samples < 4 * half_for(stride_)) {  // too short a signal for so long a kernel
        stride_ /= 2;
    }
    if (stride_ == 1) {
        sums_.emplace(samples, x);
        return;
    }
    half_ = half_for(stride_);
    std::size_t const taps = 2 * half_ + 1;
    auto const half_width = static_cast<double>(half_);
    kernel_.assign(filled_up(taps), 0.0);
    for (std::size_t t = 0; t < taps; ++t) {
        double const u = (static_cast<double>(t) - half_width) / half_width;
        double const arch = shape * std::sqrt(std::max(0.0, 1 - u * u));
        kernel_[t] = gsl_sf_bessel_I0_scaled(arch) * std::exp(arch - shape);
    }
    length_ = (samples + 2 * half_) / stride_ + 1;
    length_ += length_ % 2;

    // sum_m exp(-i x stride m) sum_t w_t a_(stride m + t - 2 half) is the sum that is looked for, half a kernel late,
    // times the kernel's transform 2 L sinh(sqrt(shape^2 - x^2 L^2)) / sqrt(shape^2 - x^2 L^2) over the stride.
    std::vector<double> slower;
    slower.reserve(x.size());
    scale_.reserve(x.size());
    for (double const phase : x) {
        slower.push_back(phase * static_cast<double>(stride_));
        double const bent = std::sqrt(shape * shape - phase * phase * half_width * half_width);
        double const response = half_width * (std::exp(bent - shape) - std::exp(-bent - shape)) / bent;
        scale_.push_back(std::polar(static_cast<double>(stride_) / response, phase * half_width));
    }
    sums_.emplace(length_, slower);
}

// The kernel's middle stands half a kernel before the signal at first.
std::vector<double> ThinnedSums::thinned(std::span<double const> signal) const {
    std::vector<double> padded(length_ * stride_ + kernel_.size(), 0.0);
    std::copy(signal.begin(), signal.end(), padded.begin() + (2 * half_));
    std::vector<double> smoothed(length_);
    smooth(kernel_, padded, stride_, smoothed);
    return smoothed;
}

std::vector<std::complex<double>> ThinnedSums::of(std::span<double const> signal) const {
    OVERTURN_EXPECT(signal.size() == samples_);
    if (stride_ == 1) {
        return sums_->of(signal);
    }
    auto sums = sums_->of(thinned(signal));
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] *= scale_[i];
    }
    return sums;
}

}  // namespace overturn
