/// In which units a campaign states its levels and responses.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "stats/intensity_unit.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Empty where the campaign states them as bare numbers, or cannot be read by this program: its numbers are SI then.
[[nodiscard]] std::optional<IntensityUnit> stated_unit_of_levels(store::ResultsReader const& file);

/// The same of columns whose SI unit is the key ("m", "m/s2"), for what the campaign states in other than SI units.
[[nodiscard]] std::map<std::string, IntensityUnit> stated_units_of_columns(CampaignSpec const& spec);

}  // namespace overturn
