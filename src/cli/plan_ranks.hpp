/// Forecast of `plan`: how a campaign's blocks spread over ranks, and how long they take.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/plan.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {

/// By a probe, for equal blocks and ranks as fast as the one that probed.
struct RankEstimate {
    std::int64_t ranks = 1;
    std::int64_t blocks = 0;
    double block_s = 0;  ///< of one rank
    double start_s = 0;  ///< before the first block, on all ranks at once
    double work_s = 0;   ///< until the last block is done
    double merge_s = 0;  ///< rows, by rank 0 alone where counts do not add up; curves, by all ranks; tables, by rank 0

    [[nodiscard]] double wall_s() const { return start_s + work_s + merge_s; }
    /// Share of all ranks' time in which they compute.
    [[nodiscard]] double busy() const;
};

/// \param wave_s of one rank, with all of the wave's trials
[[nodiscard]] RankEstimate estimate_ranks(CampaignSpec const& spec, Plan const& plan, double wave_s, double start_s,
                                          std::int64_t ranks);

/// "about 45 s on 1000 ranks, which compute 91 % of it; 20000 blocks of 1.3 s, merged in 4 s"
[[nodiscard]] std::string ranks_text(RankEstimate const& estimate);
[[nodiscard]] Json ranks_json(RankEstimate const& estimate);

}  // namespace overturn::cli
