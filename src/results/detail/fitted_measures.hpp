/// Measures of a campaign's fragility curves, and their names.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "results/measured_trials.hpp"
#include "stats/fragility.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// The levels' own measure comes first; levels of a measure that no fit has by itself add one.
[[nodiscard]] std::vector<Measure> measures_of(CampaignSpec const& spec);

/// Measures that must be kept of every trial: these, and the level itself.
[[nodiscard]] std::vector<Measure> held_measures(CampaignSpec const& spec);

/// Measures compared with V_Ereq; none without energies.
[[nodiscard]] std::vector<Measure> criteria_of(CampaignSpec const& spec);

/// Name in files and JSON: "pga", "sa_1".
[[nodiscard]] std::string name_of(Measure measure, CampaignSpec const& spec);
/// Name for people: "sa(1.9 s)".
[[nodiscard]] std::string label_of(Measure measure, CampaignSpec const& spec);
/// Name on axes of figures: "V_WES", "Sa(1.9 s)".
[[nodiscard]] std::string title_of(Measure measure, CampaignSpec const& spec);
/// SI unit of a measure.
[[nodiscard]] std::string units_of(Measure measure, LevelSpec const& levels);

/// Unit in which the levels were written, also for other measures of their dimension: V_WES in kine beside levels in
/// kine.
[[nodiscard]] IntensityUnit printed_unit(std::string const& units, LevelSpec const& levels);

}  // namespace overturn
