#include "spectra/sliding_products.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "spectra/transform.hpp"

namespace overturn {
namespace {

std::size_t block_size(std::size_t taps, std::size_t samples) {
    constexpr std::size_t windows = 4;  // a block of about four kernels wastes least
    std::size_t size = 64;
    while (size < windows * taps && size < samples + 2 * taps) {
        size *= 2;
    }
    return size;
}

}  // namespace

SlidingKernels::SlidingKernels(std::span<std::vector<double> const> kernels, std::size_t samples)
    : taps_(kernels.empty() ? 0 : kernels.front().size()), samples_(samples), responses_(kernels.size()) {
    if (taps_ == 0 || samples == 0) {
        return;
    }
    size_ = block_size(taps_, samples);
    auto const forward = forward_transform(size_);
    for (std::size_t k = 0; k < kernels.size(); ++k) {
        OVERTURN_EXPECT(kernels[k].size() == taps_);
        std::fill(forward.in.begin(), forward.in.end(), 0.0);
        for (std::size_t d = 1; d <= taps_; ++d) {
            forward.in[d] = kernels[k][d - 1] / static_cast<double>(size_);
        }
        forward.run();
        responses_[k].assign(forward.out.begin(), forward.out.end());
    }
}

// Two blocks at a time, one as the real part of the transform's input and one as the imaginary part: real kernels keep
// them apart. A block carries m samples more on both sides than it answers for.
std::vector<SlidingProducts> SlidingKernels::products(std::span<double const> signal) const {
    OVERTURN_EXPECT(signal.size() == samples_);
    std::vector<SlidingProducts> products(responses_.size(),
                                          {std::vector<double>(samples_), std::vector<double>(samples_)});
    if (size_ == 0) {
        return products;
    }
    auto const forward = forward_transform(size_);
    auto const backward = backward_transform(size_);
    std::size_t const answers = size_ - 2 * taps_;
    std::size_t const pairs = (samples_ + 2 * answers - 1) / (2 * answers);
    std::vector<double> padded(taps_ + 2 * pairs * answers + size_, 0.0);
    std::copy(signal.begin(), signal.end(), padded.begin() + static_cast<std::ptrdiff_t>(taps_));
    std::vector<std::complex<double>> ahead(size_);
    auto const answer = [&](std::vector<double>& to, std::size_t first) {
        std::size_t const second = first + answers;
        for (std::size_t i = 0; i < answers && first + i < samples_; ++i) {
            to[first + i] = backward.out[taps_ + i].real();
        }
        for (std::size_t i = 0; i < answers && second + i < samples_; ++i) {
            to[second + i] = backward.out[taps_ + i].imag();
        }
    };
    for (std::size_t first = 0; first < samples_; first += 2 * answers) {
        for (std::size_t i = 0; i < size_; ++i) {
            forward.in[i] = {padded[first + i], padded[first + answers + i]};
        }
        forward.run();
        for (std::size_t k = 0; k < responses_.size(); ++k) {
            for (std::size_t i = 0; i < size_; ++i) {  // times the response, and times its conjugate
                auto const a = forward.out[i];
                auto const r = responses_[k][i];
                double const p = a.real() * r.real(), q = a.imag() * r.imag();
                double const s = a.real() * r.imag(), t = a.imag() * r.real();
                backward.in[i] = {p - q, t + s};
                ahead[i] = {p + q, t - s};
            }
            backward.run();
            answer(products[k].before, first);
            std::copy(ahead.begin(), ahead.end(), backward.in.begin());
            backward.run();
            answer(products[k].after, first);
        }
    }
    return products;
}

}  // namespace overturn
