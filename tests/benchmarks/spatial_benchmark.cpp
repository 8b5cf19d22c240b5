// Motion in space: what a 60 s trajectory costs alone and in lanes, never resting and resting, on four corners, on a
// continuous rim and on a flat bed; and with which error. Figures are for people: nothing here asserts.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

// Levels from scarcely rocking on, of 60 s at 10 ms, the second component at half the first.
struct SpatialScenes {
    SpatialBlock block;
    testing::TwoWaves waves;
    std::vector<double> transverse;
    std::vector<SpatialTrial> trials;

    SpatialScenes(Footing const& footing, double strongest)
        : block(testing::standing(testing::body_a(), footing, 0.8)), transverse(waves.y) {
        for (auto& value : transverse) {
            value *= 0.5;
        }
        for (int i = 0; i < 48; ++i) {
            trials.push_back({&block,
                              {.horizontal_mps2 = waves.x,
                               .transverse_mps2 = transverse,
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

void spatial_in_lanes(benchmark::State& state, Footing const& footing, double strongest, bool rest) {
    SpatialScenes const scenes(footing, strongest);
    std::vector<SpatialOutcome> outcomes(scenes.trials.size());
    for ([[maybe_unused]] auto _ : state) {
        simulate_spatial(scenes.trials, {.rest_gate = rest}, outcomes);
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
BENCHMARK_CAPTURE(spatial_in_lanes, corners, testing::square_base(), 7, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_in_lanes, rim, testing::round_base(), 6, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_in_lanes, flat_bed, testing::square_base(0.1), 6, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_in_lanes, corners_of_a_campaign, testing::square_base(), 12, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_in_lanes, rim_of_a_campaign, testing::round_base(), 12, true)->Unit(benchmark::kMillisecond);

// Work against error of the step: peak rotation over alpha of what stands, against a sixteenth of the usual step.
void spatial_precision(benchmark::State& state, Footing const& footing, double strongest) {
    SpatialScenes const scenes(footing, strongest);
    double const step = 0.3 * std::pow(2.0, -static_cast<double>(state.range(0)));
    std::vector<SpatialOutcome> outcomes(scenes.trials.size());
    std::vector<SpatialOutcome> reference(scenes.trials.size());
    simulate_spatial(scenes.trials, {.step_ratio = 0.3 / 32, .rest_gate = false}, reference);
    for ([[maybe_unused]] auto _ : state) {
        simulate_spatial(scenes.trials, {.step_ratio = step, .rest_gate = false}, outcomes);
        benchmark::DoNotOptimize(outcomes.data());
    }
    std::vector<double> errors;
    double flips = 0;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        bool const fell = outcomes[i].verdict == Verdict::overturned;
        flips += fell != (reference[i].verdict == Verdict::overturned) ? 1 : 0;
        if (!fell) {
            errors.push_back(std::abs(outcomes[i].peak_rotation_ratio - reference[i].peak_rotation_ratio));
        }
    }
    std::sort(errors.begin(), errors.end());
    state.counters["error_median"] = errors.empty() ? 0 : errors[errors.size() / 2];
    state.counters["error_90"] = errors.empty() ? 0 : errors[errors.size() * 9 / 10];
    state.counters["flips"] = flips;
    per_trajectory(state, scenes.trials.size());
}
BENCHMARK_CAPTURE(spatial_precision, corners, testing::square_base(), 14)
    ->DenseRange(-1, 3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_precision, rim, testing::round_base(), 9)->DenseRange(-1, 3)->Unit(benchmark::kMillisecond);

void spatial_alone(benchmark::State& state, Footing const& footing) {
    SpatialScenes const scenes(footing, 7);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(
            simulate_spatial(scenes.block, scenes.trials.front().shaking, {.rest_gate = false}).peak_rotation_rad);
    }
    per_trajectory(state, 1);
}
BENCHMARK_CAPTURE(spatial_alone, corners, testing::square_base())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spatial_alone, rim, testing::round_base())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overturn
