#include "generators/spectrum_compatible.hpp"

#include <algorithm>
#include <array>

#include "generators/detail/compatible_source.hpp"
#include "generators/detail/components.hpp"
#include "generators/records.hpp"
#include "spectra/target_input.hpp"

namespace overturn {
namespace {

constexpr std::array matches{
    config::Entry<Match>{"each", "every wave is iterated to the target", Match::each},
    config::Entry<Match>{"ensemble", "the median of many waves meets the target", Match::ensemble},
    config::Entry<Match>{"none", "waves are left as they are drawn", Match::none},
};
constexpr std::array line_amplitudes{
    config::Entry<LineAmplitudes>{"fixed", "random phases only", LineAmplitudes::fixed},
    config::Entry<LineAmplitudes>{"gaussian", "random phases and amplitudes", LineAmplitudes::gaussian},
};

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

// A further component with a target of its own, or a ratio of the horizontal one; nothing if there is no such one.
std::optional<FurtherTarget> read_further(config::Table const& waves, ComponentKind const& kind,
                                          TargetSpectrum const& horizontal, InputFiles& files) {
    if (!waves.has(kind.name)) {
        return std::nullopt;
    }
    auto const table = waves.child(kind.name);
    std::optional<TargetSpectrum> target;
    if (table.has("target")) {
        auto const own = table.child("target");
        target = read_target(own, files);
        own.finish();
    } else {
        target = horizontal.scaled(read_ratio(table));
    }
    auto const correlation = read_correlation(table);
    if (correlation && waves.has("seed")) {
        table.fail("correlation", "beside seed (records have one of their own). Leave it out");
    }
    table.finish();
    return FurtherTarget{kind, *target, correlation};
}

// Reads the measured motions whose phases are to be kept; the first one's time step is everybody's.
void read_seeds(config::Table const& waves, InputFiles& files, CompatibleRequest& request) {
    auto const table = waves.child("seed");
    auto const records = make_records(table, files);
    table.finish();
    std::size_t longest = 0;
    for (std::uint64_t i = 0; i < records->available().value_or(0); ++i) {
        auto made = records->make(0, i);
        if (made.motion.time_step_s != request.input.time_step_s && (i > 0 || waves.has("time_step"))) {
            waves.fail("seed",
                       fmt::format("time step {} s of {} beside {} s (seeds have one step). State waves.seed.time_step",
                                   made.motion.time_step_s, made.label, request.input.time_step_s));
        }
        request.input.time_step_s = made.motion.time_step_s;
        longest = std::max(longest, made.motion.samples());
        request.seeds.push_back(std::move(made.motion));
        request.seed_labels.push_back(std::move(made.label));
    }
    request.input.samples =
        waves.has("duration") ? read_samples(waves, request.input.time_step_s) : std::max<std::size_t>(longest, 101);
    request.input.envelope = {.shape = EnvelopeShape::constant};
}

void read_match(config::Table const& waves, CompatibleRequest& request) {
    auto& input = request.input;
    request.match = waves.choice<Match>("match", matches, Match::each);
    request.rule_name = waves.text("acceptance", "none");
    input.rule = waves.choice<AcceptanceRule>("acceptance", acceptance_rules(), {});
    if (request.match == Match::each) {
        input.tolerance = waves.number("match_tolerance", Dimension::none, {.low = 0.001, .high = 1}, input.tolerance);
        input.iterations = static_cast<int>(waves.integer("match_iterations", 1, 1000, input.iterations));
    } else {
        input.iterations = 0;
        input.calibrated = request.match == Match::ensemble;
        if (input.rule.asks()) {
            waves.fail("acceptance", "judges single waves (which scatter unless match = 'each'). Use none here");
        }
        if (waves.has("seed")) {
            waves.fail("match", "beside seed (a record is matched as it is). Use each");
        }
    }
    if (input.rule.asks()) {
        expect_judgeable(waves, "acceptance", input.target);
    }
}

void read_varying_targets(config::Table const& waves, InputFiles& files, CompatibleRequest& request) {
    if (!waves.has("variability")) {
        return;
    }
    if (request.match != Match::each) {
        waves.fail("variability",
                   "beside a match other than 'each' (each wave is brought to a target of its own, or "
                   "noise would add to what is stated). Use match = 'each'");
    }
    if (request.input.rule.asks()) {
        waves.fail("variability",
                   "beside acceptance (its rule compares every wave with the one target). Leave one out");
    }
    request.variability = read_variability(waves.child("variability"), request.input.target, files);
}

}  // namespace

std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files) {
    auto const target_table = waves.child("target");
    CompatibleRequest request{.input = {.target = read_target(target_table, files)}};
    auto& input = request.input;
    input.time_step_s = waves.number("time_step", Dimension::time, {.low = 1e-4, .high = 0.1}, 0.01);
    if (waves.has("seed")) {
        read_seeds(waves, files, request);
    } else {
        input.samples = read_samples(waves, input.time_step_s);
    }
    double const duration = input.time_step_s * static_cast<double>(input.samples - 1);
    input.longest_s = read_longest(target_table, input.target, duration);
    target_table.finish();
    read_match(waves, request);
    read_varying_targets(waves, files, request);
    if (request.seeds.empty()) {
        input.envelope = read_envelope(waves.child_or_empty("envelope"), duration);
        input.amplitudes = waves.choice<LineAmplitudes>(
            "amplitudes", line_amplitudes, input.calibrated ? LineAmplitudes::gaussian : LineAmplitudes::fixed);
    }
    std::vector<FurtherTarget> further;
    for (auto const& kind : further_kinds) {
        if (auto const found = read_further(waves, kind, input.target, files)) {
            if (input.rule.asks()) {
                expect_judgeable(waves, kind.name, found->target);
            }
            further.push_back(*found);
        }
        bool const measured = std::all_of(request.seeds.begin(), request.seeds.end(),
                                          [&](GroundMotion const& seed) { return !(seed.*(kind.place)).empty(); });
        if (waves.has(kind.name) && !measured) {
            waves.fail(kind.name, "no such component in every seed (its phases are missing). State the files' own");
        }
    }
    return waves.located("target", [&] { return std::make_unique<SpectrumCompatible>(std::move(request), further); });
}

}  // namespace overturn
