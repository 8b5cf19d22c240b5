/// Settings of a campaign and facts of its bodies, as a report's page lists them.
#pragma once

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "output/json.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// Pairs of a label and the value that was requested, or run.
[[nodiscard]] Json facts_of(CampaignSpec const& spec, Plan const& plan, Statistics const& statistics);

/// Pairs of a label and a setting of the method: effects, validated range, integration.
[[nodiscard]] Json method_of(CampaignSpec const& spec);

/// Outlines of what each body is assembled from, by its name: width, height and bottom [m]; a point mass has no width.
[[nodiscard]] Json outlines_of(CampaignSpec const& spec);

/// A line on each body that does not stand straight: slope of the ground, offset of its centre, tilt that it starts
/// with, and what that makes of its two corners.
[[nodiscard]] Json placements_of(CampaignSpec const& spec);

}  // namespace overturn::output
