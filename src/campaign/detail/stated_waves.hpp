/// Statements of a campaign about its waves, by its keys.
#pragma once

#include <string_view>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// Is a key that begins so stated, and not by default?
[[nodiscard]] bool states(CampaignSpec const& spec, std::string_view begin);

/// Has any wave a second horizontal component? Of recorded motions those that were read say so.
[[nodiscard]] bool may_shake_across(CampaignSpec const& spec);
/// Have all waves one, or a vertical one?
[[nodiscard]] bool always_shakes_across(CampaignSpec const& spec);
[[nodiscard]] bool always_shakes_vertically(CampaignSpec const& spec);

}  // namespace overturn
