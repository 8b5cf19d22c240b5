/// The waves of a campaign that count: the first ones in the order of their numbers; with an acceptance rule, the first
/// ones that meet it. A wave that misses it is no trial, whatever the bodies under it did.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "campaign/block_rows.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"

namespace overturn {

/// Acceptance of the waves drawn so far, block by block and in any order. Nothing here depends on how many more were
/// computed than are needed.
class AcceptedWaves {
  public:
    /// \param drawn the campaign's own plan, or its first blocks; outlives this
    AcceptedWaves(CampaignSpec const& spec, Plan const& drawn);

    /// Is there a rule, so that rows say which waves count?
    [[nodiscard]] bool needs_rows() const { return acceptance_.refuses(); }
    [[nodiscard]] bool knows(std::int64_t block) const { return known_.at(block); }
    /// \param rows of its waves; of no use without a rule
    void take(std::int64_t block, std::span<WaveRow const> rows = {});

    /// Blocks that are not known yet and are worth computing now, rising, on the way to `count` accepted waves; of each
    /// level where levels have waves of their own. None: `count` are known, or all that may be drawn.
    [[nodiscard]] std::vector<std::int64_t> wanted(std::int64_t count) const;
    /// The first `count` that are accepted, or all of them where fewer are. \pre wanted(count) is empty
    [[nodiscard]] Plan chosen(std::int64_t count) const;
    /// Why it is not worth going on: fewer than one in ten of the first hundred were accepted, or none of all that may
    /// be drawn. With the clauses they missed and what helps. Empty: go on.
    [[nodiscard]] std::string hopeless() const;

  private:
    enum class Wave : std::uint8_t { unknown, accepted, refused };
    struct Known {
        std::int64_t drawn = 0, accepted = 0;  ///< without a gap from the group's first wave on
        std::int64_t accepted_of_first = 0;    ///< of its first hundred
    };
    [[nodiscard]] Known known(std::int64_t group, std::int64_t count) const;
    [[nodiscard]] std::int64_t draw_to(std::int64_t group, std::int64_t count) const;

    Acceptance acceptance_;
    Plan const& drawn_;
    std::vector<bool> known_;           ///< blocks
    std::vector<Wave> waves_;           ///< where there is a rule
    std::vector<std::int64_t> missed_;  ///< waves that miss a clause, in the order of clause_names()
};

/// Which clauses of a rule refused waves miss, the most often first, and what helps: "duration missed by 10. State
/// ...".
[[nodiscard]] std::string missed_text(std::span<WaveRow const> refused);

/// Rows of a block of `drawn` for those waves that `chosen` has.
[[nodiscard]] BlockRows rows_of_chosen(BlockRows rows, Plan const& drawn, std::int64_t block, Plan const& chosen);

/// Rows of a block of `drawn` for waves that the rule refused on the way to the chosen ones.
[[nodiscard]] std::vector<WaveRow> refused_rows(BlockRows const& rows, Plan const& drawn, std::int64_t block,
                                                Plan const& chosen);

/// The blocks of `drawn` that hold waves which were drawn for the chosen ones, rising.
[[nodiscard]] std::vector<std::int64_t> blocks_of_chosen(Plan const& drawn, Plan const& chosen);

}  // namespace overturn
