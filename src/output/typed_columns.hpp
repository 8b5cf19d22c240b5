/// Tables whose numbers are stated in the units of the campaign too.
#pragma once

#include <span>

#include "campaign/campaign_spec.hpp"
#include "output/table.hpp"

namespace overturn::output {

/// Gives each column of numbers the unit in which the campaign states such numbers, if that is not SI: of levels, of a
/// quantity, of the measure or the threshold of a row. JSON then has the value in both.
void give_typed_units(std::span<Table> tables, CampaignSpec const& spec);

}  // namespace overturn::output
