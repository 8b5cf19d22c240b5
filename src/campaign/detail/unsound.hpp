/// Errors refused in a campaign to be run, although a results file with them is still read: they can only be a slip,
/// and their results would be believed.
#pragma once

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"

namespace overturn {

/// A level or a limit without a unit beside levels that have one; a limit that no trial can pass but by falling, or
/// that every trial passes. \throws InputError at the key
void refuse_unsound(CampaignInput const& input, CampaignSpec const& spec);

}  // namespace overturn
