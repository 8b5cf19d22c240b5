/// The rare events of a campaign: every limit state of every body at every level, on all ranks.
#pragma once

#include <optional>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/stop.hpp"
#include "parallel/communicator.hpp"
#include "rare/automatic.hpp"
#include "store/shards.hpp"

namespace overturn {

/// A limit state of one body.
struct RareBody {
    std::size_t body = 0, limit = 0;        ///< numbers in the campaign; limit 0: overturning
    std::vector<rare::Estimate> estimates;  ///< one per level
    rare::Record record;
};

/// Nothing if it was time to go before the last stage: with --resume it goes on there. The same on every rank, whatever
/// their number. Collective. \pre the campaign asks for rare events
/// \throws AgreedError on every rank if rank 0 cannot commit
[[nodiscard]] std::optional<std::vector<RareBody>> run_rare(CampaignSpec const& spec, store::ShardFolder const& shards,
                                                            Leave& leave, parallel::Communicator const& comm);

}  // namespace overturn
