/// Which bodies of a campaign may move in space.
#pragma once

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// May this body be shaken by two horizontal components, and be simulated so? Records are not read for it: they may.
[[nodiscard]] bool may_move_in_space(CampaignSpec const& spec, BodySpec const& body);

}  // namespace overturn
