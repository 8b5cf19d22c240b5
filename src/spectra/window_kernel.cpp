#include "spectra/window_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "core/error.hpp"
#include "spectra/fourier.hpp"
#include "spectra/sliding_products.hpp"

namespace overturn {
namespace {

// Weights of products of two samples, d samples apart: both inside the window, one at its end, both at its ends.
struct Kernels {
    std::vector<double> inside, edge, edges;  // d = 0 ... window
};

Kernels kernels_of(BandRule const& rule, double time_step_s, std::size_t window) {
    std::size_t const count = window + 1;
    Kernels k{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
    constexpr std::size_t stretch = 64;  // the phase is turned step by step this far, then set anew
    for (std::size_t i = 0; i < rule.weight.size(); ++i) {
        double const x = rule.frequency_radps[i] * time_step_s;
        HatWeights const hat(x);
        double const weight = rule.weight[i] * time_step_s * time_step_s;
        double const inside = weight * hat.whole * hat.whole;
        std::complex<double> const edge = weight * hat.whole * hat.right;
        std::complex<double> const edges = weight * hat.right * hat.right;
        std::array<double, stretch> cosine{};
        std::array<double, stretch> sine{};
        for (std::size_t j = 0; j < stretch; ++j) {
            cosine.at(j) = std::cos(x * static_cast<double>(j));
            sine.at(j) = std::sin(x * static_cast<double>(j));
        }
        for (std::size_t begin = 0; begin < count; begin += stretch) {
            double const c0 = std::cos(x * static_cast<double>(begin));
            double const s0 = std::sin(x * static_cast<double>(begin));
            std::size_t const length = std::min(stretch, count - begin);
            for (std::size_t j = 0; j < length; ++j) {
                double const c = c0 * cosine[j] - s0 * sine[j];
                double const s = s0 * cosine[j] + c0 * sine[j];
                k.inside[begin + j] += inside * c;
                k.edge[begin + j] += edge.real() * c - edge.imag() * s;
                k.edges[begin + j] += edges.real() * c - edges.imag() * s;
            }
        }
    }
    return k;
}

// A sum in twice the working precision (Knuth's two-sum): what goes in can come out again without a trace.
class Balance {
  public:
    void add(double x) {
        double const sum = high_ + x;
        double const back = sum - high_;
        low_ += (high_ - (sum - back)) + (x - back);
        high_ = sum;
    }
    [[nodiscard]] double value() const { return high_ + low_; }

  private:
    double high_ = 0, low_ = 0;
};

// Sum over all pairs of samples first ... last, plainly.
double sum_of_pairs(std::span<double const> samples, std::size_t first, std::size_t last,
                    std::span<double const> kernel) {
    double total = 0;
    for (std::size_t j = first; j <= last; ++j) {
        std::array<double, 4> rows{};  // four at a time: additions wait for each other
        std::size_t d = 1;
        for (; d + 3 <= j - first; d += 4) {
            for (std::size_t lane = 0; lane < rows.size(); ++lane) {
                rows[lane] += samples[j - d - lane] * kernel[d + lane];
            }
        }
        for (; d <= j - first; ++d) {
            rows[0] += samples[j - d] * kernel[d];
        }
        total += samples[j] * (2 * ((rows[0] + rows[1]) + (rows[2] + rows[3])) + kernel[0] * samples[j]);
    }
    return total;
}

}  // namespace

std::vector<double> window_squares(std::span<double const> acceleration_mps2, double time_step_s, std::size_t window,
                                   BandRule const& rule) {
    OVERTURN_EXPECT(window >= 1 && time_step_s > 0);
    std::size_t const n = acceleration_mps2.size();
    std::vector<double> squares(n, 0.0);
    if (n < 2) {
        return squares;
    }
    auto const k = kernels_of(rule, time_step_s, window);
    double const edge_alone = [&] {  // |right|^2: an edge with itself
        double sum = 0;
        for (std::size_t i = 0; i < rule.weight.size(); ++i) {
            sum += rule.weight[i] * time_step_s * time_step_s
                   * std::norm(HatWeights(rule.frequency_radps[i] * time_step_s).right);
        }
        return sum;
    }();
    // The first sample is never inside a window: it is the edge of all that are cut there.
    std::vector<double> inner(acceleration_mps2.begin(), acceleration_mps2.end());
    inner.front() = 0;
    std::array const taps{std::vector<double>(k.inside.begin() + 1, k.inside.end() - 1),
                          std::vector<double>(k.edge.begin() + 1, k.edge.end() - 1)};
    auto const products = sliding_products(inner, taps);
    auto const& inside = products[0];
    auto const& edge = products[1];

    Balance total;       // of products of samples inside the window
    Balance from_first;  // of the first sample's edge with them, while the window is cut there
    for (std::size_t end = 1; end < n; ++end) {
        bool const cut = end < window;
        std::size_t const begin = cut ? 0 : end - window;
        if (end >= 2) {  // the sample before is inside from now on
            double const a = inner[end - 1];
            total.add(2 * a * inside.before[end - 1]);
            total.add(k.inside[0] * a * a);
            if (end - 1 < window) {
                from_first.add(a * k.edge[end - 1]);
            }
        }
        if (end > window) {  // and this one no longer
            double const a = inner[begin];
            total.add(-2 * a * inside.after[begin]);
            total.add(-k.inside[0] * a * a);
        }
        // What a strong part left behind by rounding is forgotten a few windows later.
        constexpr std::size_t anew = 8;
        if (end > window && end % (anew * window) == 0) {
            total = Balance();
            total.add(sum_of_pairs(inner, begin + 1, end - 1, k.inside));
        }
        double const first = acceleration_mps2[begin];
        double const last = acceleration_mps2[end];
        double const with_first = begin == 0 ? from_first.value() : edge.after[begin];
        squares[end] = total.value() + 2 * (last * edge.before[end] + first * with_first)
                       + edge_alone * (first * first + last * last) + 2 * first * last * k.edges[end - begin];
    }
    return squares;
}

}  // namespace overturn
