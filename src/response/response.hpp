/// Which effects a scene calls for, and what the body does: body + motion + effects -> Response.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "body/rigid_body.hpp"
#include "motion/ground_motion.hpp"
#include "response/effects.hpp"
#include "rocking/page_peaks.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn {

/// Coulomb friction between base and ground.
struct Friction {
    double static_coefficient = 0;
    double kinetic_coefficient = 0;
};

/// The ladder of models: a trial runs on the lowest rung that holds the effects it calls for.
enum class Rung { at_rest, rocking, sliding };
inline constexpr int rung_count = 3;

/// One trial's answer.
struct Response {
    RockingOutcome rocking;
    EffectMask effects = 0;            ///< that ran
    EffectMask called = 0;             ///< that the monitors say would act, whether they ran or not
    double response_velocity_mps = 0;  ///< V_resp of the peak rotation
    Rung rung = Rung::at_rest;         ///< the highest that ran
};

/// A body at a level: what does not change from wave to wave.
struct Scene {
    RigidBody const& body;
    std::optional<Friction> friction;  ///< empty: no slip
    EffectRequest effects;
    RockingAccuracy accuracy;
};

/// The rocking equation's view of a body.
[[nodiscard]] RockingBlock block_of(RigidBody const& body);

/// With effects on call a trial with friction begins as plain rocking that is watched, and is run again with sliding
/// only if it would slip; verdict and numbers are those of sliding forced on. \param scale multiplies every component
/// of the motion \param peak_mps2 the largest |horizontal| of the motion, if known: spares trials at rest any work
/// \param observer sees the history if given
[[nodiscard]] Response respond(Scene const& scene, GroundMotion const& motion, double scale,
                               RockingStart const& start = {}, RockingObserver* observer = nullptr,
                               double peak_mps2 = std::numeric_limits<double>::infinity());

/// One trial of many.
struct SceneTrial {
    Scene const& scene;
    GroundMotion const& motion;
    double scale = 1;
    double peak_mps2 = std::numeric_limits<double>::infinity();
    rocking::PagePeaks const* pages = nullptr;  ///< of the motion, if at hand: rest is then skipped by pages
};

/// Where the time went [s].
struct LadderSeconds {
    double preparing = 0;  ///< every trial: what one at rest costs
    double rocking = 0;    ///< plain rocking, of trials that will slip up to the slip
    double sliding = 0;
};

/// Many trials from rest, the lower rungs side by side in the machine's vector lanes: responses[i] is bit-equal to that
/// of trials[i] alone, but for the energies of what called for slip: they count from where friction gave out.
/// \pre one accuracy for all
LadderSeconds respond(std::span<SceneTrial const> trials, std::span<Response> responses);

}  // namespace overturn
