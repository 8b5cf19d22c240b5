/// Makes the ground stand still, where it began, when a wave ends.
#pragma once

#include <cstddef>
#include <span>

namespace overturn {

/// After the last sample: velocity over the time step, and displacement over its square.
struct GroundEnd {
    double velocity, displacement;
};

/// bump s(1-s) + wave s(1-s)(2s-1) of the share s of the duration: zero at both ends; the second part is odd about the
/// middle and ends without velocity.
struct BaselinePolynomial {
    double bump, wave;

    [[nodiscard]] double operator()(double s) const {
        return bump * (s * (1 - s)) + wave * (s * (1 - s) * (2 * s - 1));
    }
};

/// The polynomial that brings ground at rest to such an end, as velocity_of and displacement_of compute it.
/// \pre at least 5 samples
[[nodiscard]] BaselinePolynomial polynomial_ending(GroundEnd end, std::size_t samples);

/// Subtracts the polynomial that brings the velocity and the displacement after the last sample to 0. Periods far below
/// the duration do not notice: of acceleration it takes about 6 times the end velocity over the duration. Leaves the
/// first and last sample alone; waves of fewer than 5 samples altogether.
void correct_baseline(std::span<double> acceleration_mps2);

/// The same to another end.
void correct_baseline_to(std::span<double> acceleration_mps2, GroundEnd wanted);

}  // namespace overturn
