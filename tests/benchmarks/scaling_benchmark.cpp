// Cost over three decades of samples, periods and waves: each counter is per unit, so a linear cost is a constant one.
// And a whole campaign: trials a second, and where the time goes. Figures are for people: nothing here asserts.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "campaign/block_rows.hpp"
#include "campaign/trial.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"
#include "support/campaigns.hpp"
#include "support/long_period_wave.hpp"

namespace overturn {
namespace {

// The wave of set A over and over, so that every length has the same content.
std::vector<double> wave_of(std::int64_t samples) {
    static auto const once = testing::filtered_wave(testing::set_a);
    std::vector<double> wave(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = once[i % once.size()];
    }
    return wave;
}

void per_unit(benchmark::State& state, char const* name, double factor) {
    state.counters[name] =
        benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(state.range(0)) / factor,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
constexpr double nano = 1e9;
constexpr double micro = 1e6;

void samples_of_a_spectrum(benchmark::State& state) {
    auto const wave = wave_of(state.range(0));
    auto const periods = log_periods(0.02, 20, 200);
    for (auto _ : state) {
        benchmark::DoNotOptimize(displacement_spectrum(wave, 0.01, periods, 0.05));
    }
    per_unit(state, "ns_per_sample", nano);
}

void samples_of_window_energy(benchmark::State& state) {
    auto const wave = wave_of(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(window_energy(wave, 0.01, {0.5, 5}));
    }
    per_unit(state, "ns_per_sample", nano);
}

void periods_of_a_spectrum(benchmark::State& state) {
    auto const wave = wave_of(16384);
    auto const periods = log_periods(0.02, 20, static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(displacement_spectrum(wave, 0.01, periods, 0.05));
    }
    per_unit(state, "us_per_period", micro);
}

// 24 levels for each of two bodies on waves of 81.92 s that are all matched: everything but the disk.
CampaignSpec campaign_of(std::int64_t waves) {
    return testing::campaign_from("[waves]\nsource='spectrum-compatible'\nmatch='each'\nduration='81.92 s'\ncount="
                                  + std::to_string(waves)
                                  + "\n[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\n"
                                    "[waves.envelope]\nshape='jennings'\nrise='6 s'\nlevel_end='40 s'\nend='75 s'\n"
                                  + testing::type_a + testing::type_b
                                  + testing::levels("values={from=2.5,to=14,count=24}\n"));
}

void waves_of_a_campaign(benchmark::State& state) {
    auto const spec = campaign_of(state.range(0));
    Plan const plan(spec);
    PhaseSeconds seconds;
    for (auto _ : state) {
        for (std::int64_t block = 0; block < plan.blocks(); ++block) {
            benchmark::DoNotOptimize(run_block(spec, plan, block, seconds));
        }
    }
    per_unit(state, "us_per_wave", micro);
    double const all = seconds.waves + seconds.measures + seconds.response;
    state.counters["waves_share"] = seconds.waves / all;
    state.counters["measures_share"] = seconds.measures / all;
    state.counters["response_share"] = seconds.response / all;
    state.counters["trials_per_s"] = static_cast<double>(plan.trials()) * static_cast<double>(state.iterations()) / all;
}

BENCHMARK(samples_of_a_spectrum)->Name("scaling/spectrum/samples")->RangeMultiplier(10)->Range(1000, 1000000);
BENCHMARK(samples_of_window_energy)->Name("scaling/window_energy/samples")->RangeMultiplier(10)->Range(1000, 1000000);
BENCHMARK(periods_of_a_spectrum)->Name("scaling/spectrum/periods")->RangeMultiplier(10)->Range(10, 10000);
BENCHMARK(waves_of_a_campaign)->Name("scaling/campaign/waves")->RangeMultiplier(10)->Range(1, 1000)->Iterations(1);

}  // namespace
}  // namespace overturn
