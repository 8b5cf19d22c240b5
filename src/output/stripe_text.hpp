/// Trials by level, and what they cost, for the terminal.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "results/statistics.hpp"
#include "stats/capacity_fit.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn::output {

/// Trials of every body and limit state by level. \param velocities unit of V_Ereq; none: that of
/// the campaign
[[nodiscard]] std::string stripes_text(CampaignSpec const& spec, Statistics const& statistics,
                                       std::optional<IntensityUnit> const& velocities = {});

/// Stripes of a table without a campaign. \param amplitude heading of its column \param full all of them
[[nodiscard]] std::string table_stripes_text(std::string const& amplitude, std::span<Stripe const> stripes,
                                             double confidence, bool full);

/// "12 capacities, 0.3 g to 1.2 g; 2 not reached", and their moments. \param unit of them, with a value of 1
[[nodiscard]] std::string capacities_text(std::span<Capacity const> capacities, IntensityUnit const& unit);

/// "12 trials still rocked when the record ended (3 fell and ...)"; empty where none did.
[[nodiscard]] std::string cut_short_text(BodyStatistics const& counted);

/// "at-rest 512 trials, 0.1 us each; ..." of what was measured.
[[nodiscard]] std::string model_costs(PhaseSeconds const& seconds);

}  // namespace overturn::output
