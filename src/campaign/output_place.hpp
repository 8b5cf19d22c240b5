/// Where a run's results and its unfinished blocks lie, and whether this run may have them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "campaign/campaign_input.hpp"
#include "campaign/plan.hpp"
#include "store/shards.hpp"

namespace overturn {

/// What a run finds when it starts.
struct OutputState {
    bool complete = false;                ///< the finished file of this very campaign is there
    std::vector<std::int64_t> committed;  ///< blocks an earlier run left behind
};

/// Looks at the place, refuses what must not be touched, says on stderr what is reused, and begins the shard folder.
/// \throws InputError if something is there and `resume` is off, or it belongs to another campaign
[[nodiscard]] OutputState take_output(std::filesystem::path const& output, store::ShardFolder const& shards,
                                      CampaignInput const& input, Plan const& plan, bool resume);

}  // namespace overturn
