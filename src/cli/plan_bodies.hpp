/// The bodies of a campaign as `plan` shows them.
#pragma once

#include <string>

#include "campaign/campaign_spec.hpp"
#include "cli/json_values.hpp"
#include "cli/velocity_unit.hpp"

namespace overturn::cli {

/// A row each, and below them what holds of some: placement, friction, base and pad, each text once.
/// \param most rows; where there are more bodies, half as many texts and at least four. The others are counted
[[nodiscard]] std::string bodies_text(CampaignSpec const& spec, output::ShownVelocity const& unit, std::size_t most);

/// Friction, base and pad of the bodies, and the restitution at which they rock: a line for each text, at most 12.
[[nodiscard]] Json supports_of(CampaignSpec const& spec);

/// The rows of all bodies, in SI, with what holds of each.
[[nodiscard]] Json bodies_json(CampaignSpec const& spec);

}  // namespace overturn::cli
