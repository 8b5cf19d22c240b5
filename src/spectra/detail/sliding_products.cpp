#include "spectra/detail/sliding_products.hpp"

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

using Line = std::complex<double>;

// The lines of a real signal, those beyond the middle included, times a response.
void respond(std::span<Line const> lines, std::span<Line const> response, std::span<Line> product) {
    std::size_t const size = response.size();
    for (std::size_t l = 0; l < lines.size(); ++l) {
        double const re = lines[l].real(), im = lines[l].imag();
        product[l] = {re * response[l].real() - im * response[l].imag(),
                      re * response[l].imag() + im * response[l].real()};
    }
    for (std::size_t l = lines.size(); l < size; ++l) {  // conjugates
        double const re = lines[size - l].real(), im = lines[size - l].imag();
        product[l] = {re * response[l].real() + im * response[l].imag(),
                      re * response[l].imag() - im * response[l].real()};
    }
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
        for (std::size_t d = 1; d <= taps_; ++d) {  // a sample's echo after it, and i times that before it
            double const share = kernels[k][d - 1] / static_cast<double>(size_);
            forward.in[d] += share;
            forward.in[size_ - d] += std::complex<double>(0, share);
        }
        forward.run();
        responses_[k].assign(forward.out.begin(), forward.out.end());
    }
}

// A block carries m samples more on both sides than it answers for. One transform brings both sums: those backwards as
// its real part and those forwards as its imaginary part.
std::vector<SlidingProducts> SlidingKernels::products(std::span<double const> signal) const {
    OVERTURN_EXPECT(signal.size() == samples_);
    std::vector<SlidingProducts> products(responses_.size(),
                                          {std::vector<double>(samples_), std::vector<double>(samples_)});
    if (size_ == 0) {
        return products;
    }
    auto const forward = real_analysis(size_);
    auto const backward = backward_transform(size_);
    std::size_t const answers = size_ - 2 * taps_;
    for (std::size_t first = 0; first < samples_; first += answers) {
        std::size_t const count = std::min(answers, samples_ - first);
        std::size_t const missing = taps_ - std::min(first, taps_);  // before the signal's first sample
        std::size_t const from = first + missing - taps_;
        auto const part = signal.subspan(from, std::min(size_ - missing, samples_ - from));
        std::fill_n(forward.in.begin(), missing, 0.0);
        auto const end = std::copy(part.begin(), part.end(), forward.in.begin() + missing);
        std::fill(end, forward.in.end(), 0.0);
        forward.run();
        for (std::size_t k = 0; k < responses_.size(); ++k) {
            respond(forward.out, responses_[k], backward.in);
            backward.run();
            for (std::size_t i = 0; i < count; ++i) {
                products[k].before[first + i] = backward.out[taps_ + i].real();
                products[k].after[first + i] = backward.out[taps_ + i].imag();
            }
        }
    }
    return products;
}

}  // namespace overturn
