/// The bodies of a campaign as tables.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "output/table.hpp"

namespace overturn::output {

/// `bodies` of one body: what the equations take of it.
[[nodiscard]] Table body_table(CampaignSpec const& spec, std::size_t number);

}  // namespace overturn::output
