#include "response/response.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "body/response_velocity.hpp"
#include "core/error.hpp"
#include "rocking/pause.hpp"

namespace overturn {

RockingBlock block_of(RigidBody const& body) {
    return {.alpha_rad = body.alpha_rad(),
            .p_radps = body.p_radps(),
            .restitution = body.restitution(),
            .inertia_ratio = body.inertia_ratio(),
            .gravity_mps2 = body.gravity_mps2()};
}

namespace {

// A trial on its way up the ladder.
struct Climb {
    RockingTrial trial;
    Slip first = Slip::ignored;  ///< how the first rung looks at friction
    bool absurd = false;
    Response response;
    rocking::Pause pause;  ///< where friction gave out
};

bool wants(EffectRequest const& request, Effect effect) {
    return request.mode == EffectMode::automatic
           || (request.mode == EffectMode::forced && has(request.include, effect));
}

Climb prepare(SceneTrial const& at) {
    auto const& [scene, motion, scale, peak_mps2, pages] = at;
    Climb climb;
    auto& [block, shaking] = climb.trial;
    shaking = {.horizontal_mps2 = motion.horizontal_mps2,
               .vertical_mps2 = {},
               .time_step_s = motion.time_step_s,
               .scale = scale,
               .peak_mps2 = peak_mps2,
               .pages = pages};
    if (!motion.vertical_mps2.empty()) {
        climb.response.called |= mask_of(Effect::vertical);
        if (wants(scene.effects, Effect::vertical)) {
            shaking.vertical_mps2 = motion.vertical_mps2;
            climb.response.effects |= mask_of(Effect::vertical);
        }
    }
    // Beyond a million g nothing here means anything, and products overflow without a sound.
    constexpr double absurd_mps2 = 1e6 * g0;
    double const peak = std::isfinite(peak_mps2) ? peak_mps2 : peak_of(motion.horizontal_mps2);
    climb.absurd = !(std::abs(scale) * std::max(peak, peak_of(shaking.vertical_mps2)) < absurd_mps2);
    block = block_of(scene.body);
    if (scene.friction) {
        block.friction_static = scene.friction->static_coefficient;
        block.friction_kinetic = scene.friction->kinetic_coefficient;
        if (wants(scene.effects, Effect::sliding)) {
            climb.first = scene.effects.mode == EffectMode::forced ? Slip::simulated : Slip::watched;
        }
    }
    return climb;
}

RockingOutcome run(Climb const& climb, Scene const& scene, Slip slip, RockingStart const& start = {},
                   RockingObserver* observer = nullptr) {
    return simulate_rocking(climb.trial.block, climb.trial.shaking, scene.accuracy, start, observer, slip);
}

// What the rungs that ran say about the effects and the body.
void conclude(Climb& climb, Scene const& scene) {
    auto& response = climb.response;
    auto const& rocking = response.rocking;
    if (climb.first == Slip::ignored) {
        if (scene.friction && rocking.friction_demand > scene.friction->static_coefficient) {
            response.called |= mask_of(Effect::sliding);
        }
    } else if (response.rung == Rung::sliding) {
        response.effects |= mask_of(Effect::sliding);
        if (climb.first == Slip::watched || rocking.peak_slip_m > 0) {
            response.called |= mask_of(Effect::sliding);
        }
    }
    if (response.rung == Rung::at_rest && rocking.verdict != Verdict::at_rest) {
        response.rung = Rung::rocking;
    }
    response.response_velocity_mps = response_velocity(scene.body, rocking.peak_rotation_rad);
}

Response absurd(Climb const& climb) {
    auto response = climb.response;
    response.rocking.verdict = Verdict::failed;
    return response;
}

class Stopwatch {
  public:
    [[nodiscard]] double lap() {
        auto const now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// All trials whose first rung looks at friction in the same way, side by side.
void first_rung(std::span<Climb> climbs, Slip slip, RockingAccuracy const& accuracy) {
    std::vector<std::size_t> which;
    std::vector<RockingTrial> trials;
    which.reserve(climbs.size());
    trials.reserve(climbs.size());
    for (std::size_t i = 0; i < climbs.size(); ++i) {
        if (!climbs[i].absurd && climbs[i].first == slip) {
            which.push_back(i);
            trials.push_back(climbs[i].trial);
        }
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    std::vector<rocking::Pause> pauses(trials.size());
    if (slip == Slip::watched) {
        watch_friction(trials, accuracy, outcomes, pauses);
    } else {
        simulate_rocking(trials, accuracy, slip, outcomes);
    }
    for (std::size_t i = 0; i < which.size(); ++i) {
        climbs[which[i]].response.rocking = outcomes[i];
        climbs[which[i]].pause = pauses[i];
    }
}

}  // namespace

Response respond(Scene const& scene, GroundMotion const& motion, double scale, RockingStart const& start,
                 RockingObserver* observer, double peak_mps2) {
    auto climb = prepare({scene, motion, scale, peak_mps2, nullptr});
    if (climb.absurd) {
        return absurd(climb);
    }
    auto& response = climb.response;
    bool const watches = climb.first == Slip::watched;
    response.rocking = run(climb, scene, climb.first, start, watches ? nullptr : observer);
    if (climb.first == Slip::simulated || response.rocking.slip_called) {
        response.rung = Rung::sliding;
    }
    if (watches && response.rung == Rung::sliding) {
        response.rocking = run(climb, scene, Slip::simulated, start, observer);
    } else if (watches && observer != nullptr) {
        response.rocking = run(climb, scene, Slip::watched, start, observer);
    }
    conclude(climb, scene);
    return response;
}

LadderSeconds respond(std::span<SceneTrial const> trials, std::span<Response> responses) {
    OVERTURN_EXPECT(responses.size() == trials.size());
    LadderSeconds seconds;
    Stopwatch watch;
    std::vector<Climb> climbs;
    climbs.reserve(trials.size());
    for (auto const& trial : trials) {
        climbs.push_back(prepare(trial));
    }
    seconds.preparing = watch.lap();
    if (!trials.empty()) {
        auto const& accuracy = trials.front().scene.accuracy;
        first_rung(climbs, Slip::ignored, accuracy);
        first_rung(climbs, Slip::watched, accuracy);
    }
    seconds.rocking = watch.lap();
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto& climb = climbs[i];
        if (climb.absurd) {
            responses[i] = absurd(climb);
            continue;
        }
        if (climb.first == Slip::simulated || climb.response.rocking.slip_called) {
            auto const& scene = trials[i].scene;
            climb.response.rocking = climb.pause.at_hand ? go_on_slipping(climb.trial, scene.accuracy, climb.pause)
                                                         : run(climb, scene, Slip::simulated);
            climb.response.rung = Rung::sliding;
        }
        conclude(climb, trials[i].scene);
        responses[i] = climb.response;
    }
    seconds.sliding = watch.lap();
    return seconds;
}

}  // namespace overturn
