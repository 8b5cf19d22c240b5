// Spectra and window energies beside the plain way to the same numbers, on one wave of 16384 samples; and the store.
#include <cmath>
#include <complex>
#include <filesystem>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/units.hpp"
#include "spectra/detail/window_sweep.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"
#include "store/shards.hpp"
#include "support/long_period_wave.hpp"
#include "support/temporary_folder.hpp"

namespace overturn {
namespace {

constexpr double step_s = 0.01;
constexpr double damping = 0.05;
constexpr std::size_t period_count = 200;

std::vector<double> const& wave() {
    static auto const made = testing::filtered_wave(testing::set_a);
    return made;
}
std::vector<double> const& periods() {
    static auto const made = log_periods(0.02, 20, period_count);
    return made;
}

// The exact step for acceleration linear within samples (Nigam & Jennings 1969), one oscillator after the other.
double plain_peak(OscillatorStep const& c) {
    double y = 0;
    double v = 0;
    double peak = 0;
    for (std::size_t n = 1; n < wave().size(); ++n) {
        double const next = c.yy * y + c.yv * v + c.ya0 * wave()[n - 1] + c.ya1 * wave()[n];
        v = c.vy * y + c.vv * v + c.va0 * wave()[n - 1] + c.va1 * wave()[n];
        y = next;
        peak = std::max(peak, std::abs(y));
    }
    return peak;
}

// |int a exp(-iwt) dt| of straight lines between samples, summed in long double.
double exact_energy_velocity(double w) {
    using Number = std::complex<long double>;
    long double const h = step_s;
    Number const turn(std::cos(w * h), -std::sin(w * h));
    Number const iw(0, w);
    Number sum = 0;
    for (std::size_t n = 1; n < wave().size(); ++n) {
        long double const t = static_cast<long double>(n - 1) * h;
        Number const phase(std::cos(w * t), -std::sin(w * t));
        long double const a0 = wave()[n - 1];
        long double const slope = (wave()[n] - a0) / h;
        // int_0^h (a0 + slope s) exp(-iws) ds
        sum += phase * (a0 * (1.0L - turn) / iw + slope * ((1.0L - turn) / (iw * iw) - h * turn / iw));
    }
    return static_cast<double>(std::abs(sum));
}

void count(benchmark::State& state, double error) {
    state.counters["us_per_wave"] = benchmark::Counter(static_cast<double>(state.iterations()) * 1e-6,
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["max_relative_error"] = error;
}

double largest_error(std::vector<double> const& found, std::vector<double> const& exact) {
    double largest = 0;
    double const scale = *std::max_element(exact.begin(), exact.end());
    for (std::size_t i = 0; i < found.size(); ++i) {
        largest = std::max(largest, std::abs(found[i] - exact[i]) / scale);
    }
    return largest;
}

void undamped(benchmark::State& state) {
    std::vector<double> exact;
    for (double const period : periods()) {
        exact.push_back(exact_energy_velocity(2 * pi / period));
    }
    std::vector<double> found;
    for ([[maybe_unused]] auto _ : state) {
        found = undamped_energy_velocities(wave(), step_s, periods());
        benchmark::DoNotOptimize(found.data());
    }
    count(state, largest_error(found, exact));
}
BENCHMARK(undamped)->Name("spectrum/undamped_energy/ours");

std::vector<double> plain_spectrum() {
    std::vector<double> peaks;
    for (double const period : periods()) {
        peaks.push_back(plain_peak(OscillatorStep(2 * pi / period, damping, step_s)));
    }
    return peaks;
}

void response(benchmark::State& state) {
    auto const exact = plain_spectrum();
    std::vector<double> found;
    for ([[maybe_unused]] auto _ : state) {
        found = displacement_spectrum(wave(), step_s, periods(), damping, {.points_per_period = 0});
        benchmark::DoNotOptimize(found.data());
    }
    count(state, largest_error(found, exact));
}
BENCHMARK(response)->Name("spectrum/response/ours");

void response_plain(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(plain_spectrum().data());
    }
    count(state, 0);
}
BENCHMARK(response_plain)->Name("spectrum/response/plain_nigam_jennings");

PeriodBand const band{.t0_s = 0.55, .t1_s = 5.5};

void window(benchmark::State& state) {
    WindowEnergy found;
    for ([[maybe_unused]] auto _ : state) {
        found = window_energy(wave(), step_s, band);
        benchmark::DoNotOptimize(&found);
    }
    auto finer = WindowOptions{};
    finer.panel_phase_rad = 5;
    count(state, std::abs(found.v_wes_max_mps / window_energy(wave(), step_s, band, finer).v_wes_max_mps - 1));
}
BENCHMARK(window)->Name("window_energy/both/ours");

// Another body's band on the same wave, right after the first body's.
void second_body(benchmark::State& state) {
    PeriodBand const other{.t0_s = 0.533, .t1_s = 5.33};
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        benchmark::DoNotOptimize(window_energy(wave(), step_s, band));
        state.ResumeTiming();
        benchmark::DoNotOptimize(window_energy(wave(), step_s, other));
    }
    auto finer = WindowOptions{};
    finer.panel_phase_rad = 5;
    count(state, std::abs(window_energy(wave(), step_s, other).v_wes_max_mps
                              / window_energy(wave(), step_s, other, finer).v_wes_max_mps
                          - 1));
}
BENCHMARK(second_body)->Name("window_energy/second_body/ours");

void whole(benchmark::State& state) {
    double found = 0;
    for ([[maybe_unused]] auto _ : state) {
        found = overturning_energy_velocity(wave(), step_s, band);
        benchmark::DoNotOptimize(found);
    }
    count(state, std::abs(found / overturning_energy_velocity(wave(), step_s, band, 5) - 1));
}
BENCHMARK(whole)->Name("window_energy/ou_v_e/ours");

void window_plain(benchmark::State& state) {
    auto const samples = static_cast<std::size_t>(std::llround(band.t1_s / step_s));
    WindowOptions const options;
    for ([[maybe_unused]] auto _ : state) {
        auto const rule = band_rule(band, 2 * band.t1_s, options.panel_phase_rad);
        benchmark::DoNotOptimize(swept_window_squares(wave(), step_s, samples, rule, options.reading).data());
    }
    count(state, 0);
}
BENCHMARK(window_plain)->Name("window_energy/v_wes/swept_oscillators");

// One block as campaigns of long waves write it: 64 kB, durable, with its checksum.
void store_block(benchmark::State& state) {
    testing::TemporaryFolder const folder;
    store::ShardFolder const shards(folder / "c.h5", std::string(64, 'a'));
    shards.begin("campaign");
    std::vector<std::byte> const rows(std::size_t{1} << 16U);
    std::int64_t block = 0;
    for ([[maybe_unused]] auto _ : state) {
        shards.commit(block++ % 64, rows);
    }
    state.counters["us_per_block"] = benchmark::Counter(static_cast<double>(state.iterations()) * 1e-6,
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(store_block)->Name("store/commit_block")->UseRealTime();

}  // namespace
}  // namespace overturn
