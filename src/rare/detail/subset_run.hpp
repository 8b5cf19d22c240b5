/// One replicate of a subset simulation, level by level, apart from who evaluates its trials.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rare/detail/answer_row.hpp"
#include "rare/detail/chain_states.hpp"
#include "rare/subset.hpp"

namespace overturn::rare {

class SubsetRun {
  public:
    /// \param key of the replicate's draws
    SubsetRun(DrawKey const& key, std::size_t normals, SubsetOptions const& options)
        : options_(options), states_(key, normals), step_size_(options.first_step) {}

    enum class End { none, reached, too_deep, plateau };

    /// The normals of a plain trial.
    void plain(std::int64_t index, std::span<double> normals);
    /// Takes the answers of plain trials 0, 1, ...
    void begin(std::span<AnswerRow const> rows);
    /// Looks at the samples of a level: is this the last one, and what does the next one ask for?
    void close_level();
    /// The trial that chain `chain` makes next, as normals. \pre end() == End::none
    void propose(std::int64_t chain, std::span<double> normals);
    /// Takes the chains' answers: accepts, and adapts the step.
    void step(std::span<AnswerRow const> rows);
    /// Whether every chain has made its steps within this level.
    [[nodiscard]] bool level_is_full() const { return step_ == options_.samples / options_.chains - 1; }

    [[nodiscard]] End end() const { return end_; }
    [[nodiscard]] SubsetReplicate const& result() const { return result_; }
    [[nodiscard]] std::int64_t undecided() const { return undecided_; }

  private:
    [[nodiscard]] SubsetNode next_node(std::int64_t chain) const;
    [[nodiscard]] SubsetNode const& node(std::int64_t n) const { return result_.nodes[n]; }

    SubsetOptions options_;
    ChainStates states_;
    SubsetReplicate result_;
    std::vector<std::int64_t> samples_;          ///< nodes of the present level
    std::vector<std::int64_t> chains_;           ///< node at which each chain stands
    std::vector<ChainStates::State> proposals_;  ///< made here, of the present step
    double step_size_;
    std::int64_t step_ = 0, accepted_ = 0, undecided_ = 0;
    End end_ = End::none;
};

}  // namespace overturn::rare
