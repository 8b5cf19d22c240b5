#include "generators/detail/long_period_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace overturn {

LongPeriodStep::LongPeriodStep(std::vector<double> periods_s, double damping, NoiseLines const& noise)
    : periods_s_(std::move(periods_s)),
      damping_(damping),
      first_row_(static_cast<std::size_t>(std::ranges::lower_bound(periods_s_, from_s) - periods_s_.begin())) {
    constexpr double beyond = 1.5;  // lines this much faster than the fastest of these oscillators still move it
    double const highest = beyond * 2 * pi / from_s / noise.spacing_radps();
    end_line_ = std::min(noise.count(), static_cast<std::size_t>(highest) + 1);
}

// What a line of unit amplitude puts into an oscillator by the instant: the lines of its memory of the envelope.
Lines LongPeriodStep::into_peak(double period_s, double time_s, std::span<double const> envelope,
                                NoiseLines const& noise) const {
    double const w = 2 * pi / period_s;
    double const damped = w * std::sqrt(1 - damping_ * damping_);
    double const dt = noise.time_step_s();
    auto const last = std::min(static_cast<std::size_t>(time_s / dt), envelope.size() - 1);
    std::vector<double> memory(envelope.size(), 0.0);
    // exp(-zeta w s) sin(w_d s), from the instant backwards.
    std::complex<double> const turn = std::polar(std::exp(-damping_ * w * dt), damped * dt);
    double const since = time_s - static_cast<double>(last) * dt;
    auto kernel = std::polar(std::exp(-damping_ * w * since), damped * since);
    for (std::size_t i = last + 1; i-- > 0;) {
        memory[i] = kernel.imag() * envelope[i] * dt / damped;
        kernel *= turn;
    }
    return noise.products(memory, end_line_);
}

void LongPeriodStep::apply(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
                           std::span<double const> envelope, NoiseLines const& noise) const {
    constexpr double most = 0.4;      // no step changes a peak or a line by more: the sum is of first order
    constexpr double damping = 5e-2;  // of the normal equations
    using Eigen::Index;
    Index const rows = periods_s_.size() - first_row_;
    Index const first = noise.first();
    auto const count = static_cast<Index>(end_line_) - first;
    if (rows <= 0 || count <= 0) {
        return;
    }
    Eigen::MatrixXd shares(rows, 2 * count);
    Eigen::VectorXd goals(rows);
    for (Index r = 0; r < rows; ++r) {
        auto const i = first_row_ + static_cast<std::size_t>(r);
        auto const into = into_peak(periods_s_[i], peaks[i].time_s, envelope, noise);
        double sum = 0;
        for (std::size_t k = noise.first(); k < end_line_; ++k) {
            sum += (lines[k] * into[k]).real();
        }
        // The sign of the peak is that of what slow lines make of it, which is most of it.
        double const peak = std::copysign(std::abs(peaks[i].displacement_m), sum);
        double const inverse = peak == 0 ? 0 : 1 / peak;
        for (Index c = 0; c < count; ++c) {
            std::size_t const k = first + c;
            auto const part = lines[k] * into[k] * inverse;
            shares(r, c) = part.real();
            shares(r, count + c) = -part.imag();
        }
        goals(r) = std::clamp(ratios[i] - 1, -most, most);
    }
    Eigen::MatrixXd normal = shares * shares.transpose();
    normal.diagonal().array() += damping * normal.trace() / static_cast<double>(rows);
    Eigen::VectorXd gains = shares.transpose() * normal.ldlt().solve(goals);
    double const largest = gains.cwiseAbs().maxCoeff();
    gains *= largest > most ? most / largest : 1;
    for (Index c = 0; c < count; ++c) {
        lines[first + c] *= std::complex<double>(1 + gains(c), gains(count + c));
    }
}

}  // namespace overturn
