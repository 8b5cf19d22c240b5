/// From a folder of blocks to the one results file.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "core/elapsed.hpp"
#include "output/sections.hpp"
#include "parallel/communicator.hpp"
#include "results/rare_rows.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn {

/// How the results file is laid out, and what of it is printed.
struct MergeOptions {
    store::Layout layout = store::Layout::plain;
    output::TextOptions text{};
    double max_walltime_s = std::numeric_limits<double>::infinity();  ///< of merge_parts; a run has its own
    Clock::time_point begun =
        Clock::now();  ///< when the program began: FILE.runtime.json counts from then, of runs too
};

/// Blocks of a campaign, and who merges them.
struct BlocksToMerge {
    std::filesystem::path const& output;
    CampaignInput const& input;
    CampaignSpec const& spec;
    Plan const& drawn;  ///< that the blocks are of
    store::ShardFolder const& shards;
    parallel::Communicator const& comm;
};

/// Writes the results file and removes the blocks once it is durable. All ranks read, write and hash a part of the
/// rows, and fit a part of the curves. For these each keeps what it writes of the first two million trials. Rank 0 gets
/// them all, and gives every rank those of the bodies whose curves it fits. Where only rank 0 can add up what waves
/// have (Statistics::add_up), or the file is packed, it reads, writes and hashes alone. A rank that stops meanwhile
/// holds up nobody (MergingRanks). Collective. \param chosen on rank 0: which of the waves count \param keep_running
/// asked before every block, on every rank \param show on rank 0, once the file is durable and the blocks are removed:
/// given what is to be printed \param rare one per body, or none \return on all ranks whether the file is there; if
/// not, because `keep_running` or `chosen` said no, all blocks are as they were \throws InputError, CollectiveError on
/// every rank if a block is missing or damaged, or the file cannot be written; the blocks stay
[[nodiscard]] bool merge_blocks(BlocksToMerge const& what, std::function<std::optional<Plan>()> const& chosen,
                                std::function<bool()> const& keep_running,
                                std::function<void(std::string const& tables)> const& show,
                                std::span<RareBody const> rare = {}, MergeOptions const& options = {});

/// End of merging the parts of an array job; of a file that is there, `missing` where its extension is not complete.
enum class MergeEnd { complete, missing };

/// Merges what `overturn run --part` or `--leave-blocks` left beside `output`, however many parts it was. Prints the
/// results. Collective.
/// \throws InputError if nothing was begun there, or a run is writing there now
[[nodiscard]] MergeEnd merge_parts(std::filesystem::path const& output, parallel::Communicator const& comm,
                                   MergeOptions const& options = {});

/// The campaign that the unfinished run for `output` was begun with, by this program.
/// \throws InputError if nothing was begun there, saying so, what it was is not on record, or another program began it
[[nodiscard]] CampaignInput begun_campaign(std::filesystem::path const& output);

/// "overturn run c.toml -o c.h5 --resume --set seed=3", to be pasted into a shell: what computes the rest.
[[nodiscard]] std::string resume_command(CampaignInput const& input, std::filesystem::path const& output,
                                         std::string_view flag = "--resume");

}  // namespace overturn
