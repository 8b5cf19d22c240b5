/// A block of waves computed, and its rows as the bytes that ranks send each other and shards hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "campaign/trial.hpp"

namespace overturn {

/// Rows of a block of waves: all wave rows, then all measure rows, then all trial rows, then their models' own records,
/// each in order.
struct BlockRows {
    std::vector<WaveRow> waves;
    std::vector<MeasureRow> measures;
    TrialRows trials;

    [[nodiscard]] std::vector<std::byte> pack() const;
    /// Size of a block's rows from pack() [bytes].
    [[nodiscard]] static std::size_t packed_size(Plan const& plan, std::int64_t block);
    /// \throws SystemError if the bytes are not those of `waves` waves of this plan
    [[nodiscard]] static BlockRows unpack(std::span<std::byte const> bytes, Plan const& plan, std::int64_t waves);
};

/// Blocks of few trials computed together, so that trials on one model fill the vector lanes; each has the bytes that
/// it has alone. \param keep_running called before every wave and every trial on points; if it returns false, the
/// result is empty
/// \param known trials that are not computed again, or null
[[nodiscard]] std::optional<std::vector<BlockRows>> run_blocks(CampaignSpec const& spec, Plan const& plan,
                                                               std::span<std::int64_t const> blocks,
                                                               PhaseSeconds& seconds,
                                                               std::function<bool()> const& keep_running,
                                                               KnownTrials const* known = nullptr);
/// Number of blocks that are worth computing together.
[[nodiscard]] std::int64_t blocks_together(Plan const& plan);
/// One whole block, come what may.
[[nodiscard]] BlockRows run_block(CampaignSpec const& spec, Plan const& plan, std::int64_t block,
                                  PhaseSeconds& seconds);

}  // namespace overturn
