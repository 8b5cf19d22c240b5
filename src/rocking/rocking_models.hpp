/// The planar rigid block as models: plain rocking, and rocking with sliding, each with vertical motion if the wave has
/// it.
#pragma once

#include <memory>

#include "model/model.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn {

[[nodiscard]] ModelTraits const& rocking_traits();
[[nodiscard]] ModelTraits const& sliding_traits();

/// Rocking without slip. A trial whose friction gives out ends there where sliding is taken over, and is followed as if
/// it held where not; both are recorded in Outcome::called.
[[nodiscard]] std::unique_ptr<Model> make_rocking_model(RockingAccuracy const& accuracy);
/// Stick-slip, slide-rocking and slip at impacts; trials that make_rocking_model's model ended go on from where
/// friction gave out.
[[nodiscard]] std::unique_ptr<Model> make_sliding_model(RockingAccuracy const& accuracy);

/// The rocking equation's view of a body. \param friction empty: none that could give out
[[nodiscard]] RockingBlock block_of(RigidBody const& body, std::optional<Friction> const& friction = {});

}  // namespace overturn
