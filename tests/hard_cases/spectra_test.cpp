// Requirement: spectra, windows and intensities hold at the edges: extreme periods, damping, lengths,
// trivial waves.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/units.hpp"
#include "motion/ground_motion.hpp"
#include "motion/intensity.hpp"
#include "spectra/detail/fourier.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"
#include "support/fourier_amplitude.hpp"
#include "support/oscillator_history.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

using testing::near;

TEST(HardCases, PeriodFarBelowTheStepIsStiff) {
    auto const wave = testing::broad_wave(2000, 0.01);
    for (double const period : {1e-12, 1e-8, 1e-5}) {
        auto const spectrum = response_spectrum(wave, 0.01, std::array{period}, 0.05);
        EXPECT_NEAR(spectrum.psa_mps2[0], peak_of(wave), (1e-12 + 100 * period) * peak_of(wave)) << period;
    }
}

TEST(HardCases, PeriodFarAboveTheWaveFollowsTheGround) {
    auto const wave = testing::broad_wave(2000, 0.01);
    auto const ground = displacement_of(wave, 0.01);
    for (double const period : {1e6, 1e9, 1e12}) {
        auto const history = testing::oscillator_history(wave, 0.01, period, 0.05);
        for (std::size_t i = 0; i < ground.size(); ++i) {
            EXPECT_NEAR(history.displacement_m[i], -ground[i], (1e-12 + 100 / period) * peak_of(ground)) << period;
        }
    }
}

// A constant a from rest. Critical: y = -a/w^2 [1 - (1 + wt) exp(-wt)]; above: with d = w sqrt(z^2 - 1),
// y = -a/w^2 [1 - exp(-zwt) (cosh dt + z w sinh(dt)/d)]; undamped: y = -a/w^2 (1 - cos wt).
TEST(HardCases, DampingOfNoneCriticalAndAbove) {
    double const dt = 0.01;
    std::vector<double> const constant(1001, 1.0);
    for (double const period : {0.003, 0.05, 1.0, 30.0}) {
        double const w = 2 * pi / period;
        for (double const z : {0.0, 1 - 1e-9, 1.0, 1 + 1e-9, 1.5, 20.0, 1000.0}) {
            auto const history = testing::oscillator_history(constant, dt, period, z);
            for (std::size_t const i : {1U, 10U, 1000U}) {
                double const t = dt * static_cast<double>(i);
                double rest = std::cos(w * t);
                if (z > 1.1) {
                    double const fast = w * (z + std::sqrt(z * z - 1));
                    double const slow = w * w / fast;
                    rest = (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
                } else if (z > 0) {
                    rest = (1 + w * t) * std::exp(-w * t);
                }
                double const near_critical = std::abs(z - 1) < 1e-6 ? 1e-8 : 0;
                EXPECT_NEAR(history.displacement_m[i] * w * w, rest - 1, 1e-10 + near_critical)
                    << period << ' ' << z << ' ' << t;
            }
        }
    }
}

// Chords of sin(wt) hold w with the factor [sin(x/2)/(x/2)]^2, x = w dt, and no other resonant part: after a whole
// number n of periods y = t/(2w) times that factor, but for parts that do not grow.
TEST(HardCases, UndampedResonanceOverAMillionSteps) {
    constexpr std::size_t steps = 1000000;
    constexpr int per_period = 50;
    double const period = 1;
    double const dt = period / per_period;
    double const w = 2 * pi;
    std::vector<double> wave(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
        wave[i] = std::sin(2 * pi * static_cast<double>(i % per_period) / per_period);
    }
    auto const history = testing::oscillator_history(wave, dt, period, 0);
    double const x = w * dt;
    double const factor = std::pow(std::sin(0.5 * x) / (0.5 * x), 2);
    double const t = dt * steps;
    EXPECT_TRUE(near(history.displacement_m[steps], factor * t / (2 * w), {1e-9, "a million steps"}));
}

TEST(HardCases, MeansOverAMillionSamplesAgreeWithCompensatedSums) {
    constexpr std::size_t samples = 1000000;
    std::vector<double> values(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        auto const n = static_cast<double>(i);
        values[i] = 1 + 1e6 * std::abs(std::sin(n)) * (i % 3000 < 3);
    }
    for (std::size_t const count : {1U, 7U, 1000U, 300000U}) {
        auto const means = trailing_mean(values, count);
        for (std::size_t const end : {std::size_t{5}, std::size_t{99999}, std::size_t{654321}, samples - 1}) {
            double sum = 0;
            double carried = 0;
            for (std::size_t i = end + 1 > count ? end + 1 - count : 0; i <= end; ++i) {
                double const next = values[i] - carried;
                double const total = sum + next;
                carried = (total - sum) - next;
                sum = total;
            }
            EXPECT_TRUE(near(means[end], sum / static_cast<double>(count), {1e-11, "plain sums"})) << count;
        }
    }
}

TEST(HardCases, WindowsOfAMillionSamplesDoNotDrift) {
    // One piece again and again, as long as the window: what a window sees is the same after every piece.
    auto const band = rocking_period_band(1.2);
    double const dt = 0.02;
    auto const piece = static_cast<std::size_t>(std::round(band.t1_s / dt));
    auto const shape = testing::broad_wave(piece, dt);
    std::vector<double> wave(1000000);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = shape[i % piece];
    }
    // One panel of frequencies for the window; the whole wave, which is not looked at, would ask for ten thousand.
    auto const energy = window_energy(wave, dt, band, {.keep_history = true, .panel_phase_rad = 2000});
    double const largest = energy.v_wes_max_mps;
    ASSERT_GT(largest, 0);
    std::size_t const last = (wave.size() / piece - 1) * piece;
    for (std::size_t i = 0; i < piece; i += 17) {
        EXPECT_NEAR(energy.v_wes_mps[last + i], energy.v_wes_mps[2 * piece + i], 1e-11 * largest);
    }
}

TEST(HardCases, FourierSumOverAMillionSamplesIsTheSeriesSum) {
    // A constant from 0 to t: int exp(-iwt) dt = [sin wt - i (1 - cos wt)] / w.
    std::vector<double> const ones(1000001, 1.0);
    double const dt = 0.001;
    for (double const w : {0.0, 1e-6, 0.1, 10.0, 3000.0}) {
        auto const sum = testing::fourier_amplitude(ones, dt, w);
        double const t = dt * 1000000;
        double const re = w == 0 ? t : std::sin(w * t) / w;
        double const im = w == 0 ? 0 : -2 * std::pow(std::sin(0.5 * w * t), 2) / w;
        EXPECT_NEAR(sum.real(), re, 1e-12 * t) << w;
        EXPECT_NEAR(sum.imag(), im, 1e-12 * t) << w;
    }
}

TEST(HardCases, ConstantZeroOneAndTwoSamplesInEveryMeasure) {
    double const dt = 0.01;
    for (double const level : {0.0, 2.0}) {
        for (std::size_t const samples : {0U, 1U, 2U, 3000U}) {
            std::vector<double> const wave(samples, level);
            double const t = samples == 0 ? 0 : dt * static_cast<double>(samples - 1);
            auto const intensity = intensity_of(wave, dt);
            EXPECT_EQ(intensity.pga_mps2, samples == 0 ? 0 : level);
            EXPECT_NEAR(intensity.pgv_mps, level * t, 1e-11);
            EXPECT_NEAR(intensity.pgd_m, 0.5 * level * t * t, 1e-9);
            EXPECT_NEAR(intensity.arias_mps, pi / (2 * g0) * level * level * t, 1e-11);

            auto const spectrum = response_spectrum(wave, dt, std::array{0.1, 1.0}, 0.0);
            for (std::size_t i = 0; i < 2; ++i) {
                double const w = 2 * pi / spectrum.period_s[i];
                // A box that ends in a ramp of one step, about half a step longer, and the free vibration behind it:
                // twice the static answer where it lasts half a period, else 2 sin(w t / 2) (Chopra, Dynamics of
                // Structures, 4.7).
                double const box = samples == 0 ? 0 : t + 0.5 * dt;
                double const swing = box > 0.5 * spectrum.period_s[i] ? 2 : 2 * std::sin(0.5 * w * box);
                EXPECT_NEAR(spectrum.psa_mps2[i], level * swing, 0.05 * level) << samples;
            }

            auto const energy = window_energy(wave, dt, rocking_period_band(1.2));
            EXPECT_TRUE(std::isfinite(energy.ou_v_e_mps) && std::isfinite(energy.v_wes_max_mps));
            EXPECT_EQ(energy.ou_v_e_mps > 0, level > 0 && samples > 1) << samples << ' ' << level;
        }
    }
}

}  // namespace
}  // namespace overturn
