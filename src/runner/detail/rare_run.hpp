/// The rare events of a campaign: every limit state of every body at every level, on all ranks.
#pragma once

#include <optional>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "parallel/communicator.hpp"
#include "results/rare_rows.hpp"
#include "runner/stop_policy.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Nothing if it was time to go before the last stage: with --resume it goes on there. The same on every rank, whatever
/// their number. Collective. \pre the campaign has rare events
/// \throws CollectiveError on every rank if rank 0 cannot commit
[[nodiscard]] std::optional<std::vector<RareBody>> run_rare(CampaignSpec const& spec, store::ShardFolder const& shards,
                                                            StopPolicy& stop_policy,
                                                            parallel::Communicator const& comm);

}  // namespace overturn
