#include "response/response.hpp"

#include <algorithm>
#include <cmath>

#include "body/response_velocity.hpp"

namespace overturn {

RockingBlock block_of(RigidBody const& body) {
    return {.alpha_rad = body.alpha_rad(),
            .p_radps = body.p_radps(),
            .restitution = body.restitution(),
            .inertia_ratio = body.inertia_ratio(),
            .gravity_mps2 = body.gravity_mps2()};
}

namespace {

// Plain rocking first, watched; sliding only where it would have acted.
RockingOutcome climb(RockingBlock const& block, Shaking const& shaking, Scene const& scene, RockingStart const& start,
                     RockingObserver* observer, Response& response) {
    auto const& request = scene.effects;
    auto const run = [&](Slip slip, RockingObserver* watcher) {
        return simulate_rocking(block, shaking, scene.accuracy, start, watcher, slip);
    };
    bool const forced = request.mode == EffectMode::forced && has(request.include, Effect::sliding);
    if (!scene.friction || (request.mode != EffectMode::automatic && !forced)) {
        auto outcome = run(Slip::ignored, observer);
        if (scene.friction && outcome.friction_demand > scene.friction->static_coefficient) {
            response.called |= mask_of(Effect::sliding);
        }
        return outcome;
    }
    bool slips = forced;
    RockingOutcome outcome;
    if (!forced) {
        outcome = run(Slip::watched, nullptr);
        slips = outcome.slip_called;
    }
    if (slips) {
        outcome = run(Slip::simulated, observer);
        response.effects |= mask_of(Effect::sliding);
        response.rung = Rung::sliding;
    } else if (observer != nullptr) {
        outcome = run(Slip::watched, observer);
    }
    if (slips && (!forced || outcome.peak_slip_m > 0)) {
        response.called |= mask_of(Effect::sliding);
    }
    return outcome;
}

}  // namespace

Response respond(Scene const& scene, GroundMotion const& motion, double scale, RockingStart const& start,
                 RockingObserver* observer, double peak_mps2) {
    Response response;
    auto const& request = scene.effects;
    bool const wants_vertical = request.mode == EffectMode::automatic
                                || (request.mode == EffectMode::forced && has(request.include, Effect::vertical));
    Shaking shaking{.horizontal_mps2 = motion.horizontal_mps2,
                    .vertical_mps2 = {},
                    .time_step_s = motion.time_step_s,
                    .scale = scale,
                    .peak_mps2 = peak_mps2};
    if (!motion.vertical_mps2.empty()) {
        response.called |= mask_of(Effect::vertical);
        if (wants_vertical) {
            shaking.vertical_mps2 = motion.vertical_mps2;
            response.effects |= mask_of(Effect::vertical);
        }
    }
    // Beyond a million g nothing here means anything, and products overflow without a sound.
    constexpr double absurd_mps2 = 1e6 * g0;
    double const peak = std::isfinite(peak_mps2) ? peak_mps2 : peak_of(motion.horizontal_mps2);
    double const strongest = std::abs(scale) * std::max(peak, peak_of(shaking.vertical_mps2));
    if (!(strongest < absurd_mps2)) {
        response.rocking.verdict = Verdict::failed;
        return response;
    }
    auto block = block_of(scene.body);
    if (scene.friction) {
        block.friction_static = scene.friction->static_coefficient;
        block.friction_kinetic = scene.friction->kinetic_coefficient;
    }
    response.rocking = climb(block, shaking, scene, start, observer, response);
    if (response.rung == Rung::at_rest && response.rocking.verdict != Verdict::at_rest) {
        response.rung = Rung::rocking;
    }
    response.response_velocity_mps = response_velocity(scene.body, response.rocking.peak_rotation_rad);
    return response;
}

}  // namespace overturn
