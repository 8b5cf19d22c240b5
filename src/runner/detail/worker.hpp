/// One rank's share of a campaign: blocks from a counter that all ranks share, each committed by the rank that
/// computed it.
///
/// Why every rank writes, and how long a block should be. Measured on one node (ext4 on a virtual disk, two busy
/// cores): a commit takes 1 ms (temporary file, two syncs, a rename), an operation on a shared counter 1 us to 2 us,
/// the merge reads and writes 0.3 GB to 0.5 GB a second on rank 0, in the memory of one block besides what the
/// statistics keep. A wave takes 10 ms to 100 ms, a row of a trial 0.3 kB; a block is 1 to 64 waves, so 0.02 s to 6 s,
/// 1 kB to 400 kB; where trials run on points it is as many waves as take 5 s. Where nothing is measured a wave takes
/// 0.2 ms, and a block is 128 of them. Blocks of few trials are computed together, a tenth of a second's or so, so that
/// the trials which go to one model fill the vector lanes, and those of a twentieth of a second are committed together,
/// which takes the disk little longer than one.
///
/// | ranks | blocks of | commits a second | to the file system | counter, operations a second |
/// |-------|-----------|------------------|--------------------|------------------------------|
/// | 10^3  | 1 s       | 10^3             | 50 MB/s            | 10^3                         |
/// | 10^4  | 5 s       | 2 10^3           | 100 MB/s           | 10^4                         |
/// | 10^5  | 20 s      | 5 10^3           | 250 MB/s           | 10^5                         |
///
/// Rank 0 writing for all would be busy all the time from 10^3 ranks on. Every rank writing its own, a metadata server
/// (some 10^4 files a second) is the limit, which 10^5 ranks stay below with the blocks of a campaign that is worth
/// them (10^9 waves in 2^20 blocks, 950 waves each). A rank reports once a second and takes a quarter of its part of
/// what is left at once, so the counter sees at most some operations per rank and second: 10^5 a second would keep rank
/// 0 busy for a fifth of its time, and on more than 64 ranks it does nothing else. Without one-sided hardware an
/// operation waits until rank 0 looks up, between waves. Merging reads and writes 10^6 trials in 2 s to 2.5 s of CPU
/// time, which all ranks share, beside the curves, of at most two million trials. All but the first paragraph's and the
/// merge's figures are a model; tests/scale simulates it.
#pragma once

#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "parallel/communicator.hpp"
#include "runner/detail/earlier_rows.hpp"
#include "runner/progress.hpp"
#include "runner/stop_policy.hpp"
#include "store/shards.hpp"

namespace overturn {

struct WorkDone {
    std::int64_t committed = 0;  ///< blocks, by all ranks; known on rank 0
    PhaseSeconds seconds;        ///< this rank's

    void add(WorkDone const& more);
};

/// Work of a rank: the campaign, the folder for its blocks, and the rows that earlier campaigns left.
struct Work {
    CampaignSpec const& spec;
    Plan const& plan;
    store::ShardFolder const& shards;
    KeptRows const* known = nullptr;
};

/// Computes and commits the blocks `left` until none is left or it is time to go. Collective.
/// \throws CollectiveError on every rank if one cannot commit; the others commit what they have computed first
[[nodiscard]] WorkDone work(Work const& what, std::vector<std::int64_t> const& left, StopPolicy& stop_policy,
                            parallel::Communicator const& comm, Progress& progress);

}  // namespace overturn
