#include "spectra/sliding_products.hpp"

#include <algorithm>
#include <complex>

#include "core/error.hpp"
#include "spectra/transform.hpp"

namespace overturn {
namespace {

using Spectrum = std::vector<std::complex<double>>;

std::size_t block_size(std::size_t taps, std::size_t samples) {
    constexpr std::size_t windows = 4;  // a block of about four kernels wastes least
    std::size_t size = 64;
    while (size < windows * taps && size < samples + 2 * taps) {
        size *= 2;
    }
    return size;
}

}  // namespace

// Two blocks at a time, one as the real part of the transform's input and one as the imaginary part: real kernels keep
// them apart. A block carries m samples more on both sides than it answers for.
std::vector<SlidingProducts> sliding_products(std::span<double const> signal,
                                              std::span<std::vector<double> const> kernels) {
    std::vector<SlidingProducts> products(kernels.size(),
                                          {std::vector<double>(signal.size()), std::vector<double>(signal.size())});
    if (kernels.empty() || kernels.front().empty() || signal.empty()) {
        return products;
    }
    auto const taps = kernels.front().size();
    auto const size = block_size(taps, signal.size());
    auto const forward = forward_transform(size);
    auto const backward = backward_transform(size);
    std::vector<Spectrum> responses;
    responses.reserve(kernels.size());
    for (auto const& kernel : kernels) {
        OVERTURN_EXPECT(kernel.size() == taps);
        std::fill(forward.in.begin(), forward.in.end(), 0.0);
        for (std::size_t d = 1; d <= taps; ++d) {
            forward.in[d] = kernel[d - 1] / static_cast<double>(size);
        }
        forward.run();
        responses.emplace_back(forward.out.begin(), forward.out.end());
    }
    std::size_t const answers = size - 2 * taps;
    auto const sample = [&](std::size_t block, std::size_t i) {  // i counts from `taps` samples before the block
        std::size_t const at = block + i;
        return at >= taps && at - taps < signal.size() ? signal[at - taps] : 0.0;
    };
    for (std::size_t first = 0; first < signal.size(); first += 2 * answers) {
        std::size_t const second = first + answers;
        for (std::size_t i = 0; i < size; ++i) {
            forward.in[i] = {sample(first, i), sample(second, i)};
        }
        forward.run();
        for (std::size_t k = 0; k < kernels.size(); ++k) {
            for (bool const backwards : {true, false}) {
                double const turn = backwards ? 1 : -1;
                for (std::size_t i = 0; i < size; ++i) {
                    auto const a = forward.out[i];
                    double const re = responses[k][i].real();
                    double const im = turn * responses[k][i].imag();
                    backward.in[i] = {a.real() * re - a.imag() * im, a.real() * im + a.imag() * re};
                }
                backward.run();
                auto& to = backwards ? products[k].before : products[k].after;
                for (std::size_t i = 0; i < answers && first + i < signal.size(); ++i) {
                    to[first + i] = backward.out[taps + i].real();
                }
                for (std::size_t i = 0; i < answers && second + i < signal.size(); ++i) {
                    to[second + i] = backward.out[taps + i].imag();
                }
            }
        }
    }
    return products;
}

}  // namespace overturn
