#include "generators/spectrum_compatible.hpp"

#include <algorithm>
#include <array>

#include "generators/detail/aftershock.hpp"
#include "generators/detail/compatible_source.hpp"
#include "generators/detail/components.hpp"
#include "generators/detail/records.hpp"
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
constexpr std::array refused_seeds{
    config::Entry<bool>{"left-out", "reported, and not used as trials", false},
    config::Entry<bool>{"used", "reported, and used as trials", true},
};

constexpr config::Keys matched_target_keys{
    config::number_key("longest", Dimension::time, {.low = 0.2, .high = 20},
                       "longest period that is matched; waves have almost no energy beyond 1.5 times this period (with "
                       "seeds 3 times, if the duration allows)")
        .otherwise_in_words("smallest of 10 s, the target's last period and the duration")};
constexpr config::KeyTable matched_target_table{
    .meaning = "the response spectrum that waves follow", .keys = matched_target_keys.all, .also = {&target_table}};
constexpr config::Keys matched_component_keys{
    config::number_key("ratio", ratio_key.dimension, ratio_key.range, "ratio of this target to the horizontal target")
        .only("target is not stated"),
    config::table_key<target_table>("target", "separate target of this component").optional(), correlation_key};
constexpr config::KeyTable matched_component_table{.meaning = "further component that follows a target",
                                                   .keys = matched_component_keys.all};
constexpr config::Keys compatible_keys{
    config::table_key<matched_target_table>("target", "the response spectrum that waves follow"),
    config::number_key("duration", Dimension::time, config::Range::positive(), "length of every wave")
        .otherwise_in_words("that of the longest seed; required without a seed"),
    config::number_key("time_step", Dimension::time, {.low = 1e-4, .high = 0.1}, "time step, without a seed")
        .otherwise(0.01),
    config::word_key<matches>("match", "method of matching waves to the target").otherwise("each"),
    config::number_key("match_tolerance", Dimension::none, {.low = 0.001, .high = 1},
                       "mean misfit to the target at which matching stops")
        .otherwise(0.05)
        .only("match = each"),
    config::integer_key("match_iterations", 1, 1000, "largest number of iterations of matching")
        .otherwise(40)
        .only("match = each"),
    config::word_key<acceptance_rules>(
        "acceptance", "rule that every wave must meet; srp-3.7.1: the spectrum clauses of its option 1, approach 2")
        .otherwise("none"),
    config::integer_key("most_drawn", 1, 1000, "largest number of drawn waves per accepted wave")
        .otherwise(10)
        .only("there is acceptance and no seed"),
    config::word_key<refused_seeds>("refused", "use of seeds whose matched wave misses acceptance")
        .otherwise("left-out")
        .only("there are acceptance and seed"),
    config::word_key<line_amplitudes>("amplitudes", "Fourier amplitudes: fixed or Gaussian")
        .otherwise_in_words("fixed; of match = ensemble gaussian")
        .only("there is no seed"),
    config::table_key<envelope_table>("envelope", "envelope of the amplitude over time")
        .optional()
        .only("there is no seed"),
    config::table_key<record_files_table>("seed", "recorded motions whose phases are kept in matching").optional(),
    config::table_key<variability_table>("variability", "variability of the target from wave to wave").optional(),
    transverse_key<matched_component_table>,
    vertical_key<matched_component_table>};

double read_longest(config::Table const& table, TargetSpectrum const& target, double duration_s) {
    constexpr double usual = 10;
    double const longest = table.number(matched_target_keys["longest"],
                                        {.otherwise = std::min({usual, target.last_period_s(), duration_s})});
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
        auto const own = table.child(matched_component_keys["target"]);
        auto const beside = waves.child(compatible_keys["target"]);
        target = read_target(own, files, files.are_before_format_5() ? nullptr : &beside);
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
    auto const table = waves.child(compatible_keys["seed"]);
    auto const records = make_records(table, files);
    table.finish();
    request.seeds_shared = records->about().shared;
    std::size_t longest = 0;
    for (std::uint64_t i = 0; i < records->about().available.value_or(0); ++i) {
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

void read_acceptance(config::Table const& waves, CompatibleRequest& request) {
    auto& acceptance = request.acceptance;
    acceptance.rule = waves.text(compatible_keys["acceptance"]);
    bool const seeds = waves.has("seed");
    if (waves.has("most_drawn") && (!acceptance.asked() || seeds)) {
        waves.fail("most_drawn", "without waves to be drawn until acceptance is met. Leave it out");
    }
    if (waves.has("refused") && !(acceptance.asked() && seeds)) {
        waves.fail("refused", "without seeds and acceptance (drawn waves that miss it are drawn anew). Leave it out");
    }
    acceptance.most_drawn = seeds ? 1 : waves.integer(compatible_keys["most_drawn"]);
    acceptance.uses_refused = seeds && waves.choice<bool>(compatible_keys["refused"], refused_seeds);
}

void read_match(config::Table const& waves, CompatibleRequest& request) {
    auto& input = request.input;
    request.match = waves.choice<Match>(compatible_keys["match"], matches);
    read_acceptance(waves, request);
    input.rule = waves.choice(compatible_keys["acceptance"], acceptance_rules());
    if (request.match == Match::each) {
        input.tolerance = waves.number(compatible_keys["match_tolerance"]);
        input.iterations = static_cast<int>(waves.integer(compatible_keys["match_iterations"]));
    } else {
        input.iterations = 0;
        input.calibrated = request.match == Match::ensemble;
        if (input.rule.enabled()) {
            waves.fail("acceptance", "judges single waves (which scatter unless match = 'each'). Use none here");
        }
        if (waves.has("seed")) {
            waves.fail("match", "beside seed (a record is matched as it is). Use each");
        }
    }
    if (input.rule.enabled()) {
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
    if (request.input.rule.enabled()) {
        waves.fail("variability",
                   "beside acceptance (its rule compares every wave with the one target). Leave one out");
    }
    request.variability = read_variability(waves.child(compatible_keys["variability"]), request.input.target, files);
}

}  // namespace

constinit config::KeyTable const spectrum_compatible_table{
    .meaning = "random waves whose response spectrum follows a target",
    .keys = compatible_keys.all,
    .also = {&every_wave_table, &aftershock_table},
    .chosen_by = "source",
    .word = "spectrum-compatible"};

std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files) {
    auto const target = waves.child(compatible_keys["target"]);
    CompatibleRequest request{.input = {.target = read_target(target, files)}};
    auto& input = request.input;
    input.time_step_s = waves.number(compatible_keys["time_step"]);
    if (waves.has("seed")) {
        read_seeds(waves, files, request);
    } else {
        input.samples = read_samples(waves, input.time_step_s);
    }
    double const duration = input.time_step_s * static_cast<double>(input.samples - 1);
    input.longest_s = read_longest(target, input.target, duration);
    target.finish();
    // A measured motion's own slow lines are kept as far as they can come to rest within it.
    constexpr double beyond = 2;
    input.kept_to_s = request.seeds.empty() ? 0 : std::min(beyond * input.longest_s, duration / beyond);
    read_match(waves, request);
    read_varying_targets(waves, files, request);
    if (request.seeds.empty()) {
        input.envelope = read_envelope(waves.child_or_empty(compatible_keys["envelope"]), duration);
        input.amplitudes = waves.choice<LineAmplitudes>(
            "amplitudes", line_amplitudes, input.calibrated ? LineAmplitudes::gaussian : LineAmplitudes::fixed);
    }
    std::vector<FurtherTarget> further;
    for (auto const& kind : further_kinds) {
        if (auto const found = read_further(waves, kind, input.target, files)) {
            if (input.rule.enabled()) {
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
