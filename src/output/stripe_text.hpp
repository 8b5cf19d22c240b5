/// Trials by level, and what they cost, for the terminal.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "results/statistics.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn::output {

/// Trials of every body and limit state by level. \param velocities in which V_Ereq is told; none: m/s
[[nodiscard]] std::string stripes_text(CampaignSpec const& spec, Statistics const& statistics,
                                       std::optional<IntensityUnit> const& velocities = {});

/// "at-rest 512 trials, 0.1 us each; ..." of what was measured.
[[nodiscard]] std::string rung_costs(PhaseSeconds const& seconds);

}  // namespace overturn::output
