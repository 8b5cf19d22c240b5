#include "spectra/detail/window_kernel.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <utility>

#include "core/error.hpp"
#include "spectra/detail/fourier.hpp"
#include "spectra/transform.hpp"

namespace overturn {
namespace {

// A sum in twice the working precision (Knuth's two-sum): many additions leave no more than one does.
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

}  // namespace

WindowKernel::Weights WindowKernel::weights_of(BandRule const& rule, double time_step_s, std::size_t window) {
    OVERTURN_EXPECT(window >= 1 && time_step_s > 0);
    std::size_t const count = window + 1;
    Weights k{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
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

WindowKernel::WindowKernel(std::size_t samples, double time_step_s, std::size_t window, BandRule const& rule)
    : samples_(samples),
      window_(window),
      weights_(weights_of(rule, time_step_s, window)),
      sliding_(std::array{std::vector<double>(weights_.inside.begin() + 1, weights_.inside.end() - 1),
                          std::vector<double>(weights_.edge.begin() + 1, weights_.edge.end() - 1)},
               samples),
      pairs_size_(std::bit_ceil(2 * window)) {
    for (std::size_t i = 0; i < rule.weight.size(); ++i) {
        edge_alone_ += rule.weight[i] * time_step_s * time_step_s
                       * std::norm(HatWeights(rule.frequency_radps[i] * time_step_s).right);
    }
    auto const transform = real_analysis(pairs_size_);  // of K in a circle: a window fits in twice without touching
    std::fill(transform.in.begin(), transform.in.end(), 0.0);
    transform.in[0] = weights_.inside[0];
    for (std::size_t d = 1; d < window; ++d) {
        transform.in[d] = weights_.inside[d];
        transform.in[pairs_size_ - d] = weights_.inside[d];
    }
    transform.run();
    for (std::size_t l = 0; l < transform.out.size(); ++l) {
        bool const alone = l == 0 || 2 * l == pairs_size_;  // others stand for their conjugates too
        pairs_.push_back((alone ? 1 : 2) * transform.out[l].real() / static_cast<double>(pairs_size_));
    }
}

// sum_ij a_i a_j K(|i - j|) over samples that fit into a window: by the power of their transform.
double WindowKernel::all_pairs(std::span<double const> samples) const {
    auto const transform = real_analysis(pairs_size_);
    std::copy(samples.begin(), samples.end(), transform.in.begin());
    std::fill(transform.in.begin() + samples.size(), transform.in.end(), 0.0);
    transform.run();
    double sum = 0;
    for (std::size_t l = 0; l < pairs_.size(); ++l) {
        sum += pairs_[l] * std::norm(transform.out[l]);
    }
    return sum;
}

std::vector<double> WindowKernel::squares(std::vector<double> acceleration_mps2) const {
    OVERTURN_EXPECT(acceleration_mps2.size() == samples_ && window_ >= 1);
    std::size_t const n = samples_;
    std::vector<double> squares(n, 0.0);
    if (n < 2) {
        return squares;
    }
    // The first sample is never inside a window: it is the edge of all that are cut there.
    double const start = std::exchange(acceleration_mps2.front(), 0.0);
    auto const& a = acceleration_mps2;
    auto const products = sliding_.products(a);
    auto const& k = weights_;
    auto const& inside = products[0];
    auto const& edge = products[1];
    // What a sample brings with those before it inside the window, and takes away with those after it.
    auto const brings = [&](std::size_t i) { return a[i] * (2 * inside.before[i] + k.inside[0] * a[i]); };
    auto const takes = [&](std::size_t i) { return a[i] * (2 * inside.after[i] + k.inside[0] * a[i]); };

    Balance total;       // of products of samples inside the window
    Balance from_start;  // of the first sample's edge with them
    std::size_t const sliding = std::min(n, window_ + 1);
    for (std::size_t end = 1; end < sliding; ++end) {
        total.add(brings(end - 1));
        from_start.add(a[end - 1] * k.edge[end - 1]);
        squares[end] = total.value() + 2 * (a[end] * edge.before[end] + start * from_start.value())
                       + edge_alone_ * (start * start + a[end] * a[end]) + 2 * start * a[end] * k.edges[end];
    }
    // Three passes, of which only the middle one has to wait for its own sums.
    for (std::size_t end = sliding; end < n; ++end) {
        squares[end] = brings(end - 1) - takes(end - window_);
    }
    // What a strong part left behind by rounding is forgotten a few windows later.
    constexpr std::size_t anew = 8;
    std::size_t next = anew * window_;
    for (std::size_t end = sliding; end < n; ++end) {
        total.add(squares[end]);
        if (end == next) {
            next += anew * window_;
            total = Balance();
            total.add(all_pairs(std::span(a).subspan(end - window_ + 1, window_ - 1)));
        }
        squares[end] = total.value();
    }
    for (std::size_t end = sliding; end < n; ++end) {
        double const first = a[end - window_];
        double const last = a[end];
        squares[end] += 2 * (last * edge.before[end] + first * edge.after[end - window_])
                        + edge_alone_ * (first * first + last * last) + 2 * first * last * k.edges[window_];
    }
    return squares;
}

}  // namespace overturn
