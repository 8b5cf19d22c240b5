/// Forecast of `plan`: how a campaign's blocks spread over ranks, and how long they take.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/plan.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {

/// What is before the first block, from the start of the program [s].
struct StartSeconds {
    double own = 0;          ///< on every rank: reading, warnings
    double calibration = 0;  ///< of waves; ranks share it

    [[nodiscard]] double on(std::int64_t ranks) const { return own + calibration / static_cast<double>(ranks); }
};

/// By a probe, for equal blocks and ranks as fast as the one that probed. From the start of the program to its end, as
/// `wall_s` of FILE.runtime.json.
struct RankEstimate {
    std::int64_t ranks = 1;
    std::int64_t blocks = 0;
    double block_s = 0;  ///< of one rank
    double start_s = 0;  ///< before the first block, on all ranks at once
    double work_s = 0;   ///< until the last block is done
    double rare_s = 0;   ///< of rare events; ranks share it
    double merge_s = 0;  ///< rows, by rank 0 alone where counts do not add up; curves, by all ranks; tables, by rank 0

    [[nodiscard]] double wall_s() const { return start_s + work_s + rare_s + merge_s; }
    /// Share of all ranks' time in which they compute.
    [[nodiscard]] double busy() const;
};

/// Time of one rank: for a wave with all of its trials, and for the rest [s].
struct ForecastSeconds {
    StartSeconds start;
    double wave = 0;
    double rare = 0;
    double undecided_bodies = 0;  ///< share of the bodies whose curves are fitted with undecided trials
};

[[nodiscard]] RankEstimate estimate_ranks(CampaignSpec const& spec, Plan const& plan, ForecastSeconds const& seconds,
                                          std::int64_t ranks);

/// "starting 0.3 s, waves 4 s, rare events 20 s, merging 1 s"
[[nodiscard]] std::string parts_text(RankEstimate const& estimate);

/// "about 45 s on 1000 ranks, which compute 91 % of it; 20000 blocks of 1.3 s, merged in 4 s"
[[nodiscard]] std::string ranks_text(RankEstimate const& estimate);
/// Warning that no run within this time ends a block, and what to do; empty where one fits. \param limit_s infinite:
/// none
[[nodiscard]] std::string too_short_text(RankEstimate const& estimate, std::int64_t block_waves, double limit_s);
[[nodiscard]] Json ranks_json(RankEstimate const& estimate);

}  // namespace overturn::cli
