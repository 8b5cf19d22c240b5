/// The body on compliant points in space as a model: three components, six degrees of freedom.
#pragma once

#include <memory>

#include "model/model.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn {

[[nodiscard]] ModelTraits const& spatial_traits();

/// Called for by a polygon, which no plane holds; by a continuous rim, and by a round base of points that a second
/// component shakes at all; and on a square base where the second component comes near to tipping it, or where both
/// together overcome friction. Where the pad requires it, a square or round base is matched to the body's restitution
/// as the planar one is (match_restitution).
[[nodiscard]] std::unique_ptr<Model> make_spatial_model(ContactAccuracy const& accuracy);

}  // namespace overturn
