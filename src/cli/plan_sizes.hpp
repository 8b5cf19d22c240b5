/// Forecast of `plan`: disk and memory that a campaign needs.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {

/// Size of the results file [bytes].
[[nodiscard]] std::int64_t file_bytes(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan);

/// "603.21 MB, with --packed about 101 MB", in GB where large.
[[nodiscard]] std::string file_text(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan);

/// The files of blocks until they are merged.
[[nodiscard]] std::string scratch_line(Plan const& plan);

/// Memory of the trials that curves and intervals need, where it is much, and how many they see where that is not all;
/// else empty.
[[nodiscard]] std::string memory_lines(CampaignSpec const& spec, Plan const& plan);

/// The same in bytes: file, plain and packed (null where that is no smaller), scratch and memory; how many waves curves
/// see, or null where that is all.
[[nodiscard]] Json sizes_json(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan);

}  // namespace overturn::cli
