/// Keys of filtered noise.
#pragma once

#include <array>

#include "config/table.hpp"
#include "core/units.hpp"
#include "generators/detail/components.hpp"
#include "generators/detail/filtered_noise.hpp"
#include "generators/detail/line_draws.hpp"
#include "generators/detail/point_density.hpp"
#include "generators/envelope.hpp"
#include "generators/wave_source.hpp"

namespace overturn {

enum class NoiseModel { kanai_tajimi, clough_penzien, points };
inline constexpr std::array noise_models{
    config::Entry<NoiseModel>{"kanai-tajimi", "one ground layer", NoiseModel::kanai_tajimi},
    config::Entry<NoiseModel>{"clough-penzien", "one ground layer, low frequencies held back",
                              NoiseModel::clough_penzien},
    config::Entry<NoiseModel>{"points", "a power spectral density of the user's own", NoiseModel::points},
};
inline constexpr std::array noise_amplitudes{
    config::Entry<LineAmplitudes>{"gaussian", "random phases and amplitudes", LineAmplitudes::gaussian},
    config::Entry<LineAmplitudes>{"fixed", "random phases only", LineAmplitudes::fixed},
};

inline constexpr config::Range filter_dampings{.low = 0, .high = 10, .low_open = true};
inline constexpr config::Keys noise_component_keys{ratio_key, correlation_key};
inline constexpr config::KeyTable noise_component_table{.meaning = "a further component of filtered noise",
                                                        .keys = noise_component_keys.all};
inline constexpr config::Keys noise_keys{
    config::word_key<noise_models>("model", "model of the ground"),
    config::number_key("rms", Dimension::acceleration, config::Range::positive(),
                       "root mean square acceleration of the stationary noise, before the envelope"),
    wave_duration_key,
    config::number_key("time_step", Dimension::time, {.low = 1e-4, .high = 0.1}, "time step").otherwise(0.01),
    config::word_key<noise_amplitudes>("amplitudes", "Fourier amplitudes: fixed or Gaussian").otherwise("gaussian"),
    config::number_key("ground_frequency", Dimension::frequency, config::Range::positive(),
                       "frequency of the ground layer")
        .otherwise(2.5)
        .only("model = kanai-tajimi or clough-penzien"),
    config::number_key("ground_damping", Dimension::none, filter_dampings, "damping ratio of the ground layer")
        .otherwise(GroundFilter{}.ground_damping)
        .only("model = kanai-tajimi or clough-penzien"),
    config::number_key("filter_frequency", Dimension::frequency, config::Range::positive(),
                       "corner frequency of the high-pass filter")
        .otherwise(0.25)
        .only("model = clough-penzien"),
    config::number_key("filter_damping", Dimension::none, filter_dampings, "damping ratio of the high-pass filter")
        .otherwise(GroundFilter{}.filter_damping)
        .only("model = clough-penzien"),
    config::table_key<point_density_table>("density", "the power spectral density").only("model = points"),
    config::table_key<envelope_table>("envelope", "envelope of the amplitude over time").optional(),
    transverse_key<noise_component_table>,
    vertical_key<noise_component_table>};

}  // namespace overturn
