/// Inputs of a body that no model reads which the campaign may run on it.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "config/input_value.hpp"

namespace overturn {

/// Does this value move no trial of the campaign, as no model that may run reads it? A restitution under a base that
/// has its own, a static friction under points, a base or pad where bodies are rigid. False for all values outside
/// [[bodies]].
[[nodiscard]] bool is_unused(config::InputValue const& value, CampaignSpec const& spec);

}  // namespace overturn
