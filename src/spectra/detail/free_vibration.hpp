/// Free vibration of an oscillator once the ground has come to rest.
#pragma once

#include <span>
#include <vector>

namespace overturn {

/// A series up to its last value that is not zero and one zero behind it: ground that has come to rest.
[[nodiscard]] std::vector<double> come_to_rest(std::span<double const> acceleration);

/// The f of largest size from now on of f'' + 2 zeta w f' + w^2 f = 0, in closed form: now, or at the first turning
/// point. \param rate f' now
struct FreePeak {
    double value = 0;   ///< with its sign
    double time_s = 0;  ///< from now [s]
};
[[nodiscard]] FreePeak free_peak_and_time(double angular_frequency_radps, double damping, double now, double rate);

/// Largest |f| from now on, without its time.
[[nodiscard]] double free_peak(double angular_frequency_radps, double damping, double now, double rate);

/// The largest displacement, velocity and absolute acceleration of an oscillator at (y, v) over still ground.
struct FreePeaks {
    double displacement_m = 0;     ///< [m]
    double velocity_mps = 0;       ///< [m/s]
    double acceleration_mps2 = 0;  ///< [m/s2]
};
[[nodiscard]] FreePeaks free_peaks(double angular_frequency_radps, double damping, double displacement_m,
                                   double velocity_mps);

}  // namespace overturn
