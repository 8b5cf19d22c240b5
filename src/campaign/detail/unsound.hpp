/// What a campaign to be run may not state, though a file of results that has it is still read: what can only be a
/// slip, and would be believed.
#pragma once

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"

namespace overturn {

/// A level or a limit without a unit beside levels that have one; a limit that no trial can pass but by falling, or
/// that every trial passes. \throws InputError at the key
void refuse_unsound(CampaignInput const& input, CampaignSpec const& spec);

}  // namespace overturn
