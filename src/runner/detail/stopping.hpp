/// Ending a campaign when it is precise enough: decided on the first waves alone, at fixed numbers of them, so that no
/// schedule, rank count or restart can change where it ends.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Numbers of blocks after which a campaign with a target is looked at, rising, all below its own number: doubling,
/// from 32 waves on. Empty without a target.
[[nodiscard]] std::vector<std::int64_t> stopping_points(CampaignSpec const& spec, Plan const& plan);

/// How the first waves of a campaign stand to its targets.
struct TargetLook {
    bool met = false;
    /// Why no number of waves will meet them as far as can be seen: "type-a cannot meet target_half_width = 0.1 (...)";
    /// empty: nothing speaks against it.
    std::string obstacle;
};

/// Do the first `blocks` blocks meet the target? \pre they are all committed \throws SystemError if one is damaged
[[nodiscard]] TargetLook look_at_target(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
                                        std::int64_t blocks);

/// The plan that counts: cut at the first stopping point that meets the target, or whole. A point whose blocks are not
/// all there decides nothing. \param committed rising
[[nodiscard]] Plan cut_at_target(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
                                 std::vector<std::int64_t> const& committed);

}  // namespace overturn
