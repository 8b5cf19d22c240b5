/// Committed results of an unfinished run, counted as a merge would count them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "campaign/campaign_spec.hpp"
#include "results/statistics.hpp"

namespace overturn {

/// Waves that were done first, which need not be the first waves: not a campaign's answer.
struct Interim {
    CampaignInput input;
    std::unique_ptr<CampaignSpec> spec;  ///< of which the statistics are
    Statistics statistics;
    std::int64_t blocks = 0;                 ///< that are committed
    std::optional<std::int64_t> all_blocks;  ///< none: how many it needs is not known yet
    std::int64_t waves = 0, planned = 0;     ///< that count, and that it asks for
};

/// Is the file there that the run was to write, with no larger campaign begun beside it? Blocks may be about to go.
/// \throws InputError if what is there is no results file
[[nodiscard]] bool is_finished(std::filesystem::path const& output);

/// Reads the sound blocks of the run that is to write `output`; it may be under way. Damaged ones are named on stderr.
/// \throws InputError if nothing was begun there, by this program, or no block is committed yet
[[nodiscard]] Interim interim_results(std::filesystem::path const& output);

}  // namespace overturn
