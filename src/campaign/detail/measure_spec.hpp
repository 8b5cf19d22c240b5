/// Measures of a campaign's waves: those of [measures], and those that its levels need.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// Reads [measures]. \throws InputError
[[nodiscard]] MeasureSpec read_measures(config::Table const& table);

/// Has levels by Sa measured: what they scale by is stored with every wave. \throws InputError where that is too much
void measure_levels(config::Table const& root, LevelSpec& levels, MeasureSpec& m);

}  // namespace overturn
