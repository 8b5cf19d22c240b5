#include "generators/wave_source.hpp"

#include <array>
#include <cmath>

#include "core/error.hpp"
#include "generators/aftershock.hpp"
#include "generators/filtered_noise.hpp"
#include "generators/harmonic.hpp"
#include "generators/pulse.hpp"
#include "generators/records.hpp"
#include "generators/spectrum_compatible.hpp"

namespace overturn {

std::span<config::Entry<WaveSourceMaker> const> wave_sources() {
    static constexpr std::array entries{
        config::Entry<WaveSourceMaker>{"spectrum-compatible",
                                       "random waves matched to a target spectrum, or drawn from it",
                                       &make_spectrum_compatible},
        config::Entry<WaveSourceMaker>{
            "filtered-noise", "random noise through the ground: Kanai-Tajimi, Clough-Penzien", &make_filtered_noise},
        config::Entry<WaveSourceMaker>{"harmonic", "sinusoids, one wave for each frequency of a sweep", &make_harmonic},
        config::Entry<WaveSourceMaker>{"pulse", "single pulses: one-sine, half-sine, ricker, rectangle", &make_pulse},
        config::Entry<WaveSourceMaker>{"records", "measured waves from files", &make_records},
    };
    return entries;
}

std::unique_ptr<WaveSource> make_wave_source(config::Table const& waves, InputFiles& files) {
    return with_aftershock(waves, waves.choice("source", wave_sources())(waves, files));
}

std::size_t read_samples(config::Table const& waves, double time_step_s) {
    constexpr double most = 5e6;
    constexpr double fewest = 100;
    double const steps = std::round(waves.number("duration", Dimension::time, config::Range::positive()) / time_step_s);
    if (steps < fewest || steps > most) {
        waves.fail("duration",
                   fmt::format("{} time steps (must be {} to {}). Mend duration or time_step", steps, fewest, most));
    }
    return static_cast<std::size_t>(steps) + 1;
}

void validate_wave(std::uint64_t wave, std::uint64_t available) {
    validate(wave < available, "wave {} of {} (counted from 0; there are no more). Lower waves.count", wave, available);
}

}  // namespace overturn
