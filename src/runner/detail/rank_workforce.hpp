/// The ranks of a job as the workforce of rare-event estimators, every finished portion of a stage durable.
#pragma once

#include <chrono>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "parallel/communicator.hpp"
#include "rare/workforce.hpp"
#include "runner/stop_policy.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Thrown on every rank when it is time to go; what is committed stays.
struct RareStopped {};

/// Ranks take the blocks of a portion in turn, rank 0 puts them together and commits them: so neither the number of
/// ranks nor a restart changes a row. Estimators ask for the same portions in the same order every time; the number of
/// a portion is its place in it.
class RankWorkforce : public rare::Workforce {
  public:
    /// Portions are shards from this number on, far beyond those of a plan.
    static constexpr std::int64_t first_shard = 1'000'000'000'000;
    static constexpr std::int64_t portion_items = 16384;

    RankWorkforce(store::ShardFolder const& shards, StopPolicy& stop_policy, parallel::Communicator const& comm);

    /// Names of stages begin with it: what is being estimated.
    void set_name(std::string name) { name_ = std::move(name); }
    [[nodiscard]] std::vector<std::byte> rows_of(rare::Stage const& stage, Work const& work) override;
    [[nodiscard]] std::int64_t computed() const { return computed_; }  ///< items, by all ranks

  private:
    [[nodiscard]] std::vector<std::byte> portion(rare::Stage const& stage, std::int64_t first, std::int64_t count,
                                                 Work const& work);
    [[nodiscard]] std::string own_rows(rare::Stage const& stage, std::int64_t first, std::int64_t count,
                                       Work const& work);
    [[nodiscard]] std::string put_together(rare::Stage const& stage, std::int64_t count,
                                           std::vector<std::string> const& of_ranks) const;
    [[nodiscard]] std::string committed(std::string const& head, std::size_t bytes) const;

    store::ShardFolder const& shards_;
    StopPolicy& stop_policy_;
    parallel::Communicator const& comm_;
    std::set<std::int64_t> found_;  ///< shards of an earlier run; on rank 0
    std::string name_;
    std::int64_t shard_ = first_shard;
    std::int64_t computed_ = 0;
};

}  // namespace overturn
