/// Records that levels scale by more than guides allow.
#pragma once

#include <string>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// "record 3 is scaled by up to 3500 ...", or "" if none of the first thousand is scaled by more than 5, or the levels
/// are by spectral ordinates, which are not looked at here.
[[nodiscard]] std::string warning_of_scaled_records(CampaignSpec const& spec);

}  // namespace overturn
