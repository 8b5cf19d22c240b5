#include "generators/spectrum_compatible.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/spectrum_matcher.hpp"
#include "spectra/target_input.hpp"

namespace overturn {
namespace {

enum class Match { each, none };

constexpr std::array matches{
    config::Entry<Match>{"each", "every wave is iterated to the target", Match::each},
    config::Entry<Match>{"none", "waves are left as they are drawn", Match::none},
};
constexpr std::array line_amplitudes{
    config::Entry<LineAmplitudes>{"fixed", "random phases only", LineAmplitudes::fixed},
    config::Entry<LineAmplitudes>{"gaussian", "random phases and amplitudes", LineAmplitudes::gaussian},
};

class SpectrumCompatible : public WaveSource {
  public:
    SpectrumCompatible(SpectrumMatcherInput const& input, std::optional<TargetSpectrum> const& vertical_target)
        : horizontal_(input) {
        summary_ = fmt::format("{} samples of {} s, target {} at {} % damping to {:g} s, {}", input.samples,
                               input.time_step_s, input.target.name(), 100 * input.target.damping(), input.longest_s,
                               input.iterations > 0 ? "each wave matched" : "not matched");
        time_step_s_ = input.time_step_s;
        if (vertical_target) {
            auto vertical = input;
            vertical.target = *vertical_target;
            vertical_.emplace(vertical);
            constexpr double at_s = 1;
            summary_ +=
                fmt::format(", vertical target {}, {:.3g} of the horizontal one at {} s", vertical_target->name(),
                            vertical_target->psa_mps2(at_s) / input.target.psa_mps2(at_s), at_s);
        }
    }

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const override {
        constexpr std::uint64_t horizontal_stream = 0;
        constexpr std::uint64_t vertical_stream = 1;
        GeneratedWave made;
        made.motion.time_step_s = time_step_s_;
        auto horizontal = horizontal_.make(seed, wave, horizontal_stream);
        made.motion.horizontal_mps2 = std::move(horizontal.acceleration_mps2);
        made.match = horizontal.match;
        if (vertical_) {
            auto vertical = vertical_->make(seed, wave, vertical_stream);
            made.motion.vertical_mps2 = std::move(vertical.acceleration_mps2);
            made.vertical_match = vertical.match;
        }
        made.label = fmt::format("random wave {}", wave);
        return made;
    }

    [[nodiscard]] std::string describe() const override { return summary_; }

  private:
    SpectrumMatcher horizontal_;
    std::optional<SpectrumMatcher> vertical_;
    double time_step_s_ = 0;
    std::string summary_;
};

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

Match read_match(config::Table const& waves) {
    if (waves.text("match", "each") == "ensemble") {
        waves.fail("match", "'ensemble' (matching in the mean does not exist yet). Use each or none");
    }
    return waves.choice<Match>("match", matches, Match::each);
}

double read_longest(config::Table const& table, TargetSpectrum const& target, double duration_s) {
    constexpr double usual = 10;
    constexpr double most = 20;
    double const longest = table.number("longest", Dimension::time, {.low = 0.2, .high = most},
                                        std::min({usual, target.last_period_s(), duration_s}));
    if (longest > duration_s) {
        table.fail("longest", fmt::format("{} s (longer than the wave of {} s). Lower it", longest, duration_s));
    }
    return longest;
}

}  // namespace

namespace {

// The vertical component's target: its own, or a ratio of the horizontal one; nothing if there is no such component.
std::optional<TargetSpectrum> read_vertical(config::Table const& waves, TargetSpectrum const& horizontal,
                                            InputFiles& files) {
    if (!waves.has("vertical")) {
        return std::nullopt;
    }
    auto const vertical = waves.child("vertical");
    std::optional<TargetSpectrum> target;
    if (vertical.has("target")) {
        auto const own = vertical.child("target");
        target = read_target(own, files);
        own.finish();
    } else {
        target = horizontal.scaled(vertical.number("ratio", Dimension::none, {.low = 0, .high = 10, .low_open = true}));
    }
    vertical.finish();
    return target;
}

}  // namespace

std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files) {
    double const time_step = waves.number("time_step", Dimension::time, {.low = 1e-4, .high = 0.1}, 0.01);
    auto const samples = read_samples(waves, time_step);
    double const duration = time_step * static_cast<double>(samples - 1);
    auto const target_table = waves.child("target");
    auto const target = read_target(target_table, files);
    double const longest = read_longest(target_table, target, duration);
    target_table.finish();
    SpectrumMatcherInput input{
        .target = target,
        .longest_s = longest,
        .time_step_s = time_step,
        .samples = samples,
        .envelope = read_envelope(waves.child_or_empty("envelope"), duration),
        .amplitudes = waves.choice<LineAmplitudes>("amplitudes", line_amplitudes, LineAmplitudes::fixed),
        .iterations = 0};
    if (read_match(waves) == Match::each) {
        input.tolerance = waves.number("match_tolerance", Dimension::none, {.low = 0.001, .high = 1}, 0.05);
        input.iterations = static_cast<int>(waves.integer("match_iterations", 1, 1000, 100));
    }
    auto const vertical = read_vertical(waves, target, files);
    return waves.located("target", [&] { return std::make_unique<SpectrumCompatible>(input, vertical); });
}

}  // namespace overturn
