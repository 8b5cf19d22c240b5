/// One rank's share of a campaign: blocks from a counter that all ranks share, each committed by the rank that
/// computed it.
///
/// Why every rank writes, and how long a block should be (measured on one node, ext4 on a virtual disk; modelled
/// beyond). A commit takes 0.8 ms (temporary file, two syncs, a rename), a take from the counter 1 us within a node and
/// some 5 us over a fast network; a block is 1 to 64 waves of 10 to 100 ms each, so 0.02 s to 6 s, and about 2 kB to
/// 400 kB. If rank 0 wrote for all, it would be busy all the time from 10^3 ranks on (10^3 blocks a second); writing
/// their own, 10^3 ranks with blocks of 1 s make 10^3 files and some 50 MB a second, which any shared file system
/// takes; 10^5 ranks with the blocks of a campaign that is worth them (10^9 waves in 2^20 blocks, 20 s each) make
/// 5 10^3 files and 250 MB a second, within a metadata server's means. The counter is asked twice a block: 10^4 times a
/// second at 10^5 ranks, 5 % of what one network port serves; rank 0 looks up between waves and, on big jobs, does
/// nothing else. The merge reads and writes every row once, on rank 0: 0.3 GB/s to 0.5 GB/s, so 1 s for 10^6 trials and
/// 15 min for 10^9, in the memory of one block.
#pragma once

#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/progress.hpp"
#include "campaign/stop.hpp"
#include "campaign/trial.hpp"
#include "parallel/communicator.hpp"
#include "store/shards.hpp"

namespace overturn {

struct WorkDone {
    std::int64_t committed = 0;  ///< blocks, by all ranks; known on rank 0
    PhaseSeconds seconds;        ///< this rank's

    void add(WorkDone const& more);
};

/// Computes and commits the blocks `left` until none is left or it is time to go. Collective.
/// \throws AgreedError on every rank if one cannot commit; the others commit what they have in hand first
[[nodiscard]] WorkDone work(CampaignSpec const& spec, Plan const& plan, std::vector<std::int64_t> const& left,
                            store::ShardFolder const& shards, Leave& leave, parallel::Communicator const& comm,
                            Progress& progress);

}  // namespace overturn
