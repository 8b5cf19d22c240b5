/// The ranks that merge a campaign's blocks together. Rank 0 leads: it holds the results file and says what is to be
/// done next. Every rank, rank 0 too, does its share of that. A share whose rank does not answer in time is done by
/// another: all write the same bytes to the same place, so the late one does no harm.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "core/elapsed.hpp"
#include "output/write_results.hpp"
#include "parallel/communicator.hpp"
#include "parallel/letters.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Thrown where it is time to go before the results file is written.
struct Interrupted {};

/// \pre all that it is made of outlives it, and is the same on all ranks
class MergingRanks {
  public:
    /// \param keep_running asked before every block and every stretch of the file that is hashed, on every rank
    MergingRanks(parallel::Communicator const& comm, CampaignSpec const& spec, Plan const& drawn,
                 store::ShardFolder const& shards, std::function<bool()> keep_running);

    /// Runs `lead` on rank 0 while the other ranks do what it asks of them. Collective. Where one of them does not come
    /// back though the others wait, all ranks end: with the code of a run that can be resumed, or of a failure, which
    /// is printed.
    void run(std::function<void()> const& lead);

    /// For rank 0, within run(): what the other ranks help with. Nothing where rank 0 is alone; curves only where the
    /// file is packed, or counts of parts do not add up.
    [[nodiscard]] WritingHelp help(store::Layout layout) const;
    /// For rank 0, within run(): removes the blocks, and then all that lay beside them.
    void remove_blocks();
    /// The rows of a block. \throws Interrupted
    [[nodiscard]] std::vector<std::byte> read(std::int64_t block) const;

  private:
    enum class Task : char { rows = 'r', hash = 'h', curves = 'c', remove = 'x', leave = 'l' };
    struct Share {
        std::int64_t first = 0, last = 0;
    };
    using TextOfShare = std::function<std::string(Share)>;
    struct Shares;  ///< of one task

    // Of rank 0.
    [[nodiscard]] std::vector<std::string> all_do(Task task, std::int64_t count, TextOfShare const& text);
    [[nodiscard]] std::vector<int> ready() const;
    void ask(Shares& shares, std::size_t share, int rank);
    void do_here(Shares& shares, std::size_t share) const;
    void take_answers(Shares& shares);
    void hand_out_again(Shares& shares);
    void let_go(std::string const& outcome, int code_without_all);
    [[nodiscard]] std::vector<MeasuredFragility> all_fit(CampaignCurves const& curves);

    // Of every rank.
    void serve() const;
    [[nodiscard]] std::string answer(std::string text) const;
    [[nodiscard]] std::string rows(std::string const& text) const;
    [[nodiscard]] std::string hashes(std::string const& text) const;
    [[nodiscard]] std::string curves(std::string const& text) const;

    parallel::Communicator const& comm_;
    CampaignSpec const& spec_;
    Plan const& drawn_;
    store::ShardFolder const& shards_;
    std::function<bool()> keep_running_;
    WritingHelp help_;
    parallel::Letters letters_;
    std::map<int, std::int64_t> asked_;  ///< ranks that have not answered yet, and the number of what they were asked
    std::int64_t numbers_ = 0;
    double longest_s_ = 0;                        ///< that a share took
    CampaignCurves const* all_curves_ = nullptr;  ///< of rank 0, which holds what they are fitted to
};

}  // namespace overturn
