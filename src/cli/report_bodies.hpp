/// Facts of bodies in a report that the results file does not hold as columns.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"

namespace overturn::cli {

/// Outlines of what each body is assembled from, by its name: width, height and bottom [m]; a point mass has no width.
[[nodiscard]] nlohmann::ordered_json outlines_of(CampaignSpec const& spec);

/// A line on each body that does not stand straight: slope of the ground, offset of its centre, tilt that it starts
/// with, and what that makes of its two corners.
[[nodiscard]] nlohmann::ordered_json placements_of(CampaignSpec const& spec);

}  // namespace overturn::cli
