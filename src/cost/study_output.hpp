/// A study for people (table), for scripts (JSON) and for plots (HDF5).
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cost/study.hpp"

namespace overturn::cost {

/// Tables of all knobs, the number of waves, and the sentence.
[[nodiscard]] std::string study_table(Study const& study);

/// Everything; what is not known is null.
[[nodiscard]] nlohmann::ordered_json study_json(Study const& study);

/// Columns of every knob under /cost/<knob>, of the number of waves under /cost/waves. Times make no two of these files
/// the same: it is a format of its own. \throws SystemError if it cannot be written
void write_study(std::filesystem::path const& path, CampaignInput const& input, Study const& study);

inline constexpr char const* format_name = "overturn-cost";
inline constexpr std::int64_t format_version = 1;

}  // namespace overturn::cost
