// Contact: what a 60 s trajectory costs alone and in lanes, never resting and resting, on corners and on a flat bed;
// and what matching a base costs. Figures are for people: nothing here asserts.
#include <vector>

#include <benchmark/benchmark.h>

#include "contact/cases.hpp"
#include "contact/matching.hpp"
#include "support/long_period_wave.hpp"

namespace overturn {
namespace {

// Levels from scarcely rocking on, of 60 s at 10 ms; none falls, so none ends early.
struct ContactScenes {
    ContactBlock block;
    std::vector<double> wave;
    std::vector<ContactTrial> trials;

    ContactScenes(BasePlan const& base, double strongest)
        : block(contact_block(testing::body_a(), base, {}, Friction{0.8, 0.8})),
          wave(testing::filtered_wave(testing::set_b)) {
        wave.resize(6001);
        for (int i = 0; i < 48; ++i) {
            trials.push_back({&block,
                              {.horizontal_mps2 = wave,
                               .vertical_mps2 = {},
                               .time_step_s = 0.01,
                               .scale = strongest * (0.5 + i / 96.0)}});
        }
    }
};

void per_trajectory(benchmark::State& state, std::size_t trajectories) {
    state.counters["us_per_trajectory"] =
        benchmark::Counter(1e-6 * static_cast<double>(state.iterations()) * static_cast<double>(trajectories),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void contact_in_lanes(benchmark::State& state, BasePlan const& base, bool rest) {
    ContactScenes const scenes(base, rest ? 12 : 7);
    std::vector<ContactOutcome> outcomes(scenes.trials.size());
    for ([[maybe_unused]] auto _ : state) {
        simulate_contact(scenes.trials, {.rest_gate = rest}, outcomes);
        benchmark::DoNotOptimize(outcomes.data());
    }
    double steps = 0;
    double fell = 0;
    for (auto const& outcome : outcomes) {
        steps += static_cast<double>(outcome.steps) / static_cast<double>(outcomes.size());
        fell += outcome.verdict == Verdict::overturned ? 1 : 0;
    }
    state.counters["steps"] = steps;
    state.counters["fell"] = fell;
    per_trajectory(state, scenes.trials.size());
}
BENCHMARK_CAPTURE(contact_in_lanes, corners, BasePlan{}, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_in_lanes, flat_bed, testing::flat_bed(), false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_in_lanes, corners_of_a_campaign, BasePlan{}, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_in_lanes, flat_bed_of_a_campaign, testing::flat_bed(), true)->Unit(benchmark::kMillisecond);

void contact_alone(benchmark::State& state, BasePlan const& base) {
    ContactScenes const scenes(base, 7);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(
            simulate_contact(scenes.block, scenes.trials.front().shaking, {.rest_gate = false}).peak_rotation_rad);
    }
    per_trajectory(state, 1);
}
BENCHMARK_CAPTURE(contact_alone, corners, BasePlan{})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_alone, flat_bed, testing::flat_bed())->Unit(benchmark::kMillisecond);

void contact_match(benchmark::State& state) {
    RigidBody const body({.mass_kg = 12.6e3,
                          .half_width_m = 0.68,
                          .centre_height_m = 1.045,
                          .inertia_kgm2 = 12.6e3 * (0.68 * 0.68 + 1.045 * 1.045) / 3,
                          .restitution = 0.7});
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(match_restitution(body, {}, {}).restitution);
    }
}
BENCHMARK(contact_match)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overturn
