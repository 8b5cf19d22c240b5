#include "generators/wave_source.hpp"

#include <array>

#include "core/error.hpp"
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
        config::Entry<WaveSourceMaker>{"harmonic", "sinusoids, one wave for each frequency of a sweep", &make_harmonic},
        config::Entry<WaveSourceMaker>{"pulse", "single pulses: one-sine, half-sine, ricker, rectangle", &make_pulse},
        config::Entry<WaveSourceMaker>{"records", "measured waves from files", &make_records},
    };
    return entries;
}

std::unique_ptr<WaveSource> make_wave_source(config::Table const& waves, InputFiles& files) {
    return waves.choice("source", wave_sources())(waves, files);
}

void validate_wave(std::uint64_t wave, std::uint64_t available) {
    validate(wave < available, "wave {} of {} (counted from 0; there are no more). Lower waves.count", wave, available);
}

}  // namespace overturn
