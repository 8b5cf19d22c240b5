/// The planar rigid block as models: plain rocking, and rocking with sliding, each with vertical motion if the wave has
/// it.
#pragma once

#include <memory>

#include "model/model.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn {

/// What a rigid base has to say beside every model's outcome. Places are unknown where friction gave out and nothing
/// slips, where the base flew, and without a verdict.
struct RigidQuantities {
    /// Farthest that the base's edge was or, of a corner that the body was lifted off, would have been, laid down
    /// there.
    double edge_x_most_m = never, edge_x_least_m = never;
    double residual_x_m = never;  ///< of the base's middle, at the end, the body upright
    double peak_top_m = never;    ///< of the axis at twice the height h; where it slips or its corners differ: at most
    double rotation_at_peak_rad = never;  ///< of the peak rotation; towards +x above 0
};
template <> [[nodiscard]] Fields const& fields_of<RigidQuantities>();

[[nodiscard]] ModelTraits const& rocking_traits();
[[nodiscard]] ModelTraits const& sliding_traits();

/// Rocking without slip. A trial whose friction gives out ends there where sliding is taken over, and is followed as if
/// it held where not; both are recorded in Outcome::required.
[[nodiscard]] std::unique_ptr<Model> make_rocking_model(RockingAccuracy const& accuracy);
/// Stick-slip, slide-rocking and slip at impacts; trials that make_rocking_model's model ended go on from where
/// friction gave out.
[[nodiscard]] std::unique_ptr<Model> make_sliding_model(RockingAccuracy const& accuracy);

/// The rocking equation's view of a body. \param friction empty: none that could give out
[[nodiscard]] RockingBlock block_of(RigidBody const& body, std::optional<Friction> const& friction = {});

}  // namespace overturn
