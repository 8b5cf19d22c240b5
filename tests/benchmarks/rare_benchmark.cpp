// Rare events: what one wave of 4096 samples costs with its planar trial, plain and drawn from failure pulses with its
// weight, beside a campaign's own trial, measured and not. Figures are for people: nothing here asserts.
#include <vector>

#include <benchmark/benchmark.h>

#include "campaign/plan.hpp"
#include "campaign/rare_problem.hpp"
#include "campaign/trial.hpp"
#include "rare/detail/normals.hpp"
#include "rare/pulse_mixture.hpp"
#include "support/campaigns.hpp"
#include "support/rare_answer.hpp"

namespace overturn {
namespace {

// Drawn from a power spectral density; the body of the published comparisons of estimators.
std::string rare_campaign(std::string const& more) {
    return "[waves]\nsource='filtered-noise'\nrms='1 m/s2'\nmodel='clough-penzien'\nground_frequency='0.5 Hz'\n"
           "ground_damping=0.5\nfilter_frequency='0.1 Hz'\ncount=1000\nduration='40.95 s'\ntime_step='0.01 s'\n"
           "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
           "inertia='uniform-block'\nrestitution=0.85\n[levels]\nmeasure='factor'\nvalues=[1.0]\n"
           + more;
}

void plain_trial(benchmark::State& state) {
    auto const spec = testing::campaign_from(rare_campaign("[rare]\n"));
    RareProblem const problem(spec, 0);
    std::vector<double> normals(problem.normals());
    rare::DrawKey key{.seed = spec.seed, .phase = rare::Phase::crude};
    for ([[maybe_unused]] auto _ : state) {
        ++key.index;
        rare::draw_normals(key, normals);
        benchmark::DoNotOptimize(rare::respond_at(problem, normals, 1.0));
    }
}
BENCHMARK(plain_trial)->Name("rare/plain_trial")->Unit(benchmark::kMicrosecond);

// Eight pulses that push for a body period or so, wherever they come from: their cost is the same.
rare::Mixture mixture_of(RareProblem const& problem) {
    auto const frame = problem.frame().value();
    auto const grid = rare::Mixture::grid_of(frame);
    std::vector<rare::Pulse> pulses(8);
    for (std::size_t c = 0; c < pulses.size(); ++c) {
        pulses[c].share = 1.0 / 8;
        pulses[c].lines.assign(frame.lines, {0.02 * static_cast<double>(c + 1), 0.1});
        pulses[c].arrival.assign(grid, 1 / static_cast<double>(grid));
    }
    return {frame, std::move(pulses)};
}

void weighted_trial(benchmark::State& state) {
    auto const spec = testing::campaign_from(rare_campaign("[rare]\n"));
    RareProblem const problem(spec, 0);
    auto const mixture = mixture_of(problem);
    std::vector<double> normals(problem.normals());
    rare::DrawKey key{.seed = spec.seed, .phase = rare::Phase::final};
    for ([[maybe_unused]] auto _ : state) {
        ++key.index;
        (void)rare::draw_from(mixture, key, normals);
        benchmark::DoNotOptimize(mixture.weight(normals));
        benchmark::DoNotOptimize(rare::respond_at(problem, normals, 1.0));
    }
}
BENCHMARK(weighted_trial)->Name("rare/weighted_trial")->Unit(benchmark::kMicrosecond);

void campaign_trial(benchmark::State& state, char const* measures) {
    auto const spec = testing::campaign_from(rare_campaign(measures));
    Plan const plan(spec);
    PhaseSeconds seconds;
    std::int64_t wave = 0;
    for ([[maybe_unused]] auto _ : state) {
        auto const prepared = prepare_wave(spec, plan, wave++ % plan.waves(), seconds);
        benchmark::DoNotOptimize(run_trial(spec, prepared, 0, 0).rows.front());
    }
}
BENCHMARK_CAPTURE(campaign_trial, all, "")->Name("rare/campaign_trial_measured")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(campaign_trial, none, "[measures]\nenergy=false\nwave_quality=false\n")
    ->Name("rare/campaign_trial_unmeasured")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace overturn
