// Requirement R-1002: whatever is computed in lanes is the same, bit for bit, on every instruction set. (Rocking:
// rocking/lanes.)
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "generators/detail/line_sums.hpp"
#include "simd/instruction_sets.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/detail/direct_sums.hpp"
#include "spectra/detail/oscillator_sweep.hpp"
#include "spectra/detail/smoothing.hpp"
#include "spectra/detail/window_sweep.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr double step_s = 0.01;

std::vector<double> wave(std::size_t samples) {
    std::vector<double> values(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        auto const t = static_cast<double>(i);
        values[i] = 3 * std::sin(0.013 * t) * std::sin(0.31 * t + std::sin(0.007 * t));
    }
    return values;
}

std::vector<double> periods() { return log_periods(0.02, 10, 41); }  // not a multiple of the lanes

std::vector<double> appended(std::vector<double> values, std::vector<double> const& more) {
    values.insert(values.end(), more.begin(), more.end());
    return values;
}

std::vector<double> window_squares(WindowReading reading) {
    auto const rule = band_rule(rocking_period_band(2.5, RadiusUnit::centimetre), 10, 20);
    return swept_window_squares(wave(1000), step_s, 300, rule, reading);
}

std::vector<double> swept(SweepForm form, std::size_t stride) {
    OscillatorGroup group;
    group.form = form;
    group.stride = stride;
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        double const w = 2 * pi / (0.2 + 0.03 * static_cast<double>(lane));
        group.set(lane, w, 0.05, OscillatorStep(w, 0.05, step_s), step_s);
    }
    SweepTiles blocks;
    sweep(group, wave(777), blocks);
    return appended(blocks.value, {blocks.highest.begin(), blocks.highest.end()});
}

std::vector<double> line_sums() {
    std::vector<std::complex<double>> lines;
    for (double const value : wave(200)) {
        lines.emplace_back(value, value * value - 1);
    }
    LineOscillators oscillators{};
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        auto const x = static_cast<float>(lane);
        oscillators.frequency.at(lane) = 3 + 5 * x;
        oscillators.twice_damped.at(lane) = 0.3F + 0.5F * x;
        oscillators.turn_cos.at(lane) = std::cos(0.1F * x);
        oscillators.turn_sin.at(lane) = std::sin(0.1F * x);
        oscillators.start_cos.at(lane) = std::cos(0.2F * x);
        oscillators.start_sin.at(lane) = std::sin(0.2F * x);
    }
    std::vector<std::size_t> const band_end{10, 50, 200};
    std::vector<float> sums(band_end.size() * simd::sweep_lanes);
    sum_lines(lines, band_end, 2, oscillators, sums);
    return {sums.begin(), sums.end()};
}

struct Kernel {
    char const* name;
    std::function<std::vector<double>()> values;
};

class Kernels : public testing::TestWithParam<Kernel> {};

TEST_P(Kernels, InstructionSetsAgreeToTheLastBit) {
    auto const native = GetParam().values();
    ASSERT_FALSE(native.empty());
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        EXPECT_EQ(GetParam().values(), native) << simd::name_of(set);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Sweeps, Kernels,
    testing::Values(Kernel{"energy", [] { return input_energy_velocities(wave(1000), step_s, periods(), 0.05); }},
                    Kernel{"response",
                           [] {
                               auto const all = response_spectrum(wave(1000), step_s, periods(), 0.05, {});
                               return appended(appended(all.sd_m, all.sv_mps), all.sa_mps2);
                           }},
                    Kernel{"restarted_window", [] { return window_squares(WindowReading::restarted); }},
                    Kernel{"running_window", [] { return window_squares(WindowReading::running); }},
                    Kernel{"direct_sums",
                           [] {
                               std::vector<double> parts;
                               for (auto const& sum : direct_sums(wave(1000), periods())) {
                                   parts.insert(parts.end(), {sum.real(), sum.imag()});
                               }
                               return parts;
                           }},
                    Kernel{"smoothing",
                           [] {
                               std::vector<double> smoothed(20);
                               smooth(wave(4 * simd::sweep_lanes), wave(300), 7, smoothed);
                               return smoothed;
                           }},
                    Kernel{"amplitude", [] { return swept(SweepForm::amplitude, 1); }},
                    Kernel{"samples", [] { return swept(SweepForm::samples, 1); }},
                    Kernel{"strided_by_2", [] { return swept(SweepForm::strided, 2); }},
                    Kernel{"strided_by_8", [] { return swept(SweepForm::strided, 8); }},
                    Kernel{"line_sums", &line_sums}),
    [](auto const& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace overturn
