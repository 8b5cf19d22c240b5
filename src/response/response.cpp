#include "response/response.hpp"

#include "body/response_velocity.hpp"

namespace overturn {

RockingBlock block_of(RigidBody const& body) {
    return {.alpha_rad = body.alpha_rad(),
            .p_radps = body.p_radps(),
            .restitution = body.restitution(),
            .inertia_ratio = body.inertia_ratio(),
            .gravity_mps2 = body.gravity_mps2()};
}

Response respond(Scene const& scene, GroundMotion const& motion, double scale, RockingStart const& start,
                 RockingObserver* observer) {
    Response response;
    auto const& request = scene.effects;
    bool const wants_vertical = request.mode == EffectMode::automatic
                                || (request.mode == EffectMode::forced && has(request.include, Effect::vertical));
    Shaking shaking{.horizontal_mps2 = motion.horizontal_mps2,
                    .vertical_mps2 = {},
                    .time_step_s = motion.time_step_s,
                    .scale = scale};
    if (!motion.vertical_mps2.empty()) {
        response.called |= mask_of(Effect::vertical);
        if (wants_vertical) {
            shaking.vertical_mps2 = motion.vertical_mps2;
            response.effects |= mask_of(Effect::vertical);
        }
    }
    response.rocking = simulate_rocking(block_of(scene.body), shaking, scene.accuracy, start, observer);
    if (scene.friction && response.rocking.friction_demand > scene.friction->static_coefficient) {
        response.called |= mask_of(Effect::sliding);
    }
    response.response_velocity_mps = response_velocity(scene.body, response.rocking.peak_rotation_rad);
    return response;
}

}  // namespace overturn
