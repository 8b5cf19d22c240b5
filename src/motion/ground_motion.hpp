/// One ground motion: up to three components of acceleration on one time grid, linear between samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overturn {

/// Plain data. Absent components are empty; present ones all have the same length.
struct GroundMotion {
    double time_step_s = 0;               ///< [s]
    std::vector<double> horizontal_mps2;  ///< in the rocking plane [m/s2]
    std::vector<double> transverse_mps2;  ///< the other horizontal one [m/s2]
    std::vector<double> vertical_mps2;    ///< upwards positive [m/s2]

    [[nodiscard]] std::size_t samples() const { return horizontal_mps2.size(); }
    /// Time of the last sample; the first is at 0 [s].
    [[nodiscard]] double duration_s() const {
        return samples() == 0 ? 0 : time_step_s * static_cast<double>(samples() - 1);
    }
    /// All components times `factor`: what they are to each other stays.
    void scale(double factor);
};

/// \throws InputError unless there is at least one horizontal sample, the time step is positive, all samples are finite
/// and present components agree in length.
void validate_motion(GroundMotion const& motion);

/// Velocity at the samples, from rest, exact for acceleration that is linear between them [m/s].
[[nodiscard]] std::vector<double> velocity_of(std::span<double const> acceleration_mps2, double time_step_s);

/// Displacement at the samples, from rest, exact for acceleration that is linear between them [m].
[[nodiscard]] std::vector<double> displacement_of(std::span<double const> acceleration_mps2, double time_step_s);

/// max |x|; 0 for an empty span.
[[nodiscard]] double peak_of(std::span<double const> values);

}  // namespace overturn
