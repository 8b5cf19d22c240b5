/// Which measures a campaign's fragilities are drawn over, and what each is called.
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

/// What has to be kept of every trial: these, and the level itself.
[[nodiscard]] std::vector<Measure> held_measures(CampaignSpec const& spec);

/// Those held against V_Ereq; none without energies.
[[nodiscard]] std::vector<Measure> criteria_of(CampaignSpec const& spec);

/// As files and JSON name it: "pga", "sa_1".
[[nodiscard]] std::string name_of(Measure measure, CampaignSpec const& spec);
/// As people read it: "sa(1.9 s)".
[[nodiscard]] std::string label_of(Measure measure, CampaignSpec const& spec);
/// As axes of figures name it: "V_WES", "Sa(1.9 s)".
[[nodiscard]] std::string title_of(Measure measure, CampaignSpec const& spec);
/// SI.
[[nodiscard]] std::string units_of(Measure measure, LevelSpec const& levels);

/// As the levels were written, also for other measures of their dimension: V_WES in kine beside levels in kine.
[[nodiscard]] IntensityUnit printed_unit(std::string const& units, LevelSpec const& levels);

}  // namespace overturn
