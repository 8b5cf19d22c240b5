/// Statements of a campaign about its waves, by its keys.
#pragma once

#include <string_view>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// Is a key that begins so stated, and not by default?
[[nodiscard]] bool states(CampaignSpec const& spec, std::string_view begin);

/// May waves have a second horizontal component, or a vertical one? Records are not read for it: they may.
[[nodiscard]] bool may_shake_across(CampaignSpec const& spec);
[[nodiscard]] bool may_shake_vertically(CampaignSpec const& spec);

}  // namespace overturn
