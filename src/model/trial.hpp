/// One trial as a model sees it: a body, what holds it, what shakes it.
#pragma once

#include <optional>

#include "body/footing.hpp"
#include "body/rigid_body.hpp"
#include "model/effect.hpp"
#include "model/excitation.hpp"
#include "model/friction.hpp"

namespace overturn {

/// Views: what they show must outlive the trial.
struct Trial {
    RigidBody const* body = nullptr;
    Footing const* footing = nullptr;  ///< its support; never null for a model
    std::optional<Friction> friction;  ///< empty: no slip
    Excitation excitation;             ///< all that shakes, whether it is simulated or not
    EffectMask simulated = 0;
    /// Effects that another model will take over: a model that leaves one out may end where it begins to act, and says
    /// so in Outcome::required.
    EffectMask handled_later = 0;
};

/// Part of the excitation that a planar model simulates: no transverse component, the vertical one if it is among
/// `simulated`.
[[nodiscard]] Excitation planar_excitation(Trial const& trial);

}  // namespace overturn
