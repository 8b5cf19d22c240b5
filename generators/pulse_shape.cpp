#include "generators/pulse_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

double whole_sine(double u) { return std::sin(2 * pi * u); }

PulseShape one_sine(PulseParameters const& /*none*/) { return {1, 0.25, false, &whole_sine}; }

PulseShape half_sine(PulseParameters const& /*none*/) { return {0.5, 0.25, false, &whole_sine}; }

PulseShape one_cosine(PulseParameters const& /*none*/) {
    return {1, 0.25, true, [](double u) { return std::cos(2 * pi * u); }};
}

PulseShape rectangle(PulseParameters const& /*none*/) {
    return {1, 1, true, [](double /*u*/) { return 1.0; }};
}

PulseShape ricker(PulseParameters const& /*none*/) {
    return {4, 0.5, false, [](double u) {
                double const v = pi * (u - 2) * pi * (u - 2);
                return (1 - 2 * v) * std::exp(-v);
            }};
}

// Its peaks lie where x^4 - 6 x^2 + 3 = 0: x = +/- sqrt(3 - sqrt 6), at the 11th and 13th of 24 pieces.
PulseShape antisymmetric_ricker(PulseParameters const& /*none*/) {
    static double const peak_x = std::sqrt(3 - std::sqrt(6.0));
    static double const peak = peak_x * std::sqrt(6.0) * std::exp(-0.5 * peak_x * peak_x);
    static double const x_per_u = 2 * pi / std::sqrt(3.0);
    constexpr int pieces = 24;
    static double const piece = peak_x / x_per_u;
    return {pieces * piece, piece, false, [](double u) {
                double const x = x_per_u * (u - 0.5 * pieces * piece);
                return x * (x * x - 3) * std::exp(-0.5 * x * x) / peak;
            }};
}

// d/dw of [1 + cos(2 pi w/gamma)] cos(2 pi w + nu), times -gamma / (2 pi).
double slope_of_wavelet(double w, PulseParameters const& of) {
    double const slow = 2 * pi * w / of.gamma;
    double const fast = 2 * pi * w + of.phase_rad;
    return std::sin(slow) * std::cos(fast) + of.gamma * (1 + std::cos(slow)) * std::sin(fast);
}

// The largest |slope|: the best of a fine grid, then a parabola through it and its neighbours.
double peak_slope(PulseParameters const& of) {
    constexpr int per_period = 1000;
    int const half = static_cast<int>(std::ceil(0.5 * of.gamma * per_period));
    auto const size = [&](double w) { return std::abs(slope_of_wavelet(w, of)); };
    double best = 0;
    for (int i = -half; i <= half; ++i) {
        best = size(static_cast<double>(i) / per_period) > size(best) ? static_cast<double>(i) / per_period : best;
    }
    constexpr double step = 1.0 / per_period;
    double const before = size(best - step);
    double const behind = size(best + step);
    double const bend = before - 2 * size(best) + behind;
    double const shift = bend < 0 ? 0.5 * step * (before - behind) / bend : 0;
    return std::max(size(best), size(best + shift));
}

PulseShape mavroeidis_papageorgiou(PulseParameters const& of) {
    validate(of.gamma > 1, "gamma {} (a pulse of Mavroeidis and Papageorgiou lasts longer than its period). Raise it",
             of.gamma);
    constexpr double quarter = 0.25;
    double const peak = peak_slope(of);
    return {of.gamma, quarter * of.gamma, false,
            [of, peak](double u) { return -slope_of_wavelet(u - 0.5 * of.gamma, of) / peak; }};
}

}  // namespace

std::span<config::Entry<PulseShapeMaker> const> pulse_shapes() {
    using Entry = config::Entry<PulseShapeMaker>;
    static constexpr std::array entries{
        Entry{"one-sine", "one full cycle of a sine", &one_sine},
        Entry{"half-sine", "the first half cycle of a sine of that period", &half_sine},
        Entry{"one-cosine", "one full cycle of a cosine", &one_cosine},
        Entry{"ricker", "symmetric Ricker wavelet, four periods long", &ricker},
        Entry{"antisymmetric-ricker", "antisymmetric Ricker wavelet, five periods long", &antisymmetric_ricker},
        Entry{parametric_pulse, "near-fault pulse of gamma periods (Mavroeidis and Papageorgiou 2003)",
              &mavroeidis_papageorgiou},
        Entry{"rectangle", "constant for one period", &rectangle},
    };
    return entries;
}

SampledPulse sample_pulse(PulseShape const& shape, double period_s, double longest_step_s) {
    double const piece = shape.quarter * period_s;
    constexpr double slack = 1e-9;
    double const per_piece = std::max(1.0, std::ceil(piece / longest_step_s - slack));
    double const step = piece / per_piece;
    auto const length = static_cast<std::size_t>(std::round(shape.length * period_s / step));
    std::vector<double> values(length + 1);
    for (std::size_t i = 0; i <= length; ++i) {
        values[i] = shape.at(static_cast<double>(i) * shape.quarter / per_piece);
    }
    for (auto* const end : {&values.front(), &values.back()}) {
        *end = shape.jumps ? 0.5 * *end : 0;  // without the rounding of sin(2 pi), or a wavelet's last 1e-15
    }
    return {step, std::move(values)};
}

SampledPulse sample_pulse_alone(PulseShape const& shape, double period_s, double longest_step_s) {
    auto pulse = sample_pulse(shape, period_s, longest_step_s);
    if (shape.jumps) {  // the motion begins and ends with it: no chord leads to or from its ends
        pulse.values.front() = shape.at(0);
        pulse.values.back() = shape.at(shape.length);
    }
    return pulse;
}

}  // namespace overturn
