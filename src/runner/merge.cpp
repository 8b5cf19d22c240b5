#include "runner/merge.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/print_note.hpp"
#include "output/write_results.hpp"
#include "parallel/rows_of_ranks.hpp"
#include "results/analysis.hpp"
#include "results/few_waves.hpp"
#include "results/hazard_frequency.hpp"
#include "results/hazard_table.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/statistics.hpp"
#include "results/telling_trials.hpp"
#include "runner/detail/extension.hpp"
#include "runner/detail/merging_ranks.hpp"
#include "runner/detail/stopping.hpp"
#include "runner/detail/watchdog.hpp"
#include "runner/output_place.hpp"
#include "runner/root_broadcast.hpp"
#include "runner/runtime_file.hpp"
#include "runner/stop_policy.hpp"
#include "store/durable.hpp"
#include "store/results_file.hpp"

namespace overturn {
namespace {

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

// Note on what is missing of what the parts were to do; empty where nothing is.
std::string missing_text(BlocksToMerge const& parts, AcceptedWaves const& waves, bool chosen) {
    auto const& shards = parts.shards;
    if (!chosen) {
        auto const missing = waves.wanted(parts.drawn.count());
        return fmt::format("{}: waves {} are missing ({} of {} blocks). Run their parts again with --resume, or: {}\n",
                           shards.folder().string(), parts.drawn.waves_text(missing), missing.size(),
                           parts.drawn.blocks(), resume_command(parts.input, parts.output));
    }
    return parts.spec.rare ? fmt::format(
               "{}: the rare events are missing (all ranks work at them, stage by stage). Go on with: {}\n",
               shards.folder().string(), resume_command(parts.input, parts.output))
                           : std::string();
}

// Of these blocks; nothing where some are missing, which a note names.
std::optional<Plan> chosen_of_parts(BlocksToMerge const& parts, std::vector<std::int64_t> const& blocks) {
    AcceptedWaves waves(parts.spec, parts.drawn);
    take_rows(waves, parts.drawn, parts.shards, blocks);
    validate(waves.hopeless().empty(), "{}: {}", parts.input.name, waves.hopeless());
    auto chosen = chosen_of(parts.spec, parts.drawn, waves, parts.shards);
    if (auto const missing = missing_text(parts, waves, chosen.has_value()); !missing.empty()) {
        print_note("{}", missing);
        return std::nullopt;
    }
    if (parts.spec.has_target()) {
        refuse_lost_waves(waves_held(parts.output, parts.shards, parts.input), *chosen, parts.output.string());
    }
    return chosen;
}

std::string tables_of(BlocksToMerge const& what, Statistics const& statistics, std::vector<BodyAnalysis> analysis,
                      std::span<RareBody const> rare, output::TextOptions const& text) {
    auto const& spec = what.spec;
    tell_velocities(analysis, text.velocities ? text.velocities : typed_unit(spec, Dimension::velocity));
    store::ResultsReader const file(what.output, store::Trust::unverified);
    auto const telling = text.wants("trials") ? telling_trials(spec, file) : std::vector<TellingTrial>{};
    auto const few = trials_of_few_waves(spec, file);
    auto const hazard = stated_hazard(what.input, spec.levels);
    auto const frequencies =
        hazard ? frequencies_of(spec, statistics, analysis, *hazard, spec.confidence) : std::vector<BodyFrequency>{};
    return output::results_text({.answered = {.spec = spec,
                                              .statistics = statistics,
                                              .analysis = analysis,
                                              .confidence = spec.confidence,
                                              .frequencies = frequencies,
                                              .rare = rare},
                                 .few = few,
                                 .telling = telling,
                                 .hazard = hazard ? &*hazard : nullptr,
                                 .file = what.output.string()},
                                text);
}

}  // namespace

bool merge_blocks(BlocksToMerge const& what, std::function<std::optional<Plan>()> const& chosen,
                  std::function<bool()> const& keep_running, std::function<void(std::string const&)> const& show,
                  std::span<RareBody const> rare, MergeOptions const& options) {
    MergingRanks ranks(what.comm, what.spec, what.drawn, what.shards, keep_running);
    bool is_whole = false;
    auto const lead = [&] {
        auto const plan = chosen();
        if (!plan) {
            return;
        }
        Statistics statistics(what.spec);
        auto analysis = write_results(
            what.output, what.input, what.spec, what.drawn, *plan,
            [&](std::int64_t block) { return ranks.read(block); }, statistics, rare, options.layout,
            ranks.help(options.layout));
        ranks.remove_blocks();
        is_whole = true;
        show(tables_of(what, statistics, std::move(analysis), rare, options.text));
    };
    if (!what.comm.is_root()) {
        ranks.run({});
    }
    return broadcast_from_root(what.comm,
                               [&] {
                                   try {
                                       ranks.run(lead);
                                   } catch (Interrupted const&) {
                                       return std::string();
                                   }
                                   return std::string(is_whole ? "whole" : "");
                               })
           == "whole";
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

MergeEnd merge_parts(std::filesystem::path const& output, parallel::Communicator const& comm,
                     MergeOptions const& options) {
    constexpr std::string_view extension_begun = "extension";
    StopPolicy const stop_policy(options.max_walltime_s);
    Watchdog const watchdog(stop_policy, comm);
    std::optional<store::BlockLock> lock;
    auto const begun = broadcast_from_root(comm, [&] {
        if (std::filesystem::exists(output)) {
            store::ResultsReader const file(output);
            bool const extended = check_complete(output, input_of(file));
            fmt::print("{}: complete already; nothing to merge{}\n", output.string(), extended ? " yet" : "");
            return std::string(extended ? extension_begun : "");
        }
        store::ShardFolder const unnamed(output, "");
        require_begun(unnamed, output);
        store::require_writable(output);
        lock.emplace(unnamed.folder(), store::BlockRange{0, std::numeric_limits<std::int64_t>::max()});
        auto const input = CampaignInput::deserialise(unnamed.begun_with());
        require_same_program(input, output);
        return input.serialise();
    });
    if (begun.empty() || begun == extension_begun) {
        return begun.empty() ? MergeEnd::complete : MergeEnd::missing;
    }
    auto const input = CampaignInput::deserialise(begun);
    auto const spec = parse_campaign(input);
    Plan const whole(spec);
    store::ShardFolder const shards(output, input.block_key());
    require_shared(shards, input.block_key(), comm);
    spec.source->prepare(parallel::rows_of_ranks(comm));  // the file tells how waves were calibrated
    BlocksToMerge const parts{output, input, spec, whole, shards, comm};
    auto const merged = [&](std::function<std::vector<std::int64_t>()> const& blocks) {
        std::vector<std::string> segments;
        bool const is_there = merge_blocks(
            parts,
            [&] {
                segments = shards.segments();
                return chosen_of_parts(parts, blocks());
            },
            [&] { return stop_policy.may_merge(); },
            [&](std::string const& tables) {
                write_runtime(output, segments, seconds_since(options.begun));
                fmt::print("{}results: {}\n", tables, output.string());
            },
            {}, options);
        return is_there ? MergeEnd::complete : MergeEnd::missing;
    };
    // Read once, on rank 0: a note names each that is not sound.
    std::optional<std::vector<std::int64_t>> found_sound;
    auto const sound = [&] {
        if (!found_sound) {
            found_sound = sound_blocks(shards, whole, {0, whole.blocks()});
        }
        return *found_sound;
    };
    // Merging checks every block that it reads: only where one is not sound are all of them read to name the others.
    std::vector<std::int64_t> by_name;
    auto const all = broadcast_from_root(comm, [&] {
        by_name = shards.listed({0, whole.blocks()});
        bool const complete = std::ssize(by_name) == whole.blocks() && !AcceptedWaves(spec, whole).needs_rows();
        return std::string(complete ? "all" : "");
    });
    if (all.empty()) {
        return merged(sound);
    }
    try {
        return merged([&] { return by_name; });
    } catch (CollectiveError const&) {
        auto const there = broadcast_from_root(comm, [&] {
            return std::string(std::filesystem::exists(output) || sound().size() == by_name.size() ? "all" : "");
        });
        if (!there.empty()) {
            throw;
        }
        return merged(sound);
    }
}

}  // namespace overturn
