/// What it costs to make one wave of 16384 samples that follows CH1 to 10 s, and where the time goes.
#include <benchmark/benchmark.h>

#include "core/allocation.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "spectra/named_targets.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr std::size_t samples = 16384;

bool const kept = (keep_freed_memory(), true);  // all benchmarks run as the program does

SpectrumMatcherInput input_for(double tolerance, char const* rule) {
    return {.target = config::find_entry(named_targets(), "mlit-ch1", "target").value({}),
            .samples = samples,
            .envelope = {.shape = EnvelopeShape::jennings, .rise_s = 10, .level_end_s = 60, .end_s = 110},
            .tolerance = tolerance,
            .rule = config::find_entry(acceptance_rules(), rule, "rule").value};
}

void count(benchmark::State& state, double waves) {
    state.counters["us_per_wave"] =
        benchmark::Counter(waves * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void match(benchmark::State& state, double tolerance, char const* rule) {
    SpectrumMatcher const matcher(input_for(tolerance, rule));
    std::uint64_t wave = 0;
    double iterations = 0;
    for ([[maybe_unused]] auto _ : state) {
        auto const made = matcher.make(2013, wave++, 0);
        iterations += made.match.iterations;
        benchmark::DoNotOptimize(made.acceleration_mps2.data());
    }
    count(state, static_cast<double>(state.iterations()));
    state.counters["iterations"] = iterations / static_cast<double>(wave);
}
BENCHMARK_CAPTURE(match, five_percent, 0.05, "none")->Name("match/five_percent");
BENCHMARK_CAPTURE(match, two_percent, 0.02, "none")->Name("match/two_percent");
BENCHMARK_CAPTURE(match, srp, 0.05, "srp-3.7.1")->Name("match/srp-3.7.1");

struct Parts {
    NoiseLines noise{
        {.target = input_for(0.05, "none").target, .samples = samples, .envelope = input_for(0.05, "none").envelope}};
    std::vector<double> periods = log_periods_per_decade(0.02, 10, 100);
    Lines lines;
    std::vector<double> wave;

    Parts() {
        lines = noise.draw(LineStreams::of_wave(1, 1, 0));
        wave = noise.synthesise(lines, noise.envelope());
    }
};

void draw(benchmark::State& state) {
    Parts const parts;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(parts.noise.draw(LineStreams::of_wave(1, 1, 0)).data());
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(draw)->Name("match/draw");

void synthesise(benchmark::State& state) {
    Parts const parts;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(parts.noise.synthesise(parts.lines, parts.noise.envelope()).data());
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(synthesise)->Name("match/synthesise");

void sweep(benchmark::State& state) {
    Parts const parts;
    PeakResponse const response(log_periods_per_decade(0.02, 10, 67), 0.05,
                                0.01);  // about as many as iteration looks at
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(response.peaks(parts.wave).data());
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(sweep)->Name("match/sweep");

void gains(benchmark::State& state) {
    Parts const parts;
    auto const periods = log_periods_per_decade(0.02, 10, 67);
    auto const peaks = PeakResponse(periods, 0.05, 0.01).peaks(parts.wave);
    LineGains const step(periods, 0.05, parts.noise.spacing_radps(), parts.noise.first(), parts.noise.count());
    std::vector<double> const ones(periods.size(), 1.0);
    std::vector<double> const wanted(periods.size(), 1.01);
    for ([[maybe_unused]] auto _ : state) {
        auto lines = parts.lines;
        step.apply(lines, peaks, ones, wanted, LineGains::Trust::much);
        benchmark::DoNotOptimize(lines.data());
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(gains)->Name("match/gains");

void judge(benchmark::State& state) {
    Parts const parts;
    PeakResponse const all(parts.periods, 0.05, 0.01);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(all.peaks(parts.wave).data());
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(judge)->Name("match/judge");

void power(benchmark::State& state) {
    Parts const parts;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(parts.noise.lowest_power(parts.wave));
    }
    count(state, static_cast<double>(state.iterations()));
}
BENCHMARK(power)->Name("match/power");

}  // namespace
}  // namespace overturn
