/// A study for people (text), and for scripts and plots (tables: JSON and HDF5).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cost/study.hpp"
#include "output/table.hpp"

namespace overturn::cost {

/// For the terminal: the answer, then every knob and the number of waves.
[[nodiscard]] std::string study_text(Study const& study);

/// Everything: the study in one row, rounding, knobs and the settings of each, what steps do, the number of waves (no
/// row of a grid), and rare events where the campaign has them.
[[nodiscard]] std::vector<output::Table> study_tables(Study const& study);

/// Writes the tables. Times make no two of these files the same: it is a format of its own. \throws SystemError if it
/// cannot be written
void write_study(std::filesystem::path const& path, CampaignInput const& input, Study const& study);

inline constexpr char const* format_name = "overturn-cost";
inline constexpr std::int64_t format_version = 2;

}  // namespace overturn::cost
