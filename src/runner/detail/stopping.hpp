/// Ending a campaign when it is precise enough: decided on the first waves alone, at fixed numbers of them, so that no
/// schedule, rank count or restart can change where it ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/accepted_waves.hpp"
#include "campaign/plan.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Numbers of waves after which a campaign with a target is looked at, rising, all below its own: doubling, from 32 on,
/// whole blocks. Empty without a target.
[[nodiscard]] std::vector<std::int64_t> stopping_points(CampaignSpec const& spec, Plan const& plan);

/// The first waves of a campaign against its targets.
struct TargetLook {
    bool met = false;
    /// Why no number of waves will meet them as far as can be seen: "type-a cannot meet target_half_width = 0.1 (...)";
    /// empty: nothing speaks against it.
    std::string obstacle;
};

/// Do these waves meet the target? \param drawn the plan of the blocks, which are all committed
/// \throws SystemError if one is damaged
[[nodiscard]] TargetLook look_at_target(CampaignSpec const& spec, Plan const& drawn, Plan const& chosen,
                                        store::ShardFolder const& shards);

/// The waves that count, of what is committed: those up to the first stopping point that meets the target, or all that
/// the campaign requests; empty where `waves` needs more for that.
[[nodiscard]] std::optional<Plan> chosen_of(CampaignSpec const& spec, Plan const& drawn, AcceptedWaves const& waves,
                                            store::ShardFolder const& shards);

}  // namespace overturn
