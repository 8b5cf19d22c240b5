// What an effect costs while it is off, looked for, or forced on without being called for; and what choosing it per
// trial saves. Figures are for people: nothing here asserts.
#include <cmath>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "response/model_selector.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/long_period_wave.hpp"

namespace overturn {
namespace {

enum class Set { a, b };

std::vector<double> const& wave(Set set) {
    static std::vector<double> const a = testing::filtered_wave(testing::set_a);
    static std::vector<double> const b = testing::filtered_wave(testing::set_b);
    return set == Set::a ? a : b;
}

// alpha 0.25, p 1.5, e 0.9 on a floor too rough to slip on: whatever slip costs here, it costs for nothing.
void rocking(benchmark::State& state, Set set, Slip slip, bool vertical) {
    RockingBlock const block{
        .alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9, .friction_static = 1.3, .friction_kinetic = 1.3};
    std::vector<double> const calm(wave(set).size(), 0.0);
    auto const levels = set == Set::a ? testing::levels_a() : testing::levels_b();
    for (auto _ : state) {
        for (double const level : levels) {
            Excitation shaking{.horizontal_mps2 = wave(set), .vertical_mps2 = {}, .time_step_s = 0.01, .scale = level};
            if (vertical) {
                shaking.vertical_mps2 = calm;
            }
            auto const out = simulate_rocking(block, shaking, {}, {}, nullptr, slip);
            benchmark::DoNotOptimize(out.peak_rotation_rad);
        }
    }
    state.counters["us_per_trajectory"] =
        benchmark::Counter(1e-6 * static_cast<double>(state.iterations() * static_cast<std::int64_t>(levels.size())),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Type A's geometry at 100 levels from rest to overturning: friction 0.72 lets only the strongest slip.
void choosing(benchmark::State& state, EffectRequest const& request) {
    RigidBody const body({.mass_kg = 12.6e3,
                          .half_width_m = 0.68,
                          .centre_height_m = 1.045,
                          .inertia_kgm2 = 12.6e3 * (0.68 * 0.68 + 1.045 * 1.045) / 3});
    Scene const scene{body, Friction{0.72, 0.72}};
    ModelSelector const selector(request);
    GroundMotion motion;
    motion.time_step_s = 0.01;
    motion.horizontal_mps2 = wave(Set::b);
    ChunkExtremes const chunks(motion.horizontal_mps2, {});
    std::vector<SceneTrial> trials;
    for (double level = 4; level < 10; level += 0.06) {
        trials.push_back({scene, motion, level, 1.0, &chunks});
    }
    std::vector<Response> responses(trials.size());
    for (auto _ : state) {
        benchmark::DoNotOptimize(selector.respond(trials, responses));
    }
    std::int64_t slipped = 0;
    for (auto const& response : responses) {
        slipped += response.peak_slip_m > 0 ? 1 : 0;
    }
    auto const count = static_cast<double>(trials.size());
    state.counters["us_per_trial"] = benchmark::Counter(1e-6 * static_cast<double>(state.iterations()) * count,
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["slipping_share"] = static_cast<double>(slipped) / count;
}

BENCHMARK_CAPTURE(rocking, plain / set_a, Set::a, Slip::ignored, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, slip_detected / set_a, Set::a, Slip::detected, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, slip_forced / set_a, Set::a, Slip::simulated, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, zero_vertical / set_a, Set::a, Slip::ignored, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, plain / set_b, Set::b, Slip::ignored, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, slip_detected / set_b, Set::b, Slip::detected, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, slip_forced / set_b, Set::b, Slip::simulated, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rocking, zero_vertical / set_b, Set::b, Slip::ignored, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choosing, automatic, EffectRequest{EffectMode::automatic, 0})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choosing, forced, EffectRequest{EffectMode::forced, mask_of(Effect::sliding)})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overturn

BENCHMARK_MAIN();
