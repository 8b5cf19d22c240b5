/// A mixture of failure pulses: where normals are drawn from so that failure is common, and what such a draw weighs.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/random_stream.hpp"
#include "rare/problem.hpp"

namespace overturn::rare {

/// Step of a pulse's strength, as a share of the mean: so that a wrong length costs less.
inline constexpr double strength_step = 0.15;
inline constexpr std::array<double, 3> pulse_strengths{1 - strength_step, 1, 1 + strength_step};

/// A shift of a wave's lines: the mean of similar failing waves, moved so that they fail at time 0.
struct Pulse {
    std::vector<std::complex<double>> lines;  ///< M_k, k = 1, 2, ...
    double share = 0;                         ///< pi_c: how often it is chosen
    std::vector<double> arrival;              ///< w_c(j): how often it arrives at time j duration / size
};

/// q = w0 f + (1 - w0) sum_c pi_c sum_j w_c(j) mean over sign and kappa (pulse_strengths) of the normals f shifted by
/// +-kappa M_c exp(-i w t_j). The weight of a draw is f / q, at most 1 / w0: no event can be missed by more than a
/// factor of 1 / w0 in variance. Without pulses q = f and every weight is 1.
class Mixture {
  public:
    static constexpr double plain_share = 0.1;  ///< w0, of draws that are left as they are

    explicit Mixture(PulseFrame const& frame) : frame_(frame) {}
    /// \pre pulses agree in their sizes; shares add up to 1, arrivals of each too
    Mixture(PulseFrame const& frame, std::vector<Pulse> pulses);

    [[nodiscard]] std::vector<Pulse> const& pulses() const { return pulses_; }

    /// Shifts plain normals into a draw of the mixture; false: it was left as it is.
    bool shift(std::span<double> normals, RandomStream& choice) const;
    [[nodiscard]] double weight(std::span<double const> normals) const;
    /// The same with all pulses `factor` times as strong.
    [[nodiscard]] Mixture strengthened(double factor) const;

    /// Points in time at which pulses may arrive: 2^n, enough to resolve the highest line's phases.
    [[nodiscard]] static std::size_t grid_of(PulseFrame const& frame);

  private:
    PulseFrame frame_;
    std::vector<Pulse> pulses_;
    std::vector<double> squares_;              ///< |M_c|^2
    std::vector<double> totals_;               ///< running sums of shares, then of each pulse's arrivals
    std::vector<std::complex<double>> turns_;  ///< exp(-2 pi i m / grid)
};

}  // namespace overturn::rare
