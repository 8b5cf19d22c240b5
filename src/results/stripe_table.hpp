/// Stripes and costs for the terminal.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "results/statistics.hpp"
#include "stats/fragility.hpp"

namespace overturn {

/// The stripe table for the terminal. \param velocities in which V_Ereq is told; none: m/s
[[nodiscard]] std::string stripe_table(CampaignSpec const& spec, Statistics const& statistics,
                                       std::optional<IntensityUnit> const& velocities = {});

/// "at-rest 512 trials, 0.1 us each; ..." of what was measured.
[[nodiscard]] std::string rung_costs(PhaseSeconds const& seconds);

}  // namespace overturn
