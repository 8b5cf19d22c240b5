/// Figures of a motion that need no target: duration, residuals, correlation of its components.
#pragma once

#include "motion/ground_motion.hpp"

namespace overturn {

struct WaveQuality {
    double duration_5_75_s = 0;  ///< time between 5 % and 75 % of the Arias integral (Trifunac and Brady 1975) [s]
    double duration_5_95_s = 0;  ///< between 5 % and 95 % [s]
    double residual_velocity_mps = 0;    ///< at the last sample, from rest, with its sign [m/s]
    double residual_displacement_m = 0;  ///< likewise [m]
    double end_velocity_ratio = 0;       ///< |residual velocity| over the peak at samples, the worst component [-]
    double correlation = 0;  ///< of two components, the pair with the largest magnitude, with its sign; 0: just one [-]
};

/// Durations and residuals are those of the horizontal component. Time within a step is divided as if the integral of
/// a^2, exact for straight lines between samples, grew evenly in it.
[[nodiscard]] WaveQuality wave_quality(GroundMotion const& motion);

/// Sample correlation coefficient of two series of one length, means removed; 0 if either does not vary.
[[nodiscard]] double correlation_of(std::span<double const> a, std::span<double const> b);

}  // namespace overturn
