/// Ground noise: white noise at depth through a filter that stands for the ground, under an envelope.
#pragma once

#include <memory>

#include "generators/wave_source.hpp"

namespace overturn {

/// One-sided density of ground acceleration G(w) [m2/s3]. Kanai (1957) and Tajimi (1960), r = w / ground frequency:
///     G0 (1 + 4 z^2 r^2) / ((1 - r^2)^2 + 4 z^2 r^2);
/// Clough and Penzien (1975) multiply it by q^4 / ((1 - q^2)^2 + 4 zf^2 q^2), q = w / filter frequency, without which
/// displacement has no bound.
struct GroundFilter {
    double ground_radps = 15.6;  ///< firm ground
    double ground_damping = 0.6;
    double filter_radps = 0;  ///< 0: Kanai-Tajimi
    double filter_damping = 0.6;

    [[nodiscard]] double shape(double w_radps) const;
    /// The integral of shape over all frequencies in closed form: the variance for G0 = 1 [rad/s].
    [[nodiscard]] double integral_radps() const;
};

/// Its keys in [waves].
extern config::KeyTable const filtered_noise_table;

/// A density of points is straight between them and nothing outside. Lines above the Nyquist frequency are left out;
/// those below it have all of rms^2. A polynomial brings the ground to rest where it began (correct_baseline).
[[nodiscard]] std::unique_ptr<WaveSource> make_filtered_noise(config::Table const& waves, InputFiles& files);

}  // namespace overturn
