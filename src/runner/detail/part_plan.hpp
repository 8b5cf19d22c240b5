/// Waves that a part of an array job is planned over.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"

namespace overturn {

/// All waves that may be drawn; for a part of waves that are held to a rule those that will probably be needed, which
/// every part finds from the first 32. Waves that turn out to be missing are reported when the parts are merged.
/// \throws InputError for a part of waves that each level draws for itself until enough of them are accepted
[[nodiscard]] Plan plan_of_part(CampaignSpec const& spec, Part part);

}  // namespace overturn
