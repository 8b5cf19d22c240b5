/// The ranks that merge a campaign's blocks together. Rank 0 leads: it holds the results file and says what is to be
/// done next. Every rank, rank 0 too, does its share of that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "output/write_results.hpp"
#include "parallel/communicator.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Thrown where it is time to go before the results file is written.
struct Interrupted {};

/// \pre all that it is made of outlives it, and is the same on all ranks
class MergingRanks {
  public:
    /// \param keep_running asked before every block, on every rank
    MergingRanks(parallel::Communicator const& comm, CampaignSpec const& spec, Plan const& drawn,
                 store::ShardFolder const& shards, std::function<bool()> keep_running);

    /// Runs `lead` on rank 0 while the other ranks do what it asks of them. Collective.
    void run(std::function<void()> const& lead) const;

    /// For rank 0, within run(): what writes a file with the other ranks. Null where rank 0 is alone, the file is
    /// packed, or counts of parts do not add up.
    [[nodiscard]] WritingHelp const* help(store::Layout layout) const;
    /// For rank 0, within run(): removes the blocks, and then all that lay beside them.
    void remove_blocks() const;
    /// The rows of a block. \throws Interrupted
    [[nodiscard]] std::vector<std::byte> read(std::int64_t block) const;

  private:
    enum class Task : char { rows = 'r', hash = 'h', remove = 'x', leave = 'l' };
    struct Share {
        std::int64_t first, last;
    };
    [[nodiscard]] Share share_of(std::int64_t count) const;
    [[nodiscard]] std::vector<std::string> all_do(Task task, std::string const& text) const;
    [[nodiscard]] std::string answer(Task task, std::string const& text) const;
    [[nodiscard]] std::string rows(std::string const& text) const;
    [[nodiscard]] std::string hashes(std::string const& text) const;

    parallel::Communicator const& comm_;
    CampaignSpec const& spec_;
    Plan const& drawn_;
    store::ShardFolder const& shards_;
    std::function<bool()> keep_running_;
    WritingHelp help_;
};

}  // namespace overturn
