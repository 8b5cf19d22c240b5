/// Place of a run's results and of its unfinished blocks, and this run's right to them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/accepted_waves.hpp"
#include "campaign/campaign_input.hpp"
#include "campaign/plan.hpp"
#include "parallel/communicator.hpp"
#include "store/shards.hpp"

namespace overturn {

/// State of the output when a run starts.
struct OutputState {
    bool complete = false;  ///< the finished file of this very campaign is there
    bool begun = false;     ///< there is a record of it that an earlier run left behind
    bool packed = false;    ///< the finished file there is, as what takes its place should be
    bool keeps = false;     ///< rows of an earlier campaign are there: a finished file's, or blocks that were set aside
};

/// Request of a run for the output.
struct OutputRequest {
    bool resume = false;
    bool extend = false;  ///< a finished file that can be extended is no obstacle; with resume
    bool shrink = false;  ///< rows that are there may be left out
    bool pack = false;    ///< a plain file that is complete is written anew; with extend
    Part part;
};

/// Looks at the place, refuses what must not be touched, locks the part's blocks and begins the shard folder. Parts of
/// one campaign share the folder. \param lock holds the blocks from here on \throws InputError if something is there
/// and `resume` is off, or it belongs to another campaign; SystemError if another run is writing there
[[nodiscard]] OutputState lock_output(std::filesystem::path const& output, store::ShardFolder const& shards,
                                      CampaignInput const& input, Plan const& plan, OutputRequest const& request,
                                      std::optional<store::BlockLock>& lock);

/// Every rank writes, so every node has to see the folder. Collective. \throws InputError on every rank if one does not
void require_shared(store::ShardFolder const& shards, std::string const& key, parallel::Communicator const& comm);

/// The part's blocks that an earlier run left behind, in rising order, each read and hashed by one of the ranks; reused
/// and damaged blocks are reported on stderr, and a lack of space. Collective; all ranks see the folder.
/// \throws InputError on every rank if there are some and `resume` is off, CollectiveError if they cannot be listed
[[nodiscard]] std::vector<std::int64_t> take_blocks(std::filesystem::path const& output,
                                                    store::ShardFolder const& shards, Plan const& plan,
                                                    OutputRequest const& request, bool begun,
                                                    parallel::Communicator const& comm);

/// One line on stderr where the disk has less room than what is still to be written: blocks, and the file that they are
/// merged into while they lie there.
void warn_of_little_space(std::filesystem::path const& output, Plan const& plan, Part part,
                          std::vector<std::int64_t> const& committed);

/// The blocks of `range` that are committed and sound, in rising order; what is not is named on stderr.
[[nodiscard]] std::vector<std::int64_t> sound_blocks(store::ShardFolder const& shards, Plan const& plan,
                                                     store::BlockRange range);

/// Takes the acceptance of waves from their blocks. \throws SystemError if one is damaged
void take_rows(AcceptedWaves& waves, Plan const& drawn, store::ShardFolder const& shards,
               std::vector<std::int64_t> const& blocks);

/// The finished file at `output` is that of this campaign: what is left of its shards goes, unless the run that wrote
/// it is still at that. \param locked this process holds the lock of the shards \throws InputError if it is
/// another's, or no results file \return whether an extension of it has been begun
bool check_complete(std::filesystem::path const& output, CampaignInput const& input, bool locked = false);

}  // namespace overturn
