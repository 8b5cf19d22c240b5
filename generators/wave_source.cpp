#include "generators/wave_source.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "generators/detail/aftershock.hpp"
#include "generators/detail/filtered_noise.hpp"
#include "generators/detail/harmonic.hpp"
#include "generators/detail/pulse.hpp"
#include "generators/detail/records.hpp"
#include "generators/spectrum_compatible.hpp"

namespace overturn {

std::optional<Drift> WaveSource::drift(std::uint64_t wave) const {
    if (about_.measured.empty()) {
        return std::nullopt;
    }
    validate_wave(wave, about_.measured.size());
    return about_.measured[wave].drift;
}

std::string WaveSource::name(std::uint64_t wave) const {
    if (about_.measured.empty()) {
        return {};
    }
    validate_wave(wave, about_.measured.size());
    return about_.measured[wave].name;
}

std::string WaveSource::called(std::uint64_t wave) const {
    auto const of_record = name(wave);
    return of_record.empty() ? fmt::format("wave {}", wave) : fmt::format("record '{}'", of_record);
}

GroundMotion const* WaveSource::began_with(std::uint64_t wave) const {
    return wave < about_.began_with.size() ? &about_.began_with[wave] : nullptr;
}

namespace {

constexpr config::Keys every_wave_keys{config::word_key<wave_sources>("source", "where the waves come from"),
                                       wave_count_key};

}  // namespace

constinit config::KeyTable const every_wave_table{.meaning = "the waves", .keys = every_wave_keys.all};

std::span<config::Entry<WaveSourceKind> const> wave_sources() {
    static constexpr std::array entries{
        config::Entry<WaveSourceKind>{"spectrum-compatible",
                                      "random waves matched to a target spectrum, or drawn from it",
                                      {&make_spectrum_compatible, &spectrum_compatible_table}},
        config::Entry<WaveSourceKind>{"filtered-noise",
                                      "random noise through the ground: Kanai-Tajimi, Clough-Penzien",
                                      {&make_filtered_noise, &filtered_noise_table}},
        config::Entry<WaveSourceKind>{
            "harmonic", "sinusoids, one wave for each frequency of a sweep", {&make_harmonic, &harmonic_table}},
        config::Entry<WaveSourceKind>{
            "pulse", "single pulses of a stated shape and period", {&make_pulse, &pulse_table}},
        config::Entry<WaveSourceKind>{"records", "recorded motions from files", {&make_records, &records_table}},
    };
    return entries;
}

std::vector<config::KeyTable const*> wave_tables() {
    std::vector<config::KeyTable const*> tables;
    for (auto const& entry : wave_sources()) {
        tables.push_back(entry.value.keys);
    }
    return tables;
}

std::unique_ptr<WaveSource> make_wave_source(config::Table const& waves, InputFiles& files) {
    return with_aftershock(waves, waves.choice(every_wave_keys["source"], wave_sources()).make(waves, files));
}

std::size_t read_samples(config::Table const& waves, double time_step_s) {
    constexpr double most = 5e6;
    constexpr double fewest = 100;
    double const steps = std::round(waves.number(wave_duration_key) / time_step_s);
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
