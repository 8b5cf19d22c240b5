/// Makes the ground stand still, where it began, when a wave ends.
#pragma once

#include <span>

namespace overturn {

/// Subtracts s(1-s)(c0 + c1 (2s-1)), s = t/duration, with the c0 and c1 that bring the velocity and the displacement
/// after the last sample to 0 (as velocity_of and displacement_of compute them). Periods far below the duration do not
/// notice: of acceleration it takes about 6 times the end velocity over the duration. Leaves the first and last sample
/// alone; waves of fewer than 5 samples altogether.
void correct_baseline(std::span<double> acceleration_mps2);

/// The same to another end: velocity over the time step, and displacement over its square, after the last sample.
void correct_baseline_to(std::span<double> acceleration_mps2, double velocity, double displacement);

}  // namespace overturn
