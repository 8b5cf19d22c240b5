#include "runner/merge.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/print_note.hpp"
#include "output/write_results.hpp"
#include "results/analysis.hpp"
#include "results/few_waves.hpp"
#include "results/hazard_frequency.hpp"
#include "results/hazard_table.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/statistics.hpp"
#include "results/telling_trials.hpp"
#include "runner/detail/stopping.hpp"
#include "runner/output_place.hpp"
#include "runner/runtime_file.hpp"
#include "store/durable.hpp"
#include "store/results_file.hpp"

namespace overturn {
namespace {

struct Interrupted {};

// As a shell takes it for one word.
std::string shell_word(std::string const& text) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./=:+,-";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string word = "'";
    for (char const c : text) {
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return word + "'";
}

void require_begun(store::ShardFolder const& shards, std::filesystem::path const& output) {
    if (!shards.begun_with().empty()) {
        return;
    }
    validate(
        !shards.holds_blocks(),
        "{}: blocks without the record of their campaign (removed by hand?). Go on with: overturn run CAMPAIGN -o {} "
        "--resume",
        shards.folder().string(), output.string());
    throw InputError(
        fmt::format("{}: no such results, finished or not (nothing was begun there). Check the name", output.string()));
}

void require_same_program(CampaignInput const& begun, std::filesystem::path const& output) {
    validate(begun.program == program_identity(),
             "{}: begun by overturn {}, this is {} (their blocks must not be mixed). Finish it with that program, or "
             "start anew with another -o",
             output.string(), begun.program, program_identity());
    validate(
        begun.machine == machine(),
        "{}: begun on {}, this is {} (their last bits differ, blocks must not be mixed). Finish it on {}, or start "
        "anew with another -o",
        output.string(), begun.machine, machine(), begun.machine);
    CampaignInput const here;
    validate(
        begun.libraries == here.libraries,
        "{}: begun with {}, this has {} (their last bits may differ, blocks must not be mixed). Finish it with those, "
        "or start anew with another -o",
        output.string(), begun.libraries, here.libraries);
}

// What the parts of a campaign left.
struct PartsMerge {
    std::filesystem::path const& output;
    CampaignInput const& input;
    CampaignSpec const& spec;
    Plan const& whole;
    store::ShardFolder const& shards;
    MergeOptions const& options;

    // Makes the file of these blocks, or names what is missing.
    [[nodiscard]] MergeEnd with(std::vector<std::int64_t> const& blocks) const {
        AcceptedWaves waves(spec, whole);
        take_rows(waves, whole, shards, blocks);
        validate(waves.hopeless().empty(), "{}: {}", input.name, waves.hopeless());
        auto const chosen = chosen_of(spec, whole, waves, shards);
        if (!chosen) {
            auto const missing = waves.wanted(whole.count());
            print_note("{}: waves {} are missing ({} of {} blocks). Run their parts again with --resume, or: {}\n",
                       shards.folder().string(), whole.waves_text(missing), missing.size(), whole.blocks(),
                       resume_command(input, output));
            return MergeEnd::missing;
        }
        if (spec.rare) {
            print_note("{}: the rare events are missing (all ranks work at them, stage by stage). Go on with: {}\n",
                       shards.folder().string(), resume_command(input, output));
            return MergeEnd::missing;
        }
        auto const segments = shards.segments();
        auto const tables = merge_blocks(
            output, input, spec, whole, *chosen, shards, [] { return true; }, {}, options);
        write_runtime(output, segments);
        fmt::print("{}results: {}\n", *tables, output.string());
        return MergeEnd::complete;
    }
};

}  // namespace

std::optional<std::string> merge_blocks(std::filesystem::path const& output, CampaignInput const& input,
                                        CampaignSpec const& spec, Plan const& drawn, Plan const& chosen,
                                        store::ShardFolder const& shards, std::function<bool()> const& keep_running,
                                        std::span<RareBody const> rare, MergeOptions const& options) {
    Statistics statistics(spec);
    auto const block = [&](std::int64_t number) {
        if (!keep_running()) {
            throw Interrupted();
        }
        return shards.read(number);
    };
    std::vector<BodyAnalysis> analysis;
    try {
        analysis = write_results(output, input, spec, drawn, chosen, block, statistics, rare, options.layout);
    } catch (Interrupted const&) {
        return std::nullopt;
    }
    shards.remove();
    auto const& text = options.text;
    tell_velocities(analysis, text.velocities ? text.velocities : typed_unit(spec, Dimension::velocity));
    store::ResultsReader const file(output, store::Trust::unverified);
    auto const telling = text.wants("trials") ? telling_trials(spec, file) : std::vector<TellingTrial>{};
    auto const few = trials_of_few_waves(spec, file);
    auto const hazard = stated_hazard(input, spec.levels);
    auto const frequencies =
        hazard ? frequencies_of(spec, statistics, analysis, *hazard, spec.confidence) : std::vector<BodyFrequency>{};
    output::Answered const answered{.spec = spec,
                                    .statistics = statistics,
                                    .analysis = analysis,
                                    .confidence = spec.confidence,
                                    .frequencies = frequencies};
    return output::results_text({.answered = answered,
                                 .few = few,
                                 .rare = rare,
                                 .telling = telling,
                                 .hazard = hazard ? &*hazard : nullptr,
                                 .file = output.string()},
                                text);
}

std::string resume_command(CampaignInput const& input, std::filesystem::path const& output, std::string_view flag) {
    std::string settings;
    for (auto const& setting : input.settings) {
        settings += " --set " + shell_word(setting);
    }
    return fmt::format("overturn run {} -o {} {}{}", shell_word(input.name), shell_word(output.string()), flag,
                       settings);
}

CampaignInput begun_campaign(std::filesystem::path const& output) {
    store::ShardFolder const shards(output, "");
    require_begun(shards, output);
    auto input = CampaignInput::deserialise(shards.begun_with());
    require_same_program(input, output);
    return input;
}

MergeEnd merge_parts(std::filesystem::path const& output, MergeOptions const& options) {
    if (std::filesystem::exists(output)) {
        store::ResultsReader const file(output);
        check_complete(output, input_of(file));
        fmt::print("{}: complete already, nothing to do\n", output.string());
        return MergeEnd::complete;
    }
    store::ShardFolder const unnamed(output, "");
    require_begun(unnamed, output);
    store::require_writable(output);
    store::Claim const claim(unnamed.folder(), {0, std::numeric_limits<std::int64_t>::max()});
    auto const input = CampaignInput::deserialise(unnamed.begun_with());
    auto const spec = parse_campaign(input);
    Plan const whole(spec);
    require_same_program(input, output);
    store::ShardFolder const shards(output, input.block_key());
    PartsMerge const merge{output, input, spec, whole, shards, options};
    // Merging checks every block that it reads: only where one is not sound are all of them read to name the others.
    auto const by_name = shards.listed({0, whole.blocks()});
    if (std::ssize(by_name) == whole.blocks() && !AcceptedWaves(spec, whole).needs_rows()) {
        try {
            return merge.with(by_name);
        } catch (SystemError const&) {
            if (std::filesystem::exists(output)) {
                throw;
            }
            auto const sound = sound_blocks(shards, whole, {0, whole.blocks()});
            if (sound.size() == by_name.size()) {
                throw;
            }
            return merge.with(sound);
        }
    }
    return merge.with(sound_blocks(shards, whole, {0, whole.blocks()}));
}

}  // namespace overturn
