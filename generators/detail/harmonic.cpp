#include "generators/detail/harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "generators/detail/baseline.hpp"
#include "generators/detail/components.hpp"

namespace overturn {
namespace {

struct HarmonicInput {
    double amplitude_mps2 = 0;
    std::vector<double> periods_s;
    std::optional<double> cycles;
    double duration_s = 0;
    double time_step_s = 0;
    double ramp_s = 0;
    struct Further {
        FurtherComponent component;
        double ratio, phase_rad;
    };
    std::vector<Further> further{};
};

WaveDescription description_of(HarmonicInput const& input) {
    auto text = fmt::format("{} sinusoids of {} m/s2", input.periods_s.size(), input.amplitude_mps2);
    for (auto const& [component, ratio, phase_rad] : input.further) {
        text += fmt::format(", {} {:g} of it, {:g} deg ahead", component.name, ratio, phase_rad * 180 / pi);
    }
    return {.text = text,
            .variability = fmt::format("a grid of {} frequencies: no random sample", input.periods_s.size()),
            .available = input.periods_s.size(),
            .grid_periods_s = input.periods_s};
}

class Harmonic : public WaveSource {
  public:
    explicit Harmonic(HarmonicInput input) : WaveSource(description_of(input)), input_(std::move(input)) {}

    [[nodiscard]] GeneratedWave make(std::uint64_t /*seed*/, std::uint64_t wave) const override {
        validate_wave(wave, input_.periods_s.size());
        double const period = input_.periods_s[wave];
        double const duration = duration_of(period);
        auto const steps = static_cast<std::size_t>(std::round(duration / input_.time_step_s));
        GeneratedWave made;
        made.motion.time_step_s = input_.time_step_s;
        made.motion.horizontal_mps2 = sinusoid(period, steps, 1, 0);
        for (auto const& [component, ratio, phase_rad] : input_.further) {
            made.motion.*(component.place) = sinusoid(period, steps, ratio, phase_rad);
        }
        made.label = fmt::format("sinusoid of {:g} Hz", 1 / period);
        return made;
    }

    [[nodiscard]] std::string pgd_drift() const override {
        bool const short_ramp = std::ranges::any_of(input_.periods_s, [&](double p) { return input_.ramp_s < p; });
        return short_ramp ? "a sinusoid that begins at once drifts on the velocity it begins with; state a ramp of "
                            "some cycles in [waves]"
                          : "";
    }

  private:
    [[nodiscard]] std::vector<double> sinusoid(double period_s, std::size_t steps, double ratio,
                                               double phase_rad) const {
        std::vector<double> samples(steps + 1);
        for (std::size_t i = 0; i <= steps; ++i) {
            double const t = input_.time_step_s * static_cast<double>(i);
            double const near_end = std::min(t, input_.time_step_s * static_cast<double>(steps - i));
            double const ramp = input_.ramp_s > 0 ? std::min(1.0, near_end / input_.ramp_s) : 1.0;
            samples[i] = ratio * (ramp * input_.amplitude_mps2 * std::sin(2 * pi * t / period_s + phase_rad));
        }
        steady(samples, ratio * input_.amplitude_mps2, 2 * pi * input_.time_step_s / period_s, phase_rad);
        return samples;
    }
    // A ramp of a broken number of cycles leaves a velocity behind, on which the ground drifts away for the rest of the
    // wave: the ramps are bent until the motion between them is the sinusoid's own, about where the ground stood. With
    // a on straight lines, v = -a dt cot(s/2) / 2 cos and d = -a dt^2 (2 + cos s) / (6 (1 - cos s)) sin, s = w dt.
    void steady(std::vector<double>& samples, double amplitude, double step_rad, double phase_rad) const {
        auto const ramp = static_cast<std::size_t>(std::ceil(input_.ramp_s / input_.time_step_s));
        if (ramp == 0 || 2 * ramp >= samples.size()) {
            return;
        }
        double const v = amplitude / (2 * std::tan(step_rad / 2));
        double const d = amplitude * (2 + std::cos(step_rad)) / (6 * (1 - std::cos(step_rad)));
        auto const bend = [&](std::size_t sample, double direction) {
            double const angle = step_rad * static_cast<double>(sample) + phase_rad;
            correct_baseline_to(std::span(samples).first(ramp + 1),
                                {-direction * v * std::cos(angle), -d * std::sin(angle)});
        };
        bend(ramp, 1);
        std::ranges::reverse(samples);  // the end backwards in time, in which velocities are the other way round
        bend(samples.size() - 1 - ramp, -1);
        std::ranges::reverse(samples);
    }
    [[nodiscard]] double duration_of(double period_s) const {
        return input_.cycles ? *input_.cycles * period_s : input_.duration_s;
    }

    HarmonicInput input_;
};

}  // namespace

namespace {

constexpr config::Keys grid_keys{
    config::number_key("period", Dimension::time, config::Range::positive(), "period of the wave").optional(),
    config::numbers_key("periods", Dimension::time, config::Range::positive(), "period of each wave").optional()};

constexpr config::Keys harmonic_component_keys{
    ratio_key,
    config::number_key("phase", Dimension::angle, config::Range::any(), "phase lead over the horizontal component")
        .otherwise(0)};
constexpr config::KeyTable harmonic_component_table{.meaning = "a further component of sinusoids",
                                                    .keys = harmonic_component_keys.all};

constexpr config::Key either_number_or_list(std::string_view name) {
    constexpr auto positive = config::Range::positive();
    return config::number_key(name, Dimension::frequency, positive, "frequency of the wave, or of each wave")
        .or_as(config::numbers_key(name, Dimension::frequency, positive, ""))
        .optional();
}

constexpr config::Keys harmonic_keys{
    config::number_key("amplitude", Dimension::acceleration, config::Range::positive(), "amplitude of the sinusoid"),
    either_number_or_list("frequency"),
    either_number_or_list("frequencies"),
    config::number_key("cycles", Dimension::none, config::Range::positive(), "duration in periods; or state duration")
        .optional(),
    config::number_key("duration", Dimension::time, config::Range::positive(), "duration; or state cycles").optional(),
    config::number_key("ramp", Dimension::time, config::Range::not_negative(),
                       "time of linear growth at the start and of decay at the end")
        .otherwise(0),
    config::number_key("time_step", Dimension::time, {.low = 1e-5, .high = 1}, "time step").otherwise(0.01),
    transverse_key<harmonic_component_table>,
    vertical_key<harmonic_component_table>};

}  // namespace

constinit config::KeyTable const grid_table{.meaning = "of waves on a grid of periods", .keys = grid_keys.all};
constinit config::KeyTable const harmonic_table{.meaning = "sinusoids, one wave for each period or frequency",
                                                .keys = harmonic_keys.all,
                                                .also = {&every_wave_table, &grid_table},
                                                .chosen_by = "source",
                                                .word = "harmonic"};

std::vector<double> read_periods(config::Table const& waves, bool frequencies_too) {
    std::vector<double> periods;
    int stated = 0;
    if (waves.has("period")) {
        periods = {waves.number(grid_keys["period"])};
        ++stated;
    }
    if (waves.has("periods")) {
        periods = waves.numbers(grid_keys["periods"]);
        ++stated;
    }
    for (auto const& key : {harmonic_keys["frequency"], harmonic_keys["frequencies"]}) {
        if (frequencies_too && waves.has(key.name)) {
            periods = waves.kind(key.name) == config::Kind::list ? waves.numbers(key) : std::vector{waves.number(key)};
            std::transform(periods.begin(), periods.end(), periods.begin(), [](double f) { return 1 / f; });
            ++stated;
        }
    }
    if (stated != 1 || periods.empty()) {
        waves.fail({}, frequencies_too ? "no single frequency (state one of frequency, frequencies, period, periods)"
                                       : "no single period (state one of period, periods)");
    }
    return periods;
}

std::unique_ptr<WaveSource> make_harmonic(config::Table const& waves, InputFiles& /*files*/) {
    HarmonicInput input;
    input.amplitude_mps2 = waves.number(harmonic_keys["amplitude"]);
    input.periods_s = read_periods(waves, true);
    input.time_step_s = waves.number(harmonic_keys["time_step"]);
    input.ramp_s = waves.number(harmonic_keys["ramp"]);
    if (waves.has("cycles") == waves.has("duration")) {
        waves.fail({}, "no single length (state either cycles or duration)");
    }
    input.cycles = waves.maybe_number(harmonic_keys["cycles"]);
    input.duration_s = waves.maybe_number(harmonic_keys["duration"]).value_or(0);
    for (double const period : input.periods_s) {
        constexpr double fewest = 4;
        if (period < fewest * input.time_step_s) {
            waves.fail("time_step", fmt::format("{} s (a period of {} s needs at least {} steps). Lower it",
                                                input.time_step_s, period, fewest));
        }
        double const duration = input.cycles ? *input.cycles * period : input.duration_s;
        if (duration < 2 * input.time_step_s || duration < 2 * input.ramp_s || duration > 1e6 * input.time_step_s) {
            waves.fail({}, fmt::format("a wave of {} s (must hold both ramps and 2 to 1e6 time steps). Mend its length",
                                       duration));
        }
    }
    for (auto const& component : further_components) {
        if (waves.has(component.name)) {
            auto const table = waves.child(component.name);
            double const ratio = read_ratio(table);
            input.further.push_back({component, ratio, table.number(harmonic_component_keys["phase"])});
            table.finish();
        }
    }
    return std::make_unique<Harmonic>(std::move(input));
}

}  // namespace overturn
