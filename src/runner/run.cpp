#include "runner/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>

#include <nlohmann/json.hpp>

#include "campaign/accepted_waves.hpp"
#include "campaign/validated_range.hpp"
#include "campaign/warnings.hpp"
#include "core/elapsed.hpp"
#include "core/print_note.hpp"
#include "output/stripe_text.hpp"
#include "parallel/rows_of_ranks.hpp"
#include "results/hazard_table.hpp"
#include "runner/detail/extension.hpp"
#include "runner/detail/part_plan.hpp"
#include "runner/detail/rare_run.hpp"
#include "runner/detail/stopping.hpp"
#include "runner/detail/watchdog.hpp"
#include "runner/detail/worker.hpp"
#include "runner/merge.hpp"
#include "runner/output_place.hpp"
#include "runner/progress.hpp"
#include "runner/root_broadcast.hpp"
#include "runner/runtime_file.hpp"

namespace overturn {
namespace {

std::vector<std::int64_t> all_of(store::BlockRange const& range) {
    std::vector<std::int64_t> blocks(range.count());
    std::iota(blocks.begin(), blocks.end(), range.first);
    return blocks;
}

// What a stopped run, or a finished part, has to say.
void print_what_is_left(CampaignInput const& input, RunOptions const& options, std::int64_t done, std::int64_t blocks) {
    auto const again =
        resume_command(input, options.output,
                       std::string(options.extend ? "--extend" : "--resume") + (options.shrink ? " --shrink" : "")
                           + (options.merge.layout == store::Layout::packed ? " --packed" : ""));
    if (options.part.is_whole() && options.leaves_blocks && done == blocks) {
        fmt::print("all blocks are done. For the file: overturn merge {}\n", options.output.string());
        return;
    }
    if (options.part.is_whole()) {
        print_note("stopped early: {} of {} blocks are done and safe. Go on with: {}\n", done, blocks, again);
        return;
    }
    if (blocks == 0) {
        fmt::print(
            "part {}/{}: has no block, nothing to do (there are more parts than blocks). When all parts are done: "
            "overturn merge {}\n",
            options.part.number, options.part.of, options.output.string());
        return;
    }
    auto const name = fmt::format("part {}/{}", options.part.number, options.part.of);
    if (done < blocks) {
        print_note("stopped early: {} of {} blocks of {} are done and safe. Go on with: {} --part {}/{}\n", done,
                   blocks, name, again, options.part.number, options.part.of);
        return;
    }
    fmt::print("{}: all {} blocks are done. When all parts are: overturn merge {}\n", name, blocks,
               options.output.string());
}

class Run {
  public:
    Run(CampaignInput const& input, RunOptions const& options, parallel::Communicator const& comm)
        : input_(input),
          options_(options),
          comm_(comm),
          stop_policy_(options.max_walltime_s),
          watchdog_(stop_policy_, comm),
          spec_(parse_campaign(input)),
          plan_(plan_of_part(spec_, options.part)),
          waves_(spec_, plan_),
          shards_(options.output, input.block_key()) {}

    RunEnd run() {
        (void)stated_hazard(input_, spec_.levels);  // what is wrong with it is better known now than at the end
        validate(!spec_.rare || options_.part.is_whole(),
                 "--part {}/{} of a campaign with [rare] (its stages need what all parts found before). Run it whole, "
                 "under mpirun",
                 options_.part.number, options_.part.of);
        validate(!options_.extend || options_.part.is_whole(),
                 "--extend beside --part (one run extends). Leave one out");
        validate(!options_.shrink || options_.extend || options_.resume,
                 "--shrink without --extend or --resume (it gives up rows that are there). Add one of them");
        OutputRequest const request{options_.resume || options_.extend, options_.extend, options_.shrink,
                                    wants_packed() && !spec_.rare, options_.part};
        validate(!options_.leaves_blocks || (!options_.extend && !spec_.rare),
                 "--leave-blocks beside {} (which need the file). Leave one out",
                 options_.extend ? "--extend" : "[rare]");
        auto const found = nlohmann::json::parse(broadcast_from_root(comm_, [&] {
            auto const state = lock_output(options_.output, shards_, input_, plan_, request, lock_);
            KeptPlaces kept;
            if (state.keeps) {
                giving_up_copies([&] { kept = find_known_blocks(options_.output, input_, spec_, plan_, shards_); });
            }
            if (state.keeps) {
                print_what_is_kept(kept.rows);
            }
            return nlohmann::json{{"complete", state.complete},
                                  {"packed", state.packed},
                                  {"begun", state.begun},
                                  {"kept", kept.any() ? kept.text : ""}}
                .dump();
        }));
        if (found.at("complete").get<bool>()) {
            if (comm_.is_root()) {
                fmt::print("{}: complete already, {}\n", options_.output.string(),
                           wants_packed() && !found.at("packed").get<bool>()
                               ? spec_.rare ? "and not packed (with [rare] nothing is taken from a file)"
                                            : "and not packed. To pack it: --extend --packed"
                               : "nothing to do");
            }
            return RunEnd::complete;
        }
        packs_ = wants_packed() || found.at("packed").get<bool>();
        require_shared(shards_, input_.block_key(), comm_);
        spec_.source->prepare(parallel::rows_of_ranks(comm_));
        kept_ = kept_rows(found.at("kept").get<std::string>(), input_, spec_, plan_);
        committed_ = take_blocks(options_.output, shards_, plan_, request, found.at("begun").get<bool>(), comm_);
        if (comm_.is_root()) {
            print_note("waves: {}\n", spec_.source->text());
            for (auto const& remark : spec_.source->about().remarks) {
                print_note("remark: {}\n", remark);
            }
            print_note("variability: {}\n", spec_.source->about().variability);
            print_note("validated range: {}\n", validated_range_text(spec_));
            for (auto const& line : warnings_of(spec_)) {
                print_note("warning: {}\n", line);
            }
            if (auto const blocks = plan_.blocks_of(options_.part).count(); blocks > 0 && blocks < comm_.size()) {
                print_note("warning: {} blocks for {} ranks: {} of them have none\n", blocks, comm_.size(),
                           comm_.size() - blocks);
            }
        }
        seconds_.start = seconds_since(options_.merge.begun);
        take_rows_of(committed_);
        bool whole = options_.part.is_whole() ? draw_all() : complete(all_of(plan_.blocks_of(options_.part)));
        if (whole && spec_.rare) {
            auto const begin = Clock::now();
            rare_ = run_rare(spec_, shards_, stop_policy_, comm_);
            seconds_.rare = seconds_since(begin);
            whole = rare_.has_value();
        }
        auto const end = whole && merges() ? merge() : whole ? RunEnd::complete : RunEnd::stopped;
        if (comm_.is_root() && (end == RunEnd::stopped || !merges())) {
            print_what_is_left(input_, options_, asked_ - unfinished_, asked_);
            if (end == RunEnd::stopped && done_.committed == 0 && std::isfinite(stop_policy_.overdue_in_s())) {
                print_note(
                    "no block was done in this run: a limit must be longer than a block takes (overturn plan)\n");
            }
        }
        account();
        return end;
    }

  private:
    // A target may be met before all that is new is computed.
    void print_what_is_kept(KeptCount const& kept) const {
        auto const asked = plan_.without_refusals();
        print_note("extending {}: {} trials of {} waves are kept, {}{} of {} are new\n", options_.output.string(),
                   kept.trials, kept.waves, spec_.has_target() ? "at most " : "",
                   std::max<std::int64_t>(0, asked.trials() - kept.trials), asked.trials());
    }

    [[nodiscard]] bool merges() const { return options_.part.is_whole() && !options_.leaves_blocks; }

    // Up to each stopping point, where all ranks wait for the answer; a part cannot know it and does all its blocks.
    bool draw_all() {
        asked_ = committed_.size();  // what is drawn leaves out those
        for (auto const count : stopping_points(spec_, plan_)) {
            if (!draw(count)) {
                return false;
            }
            if (meets_target(count)) {
                return true;
            }
        }
        return draw(plan_.count());
    }

    // Computes blocks until so many waves count, or no more may be drawn; false if it was time to go before.
    bool draw(std::int64_t count) {
        for (;;) {
            auto const wanted = wanted_blocks(count);
            if (wanted.empty()) {
                break;
            }
            if (!complete(wanted)) {
                return false;
            }
            take_rows_of(wanted);
        }
        chosen_ = count;
        return true;
    }

    // Rank 0 knows the rows; without a rule nobody needs them.
    std::vector<std::int64_t> wanted_blocks(std::int64_t count) {
        if (!waves_.needs_rows()) {
            return waves_.wanted(count);
        }
        return nlohmann::json::parse(broadcast_from_root(comm_,
                                                         [&] {
                                                             if (auto const why = waves_.hopeless(); !why.empty()) {
                                                                 shards_.remove();
                                                                 throw InputError(input_.name + ": " + why);
                                                             }
                                                             return nlohmann::json(waves_.wanted(count)).dump();
                                                         }))
            .get<std::vector<std::int64_t>>();
    }

    void take_rows_of(std::vector<std::int64_t> const& blocks) {
        if (!waves_.needs_rows()) {
            for (auto const block : blocks) {
                waves_.take(block);
            }
            return;
        }
        (void)broadcast_from_root(comm_, [&] {
            take_rows(waves_, plan_, shards_, blocks);
            return std::string();
        });
    }

    // Computes what is left of the blocks; false if it was time to go before the last.
    bool complete(std::vector<std::int64_t> const& blocks) {
        std::vector<std::int64_t> left;
        std::ranges::copy_if(blocks, std::back_inserter(left),
                             [&](std::int64_t block) { return !std::ranges::binary_search(committed_, block); });
        std::int64_t const all = blocks.size();
        auto const before = all - std::ssize(left);
        Progress progress(all, before, static_cast<double>(plan_.trials()) / static_cast<double>(plan_.blocks()));
        auto const done = work({spec_, plan_, shards_, kept_.get()}, left, stop_policy_, comm_, progress);
        if (comm_.is_root() && done.committed > 0) {
            progress.show(done.committed);
            progress.finish();
        }
        done_.add(done);
        seconds_.work += progress.elapsed_s();
        asked_ += all;
        unfinished_ = std::ssize(left) - done.committed;
        return comm_.largest(comm_.is_root() && unfinished_ > 0 ? 1 : 0) == 0;
    }

    bool meets_target(std::int64_t count) {
        auto const looked = nlohmann::json::parse(broadcast_from_root(comm_, [&] {
            auto const chosen = waves_.chosen(count);
            auto const look = look_at_target(spec_, plan_, chosen, shards_);
            if (look.met && !options_.shrink) {
                giving_up_copies([&] {
                    refuse_lost_waves(waves_held(options_.output, shards_, input_), chosen, options_.output.string());
                });
            }
            return nlohmann::json{{"met", look.met}, {"obstacle", look.obstacle}}.dump();
        }));
        bool const yes = looked.at("met").get<bool>();
        if (auto const obstacle = looked.at("obstacle").get<std::string>(); !obstacle.empty() && !reported_obstacle_) {
            reported_obstacle_ = true;
            if (comm_.is_root()) {
                print_note("warning: after {} waves {}: all {} waves are run unless that changes\n", count, obstacle,
                           plan_.count());
            }
        }
        if (comm_.is_root() && yes) {
            print_note("precise enough after {} of {} waves\n", count, plan_.count());
        }
        return yes;
    }

    // Of a refused extension nothing stays but what was computed for it.
    template <typename Check> void giving_up_copies(Check const& check) const {
        try {
            check();
        } catch (InputError const&) {
            auto const there = shards_.listed({0, plan_.blocks()});
            bool const copies = std::ranges::all_of(
                there, [&](std::int64_t block) { return kept_ != nullptr && kept_->has_all(block); });
            if (copies && std::filesystem::exists(options_.output) && shards_.aside().empty()) {
                shards_.remove();
            }
            throw;
        }
    }

    [[nodiscard]] bool wants_packed() const { return options_.merge.layout == store::Layout::packed; }

    RunEnd merge() {
        auto how = options_.merge;
        how.layout = packs_ ? store::Layout::packed : store::Layout::plain;
        auto const begin = Clock::now();
        bool const whole = merge_blocks(
            {options_.output, input_, spec_, plan_, shards_, comm_},
            [&] {
                earlier_segments_ = shards_.segments();
                return std::optional(waves_.chosen(chosen_));
            },
            [&] { return stop_policy_.may_merge(); },
            [&](std::string const& tables) {
                if (!options_.quiet) {
                    fmt::print("{}results: {}\n", tables, options_.output.string());
                }
            },
            rare_ ? std::span<RareBody const>(*rare_) : std::span<RareBody const>(), how);
        seconds_.merge = seconds_since(begin);
        done_.seconds.store += comm_.is_root() ? seconds_.merge : 0;
        return whole ? RunEnd::complete : RunEnd::stopped;
    }

    void account() {
        auto const ranks = comm_.gather(seconds_text(comm_, done_.seconds));
        if (comm_.is_root()) {
            if (auto const costs = output::model_costs(sum_of_models(ranks)); !costs.empty()) {
                print_note("cost: {}\n", costs);
            }
            seconds_.wall = seconds_since(options_.merge.begun);
            print_segments(
                segment_text(options_.part, ranks, seconds_, done_.committed * plan_.trials() / plan_.blocks()));
        }
    }

    // What is not merged yet goes on with the segments so far; merge reports those of a part.
    void print_segments(std::string const& segment) {
        auto segments = shards_.exists() ? shards_.segments() : earlier_segments_;
        segments.push_back(segment);
        if (shards_.exists()) {
            try {
                shards_.keep_segment(segment);
            } catch (SystemError const& error) {
                print_note("the times of this run are not kept: {}\n", error.what());
            }
        }
        if (merges()) {
            write_runtime(options_.output, segments);
        }
    }

    CampaignInput const& input_;
    RunOptions const& options_;
    parallel::Communicator const& comm_;
    StopPolicy stop_policy_;
    Watchdog watchdog_;
    CampaignSpec spec_;
    Plan plan_;
    AcceptedWaves waves_;  ///< where a rule is asked known on rank 0 alone
    store::ShardFolder shards_;
    std::optional<store::BlockLock> lock_;
    std::unique_ptr<KeptRows> kept_;  ///< of earlier campaigns, where blocks hold some of them
    WorkDone done_;
    std::optional<std::vector<RareBody>> rare_;
    std::vector<std::string> earlier_segments_;  ///< of blocks that are merged; known on rank 0
    RunSeconds seconds_;
    bool packs_ = false;  ///< the results file
    bool reported_obstacle_ = false;
    std::vector<std::int64_t> committed_;      ///< by earlier runs
    std::int64_t asked_ = 0, unfinished_ = 0;  ///< blocks of this run so far, and those of them that are not done
    std::int64_t chosen_ = 0;                  ///< waves that count, of each level where levels have their own
};

}  // namespace

std::filesystem::path default_output(std::filesystem::path const& campaign) { return campaign.stem() += ".h5"; }

CampaignInput load_campaign_everywhere(std::filesystem::path const& path, std::span<std::string const> settings,
                                       parallel::Communicator const& comm) {
    auto input = CampaignInput::deserialise(
        broadcast_from_root(comm, [&] { return load_campaign(path, settings).serialise(); }));
    if (comm.largest(input.program == program_identity() ? 0 : 1) != 0) {
        throw InputError(fmt::format("ranks of different programs (rank 0 is overturn {}). Install one on all nodes",
                                     input.program));
    }
    return input;
}

RunEnd run_campaign(CampaignInput const& input, RunOptions const& options, parallel::Communicator const& comm) {
    return Run(input, options, comm).run();
}

}  // namespace overturn
