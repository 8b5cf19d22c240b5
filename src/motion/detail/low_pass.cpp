#include "motion/detail/low_pass.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace overturn {
namespace {

constexpr double stop_decibel = 80;
// Kaiser (1974): the window's shape, and its length times the width of the transition.
constexpr double shape = 0.1102 * (stop_decibel - 8.7);
constexpr double length_times_width = (stop_decibel - 7.95) / 14.36;

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

/// Modified Bessel function of order 0, by its power series.
double bessel_i0(double x) {
    double term = 1;
    double sum = 1;
    constexpr double rounding = 1e-16;
    for (int k = 1; term > rounding * sum; ++k) {
        term *= x * x / (4.0 * k * k);
        sum += term;
    }
    return sum;
}

/// The kernel at some seconds from its middle.
class Kernel {
  public:
    explicit Kernel(LowPass const& band)
        : cutoff_hz_((band.pass_hz + band.stop_hz) / 2),
          half_s_(length_times_width / (band.stop_hz - band.pass_hz) / 2) {}

    [[nodiscard]] double half_s() const { return half_s_; }
    [[nodiscard]] double operator()(double time_s) const {
        double const share = time_s / half_s_;
        if (std::abs(share) >= 1) {
            return 0;
        }
        return 2 * cutoff_hz_ * sinc(2 * cutoff_hz_ * time_s) * bessel_i0(shape * std::sqrt(1 - share * share))
               / bessel_i0(shape);
    }

  private:
    double cutoff_hz_, half_s_;
};

}  // namespace

LowPass LowPass::for_step(double time_step_s) {
    constexpr double kept = 0.8;
    double const nyquist_hz = 0.5 / time_step_s;
    return {kept * nyquist_hz, nyquist_hz};
}

std::vector<double> low_passed(std::span<double const> values, double time_step_s, double to_step_s,
                               std::size_t count) {
    Kernel const kernel(LowPass::for_step(to_step_s));
    auto const reach = static_cast<std::ptrdiff_t>(std::floor(kernel.half_s() / time_step_s));
    auto const last = std::ssize(values) - 1;
    std::vector<double> made(count);
    for (std::size_t i = 0; i < count; ++i) {
        double const at_s = static_cast<double>(i) * to_step_s;
        std::ptrdiff_t const middle = std::lround(at_s / time_step_s);
        double sum = 0;
        double weights = 0;
        for (auto k = middle - reach; k <= middle + reach; ++k) {
            double const weight = kernel(at_s - static_cast<double>(k) * time_step_s);
            weights += weight;
            sum += k >= 0 && k <= last ? weight * values[k] : 0.0;
        }
        made[i] = sum / weights;
    }
    return made;
}

}  // namespace overturn
