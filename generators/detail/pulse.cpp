#include "generators/detail/pulse.hpp"

#include <algorithm>
#include <cmath>

#include "generators/detail/components.hpp"
#include "generators/detail/harmonic.hpp"

namespace overturn {
namespace {

struct PulseInput {
    PulseShape shape{};
    std::string name;
    double amplitude_mps2 = 0;
    std::vector<double> periods_s;
    double time_step_s = 0;
    double quiet_before_s = 0, quiet_after_s = 0;
    struct Further {
        FurtherComponent component;
        double ratio, lag_s;
    };
    std::vector<Further> further{};
};

std::size_t steps_in(double time_s, double step_s) { return static_cast<std::size_t>(std::round(time_s / step_s)); }

WaveDescription description_of(PulseInput const& input) {
    auto text = fmt::format("{} {} pulses of {} m/s2", input.periods_s.size(), input.name, input.amplitude_mps2);
    for (auto const& [component, ratio, lag_s] : input.further) {
        text += fmt::format(", {} {:g} of it, {:g} s later", component.name, ratio, lag_s);
    }
    return {.text = text,
            .variability = fmt::format("a grid of {} periods: no random sample", input.periods_s.size()),
            .available = input.periods_s.size(),
            .grid_periods_s = input.periods_s};
}

class Pulse : public WaveSource {
  public:
    explicit Pulse(PulseInput input) : WaveSource(description_of(input)), input_(std::move(input)) {}

    [[nodiscard]] GeneratedWave make(std::uint64_t /*seed*/, std::uint64_t wave) const override {
        validate_wave(wave, input_.periods_s.size());
        double const period = input_.periods_s[wave];
        auto const pulse = sample_pulse(input_.shape, period, input_.time_step_s);
        std::size_t const margin = input_.shape.jumps ? 1 : 0;
        auto const before = std::max(margin, steps_in(input_.quiet_before_s, pulse.time_step_s));
        auto const after = std::max(margin, steps_in(input_.quiet_after_s, pulse.time_step_s));
        GeneratedWave made;
        made.motion.time_step_s = pulse.time_step_s;
        auto& samples = made.motion.horizontal_mps2;
        samples.assign(before + pulse.values.size() + after, 0.0);
        for (std::size_t i = 0; i < pulse.values.size(); ++i) {
            samples[before + i] = input_.amplitude_mps2 * pulse.values[i];
        }
        add_further(made.motion);
        made.label = fmt::format("{} of {:g} s", input_.name, period);
        return made;
    }

    [[nodiscard]] std::string pgd_drift() const override {
        auto const motion = make(0, 0).motion;
        constexpr double rest = 1e-3;  // of the largest velocity
        auto const velocity = velocity_of(motion.horizontal_mps2, motion.time_step_s);
        return std::abs(velocity.back()) > rest * peak_of(velocity) ? fmt::format(
                   "a {} pulse leaves the ground moving, on and on through the quiet behind it", input_.name)
                                                                    : "";
    }

  private:
    // The same pulse, later by whole samples; all components grow to the longest.
    void add_further(GroundMotion& motion) const {
        auto const pulse = motion.horizontal_mps2;
        auto most = pulse.size();
        for (auto const& further : input_.further) {
            auto& place = motion.*(further.component.place);
            place.assign(steps_in(further.lag_s, motion.time_step_s), 0.0);
            for (double const value : pulse) {
                place.push_back(further.ratio * value);
            }
            most = std::max(most, place.size());
        }
        motion.horizontal_mps2.resize(most);
        for (auto const& further : input_.further) {
            (motion.*(further.component.place)).resize(most);
        }
    }

    PulseInput input_;
};

constexpr config::Range quiet{.low = 0, .high = 1000};
constexpr config::Keys pulse_component_keys{
    ratio_key, config::number_key("lag", Dimension::time, quiet, "delay after the horizontal component").otherwise(0)};
constexpr config::KeyTable pulse_component_table{.meaning = "a further component of pulses",
                                                 .keys = pulse_component_keys.all};
constexpr config::Keys pulse_keys{
    config::word_key<pulse_shapes>("shape", "form of the pulse"),
    config::number_key("gamma", Dimension::none, {.low = 1, .high = 100, .low_open = true},
                       "duration of the pulse in periods")
        .only("shape = mavroeidis-papageorgiou"),
    config::number_key("phase", Dimension::angle, config::Range::any(), "phase nu of the cosine")
        .only("shape = mavroeidis-papageorgiou"),
    config::number_key("amplitude", Dimension::acceleration, config::Range::positive(), "peak of the pulse"),
    config::number_key("time_step", Dimension::time, {.low = 1e-6, .high = 1},
                       "largest time step; ends and peaks fall on samples")
        .otherwise(0.005),
    config::number_key("quiet_before", Dimension::time, quiet, "time without motion before the pulse").otherwise(0),
    config::number_key("quiet_after", Dimension::time, quiet, "time without motion after the pulse").otherwise(0),
    transverse_key<pulse_component_table>,
    vertical_key<pulse_component_table>};

}  // namespace

constinit config::KeyTable const pulse_table{.meaning = "single pulses, one wave for each period",
                                             .keys = pulse_keys.all,
                                             .also = {&every_wave_table, &grid_table},
                                             .chosen_by = "source",
                                             .word = "pulse"};

std::unique_ptr<WaveSource> make_pulse(config::Table const& waves, InputFiles& /*files*/) {
    PulseInput input;
    auto const make_shape = waves.choice(pulse_keys["shape"], pulse_shapes());
    input.name = waves.text(pulse_keys["shape"]);
    PulseParameters parameters;
    if (input.name == parametric_pulse) {
        parameters = {waves.number(pulse_keys["gamma"]), waves.number(pulse_keys["phase"])};
    }
    input.shape = make_shape(parameters);
    input.amplitude_mps2 = waves.number(pulse_keys["amplitude"]);
    input.periods_s = read_periods(waves, false);
    input.time_step_s = waves.number(pulse_keys["time_step"]);
    input.quiet_before_s = waves.number(pulse_keys["quiet_before"]);
    input.quiet_after_s = waves.number(pulse_keys["quiet_after"]);
    for (auto const& component : further_components) {
        if (waves.has(component.name)) {
            auto const table = waves.child(component.name);
            double const ratio = read_ratio(table);
            input.further.push_back({component, ratio, table.number(pulse_component_keys["lag"])});
            table.finish();
        }
    }
    for (double const period : input.periods_s) {
        constexpr double most = 1e6;
        if ((input.shape.length * period + input.quiet_before_s + input.quiet_after_s) / input.time_step_s > most) {
            waves.fail("time_step", fmt::format("{} s (more than {} samples for a period of {} s). Raise it",
                                                input.time_step_s, most, period));
        }
    }
    return std::make_unique<Pulse>(std::move(input));
}

}  // namespace overturn
