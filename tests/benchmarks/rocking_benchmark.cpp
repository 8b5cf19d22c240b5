// Planar rocking: our lanes and our lane alone beside Boost.odeint and RK4, on the same waves in the same run.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmarks/peers.hpp"
#include "model/chunk_extremes.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/long_period_wave.hpp"

namespace overturn {
namespace {

RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};

// 24 levels of one wave, and what a far tighter integration makes of them.
struct Scenes {
    std::vector<double> wave, levels;
    ChunkExtremes chunks;
    std::vector<RockingTrial> trials;
    std::vector<RockingOutcome> reference;

    explicit Scenes(bool dense)
        : wave(testing::filtered_wave(dense ? testing::set_b : testing::set_a)),
          levels(dense ? testing::levels_b() : testing::levels_a()),
          chunks(wave, {}) {
        RockingAccuracy const tight{.taylor_order = 12, .substeps = 16, .step_tolerance = 1e-15, .settle = 1e-8};
        for (double const level : levels) {
            trials.push_back({block,
                              {.horizontal_mps2 = wave,
                               .vertical_mps2 = {},
                               .time_step_s = 0.01,
                               .scale = level,
                               .peak_mps2 = 1,
                               .chunks = &chunks}});
            reference.push_back(simulate_rocking(block, trials.back().shaking, tight));
        }
    }
    static Scenes const& of(bool dense) {
        static Scenes const a(false);
        static Scenes const b(true);
        return dense ? b : a;
    }
};

void report(benchmark::State& state, Scenes const& scenes, std::vector<peers::Answer> const& answers) {
    double worst = 0;
    std::vector<double> errors;
    int flips = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        bool const falls = scenes.reference[i].verdict == Verdict::overturned;
        flips += falls != answers[i].overturned ? 1 : 0;
        if (scenes.reference[i].verdict == Verdict::rocked && !answers[i].overturned) {
            errors.push_back(std::abs(answers[i].peak_rad / scenes.reference[i].peak_rotation_rad - 1));
            worst = std::max(worst, errors.back());
        }
    }
    std::sort(errors.begin(), errors.end());
    auto const trajectories = static_cast<double>(state.iterations()) * static_cast<double>(answers.size());
    state.counters["us_per_trajectory"] =
        benchmark::Counter(1e-6 * trajectories, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["median_relative_error"] = errors.empty() ? 0 : errors[errors.size() / 2];
    state.counters["max_relative_error"] = worst;
    state.counters["wrong_verdicts"] = flips;
}

peers::Answer answer_of(RockingOutcome const& out) {
    return {out.verdict == Verdict::overturned, out.peak_rotation_rad};
}

void batched(benchmark::State& state, bool dense) {
    auto const& scenes = Scenes::of(dense);
    std::vector<RockingOutcome> outcomes(scenes.trials.size());
    for (auto _ : state) {
        simulate_rocking(scenes.trials, {}, Slip::ignored, outcomes);
        benchmark::DoNotOptimize(outcomes.data());
    }
    std::vector<peers::Answer> answers;
    for (auto const& out : outcomes) {
        answers.push_back(answer_of(out));
    }
    report(state, scenes, answers);
}

// A thousand trials at a time, as campaigns have them: the lanes' last trials no longer count.
void crowded(benchmark::State& state, bool dense) {
    auto const& scenes = Scenes::of(dense);
    std::vector<RockingTrial> trials;
    for (int i = 0; i < 40; ++i) {
        trials.insert(trials.end(), scenes.trials.begin(), scenes.trials.end());
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    for (auto _ : state) {
        simulate_rocking(trials, {}, Slip::ignored, outcomes);
        benchmark::DoNotOptimize(outcomes.data());
    }
    state.counters["us_per_trajectory"] =
        benchmark::Counter(1e-6 * static_cast<double>(state.iterations()) * static_cast<double>(trials.size()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Solve> void one_by_one(benchmark::State& state, bool dense, Solve solve) {
    auto const& scenes = Scenes::of(dense);
    std::vector<peers::Answer> answers(scenes.trials.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < answers.size(); ++i) {
            answers[i] = solve(scenes, i);
        }
        benchmark::DoNotOptimize(answers.data());
    }
    report(state, scenes, answers);
}

auto const scalar = [](Scenes const& s, std::size_t i) {
    return answer_of(simulate_rocking(block, s.trials[i].shaking));
};
auto const odeint = [](Scenes const& s, std::size_t i) {
    return peers::rock<peers::Dopri5>(block, s.wave, 0.01, s.levels[i]);
};
auto const rk4 = [](Scenes const& s, std::size_t i) {
    return peers::rock<peers::Rk4>(block, s.wave, 0.01, s.levels[i]);
};

BENCHMARK_CAPTURE(batched, set_a, false)->Name("rocking/batched/set_a")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(crowded, set_a, false)->Name("rocking/batched_960/set_a")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_a, false, scalar)->Name("rocking/scalar/set_a")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_a, false, odeint)->Name("rocking/odeint/set_a")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_a, false, rk4)->Name("rocking/rk4/set_a")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(batched, set_b, true)->Name("rocking/batched/set_b")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(crowded, set_b, true)->Name("rocking/batched_960/set_b")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_b, true, scalar)->Name("rocking/scalar/set_b")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_b, true, odeint)->Name("rocking/odeint/set_b")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_by_one, set_b, true, rk4)->Name("rocking/rk4/set_b")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overturn
