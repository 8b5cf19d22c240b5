// Requirement: ouV_E and V_WES are the integrals their definitions name, on waves of any length.
#include "spectra/window_energy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.hpp"
#include "spectra/detail/fourier.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

constexpr PeriodBand band{0.5, 5.0};

TEST(WindowEnergy, VelocityStepGivesItself) {
    std::vector<double> pulse(2000, 0.0);
    pulse[700] = 1;  // a triangle of 2 x 1e-5 s: 1e-5 m/s
    WindowOptions const plain{.smoothed = false};

    auto const energy = window_energy(pulse, 1e-5, band, plain);

    EXPECT_TRUE(near(energy.ou_v_e_mps, 1e-5, testing::Tolerance{1e-8, "(w dt)^2"}));
    EXPECT_TRUE(near(energy.v_wes_max_mps, 1e-5, testing::Tolerance{1e-8, "(w dt)^2"}));
}

TEST(WindowEnergy, QuadratureResolvesTheLengthOfTheWave) {
    auto const wave = testing::broad_wave(12001, 0.01);
    auto const reference = overturning_energy_velocity(wave, 0.01, band, 4);

    EXPECT_TRUE(near(overturning_energy_velocity(wave, 0.01, band), reference, exact_formula));
    EXPECT_TRUE(near(overturning_energy_velocity(wave, 0.01, band, 30), reference, testing::Tolerance{1e-7, "coarse"}));
}

// The reference integrates over T on its own: the midpoint rule in T with very many points.
TEST(WindowEnergy, WholeWaveEqualsTheDefinition) {
    auto const wave = testing::broad_wave(1501, 0.01);
    constexpr int n = 20000;
    std::vector<double> frequencies;
    std::vector<double> weights;
    for (int i = 0; i < n; ++i) {
        double const period = 0.5 + 4.5 * (i + 0.5) / n;
        frequencies.push_back(2 * pi / period);
        weights.push_back(2 * (5.0 - period) / (4.5 * 4.5) * 4.5 / n);
    }
    auto const amplitudes = fourier_amplitudes(wave, 0.01, frequencies);
    double sum = 0;
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        sum += weights[i] * std::norm(amplitudes[i]);
    }

    EXPECT_TRUE(
        near(overturning_energy_velocity(wave, 0.01, band), std::sqrt(sum), testing::Tolerance{1e-6, "midpoint"}));
    EXPECT_TRUE(near(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, exact_formula));
}

class Readings : public ::testing::TestWithParam<WindowReading> {};
INSTANTIATE_TEST_SUITE_P(Both, Readings, ::testing::Values(WindowReading::restarted, WindowReading::running),
                         [](auto const& one) { return one.param == WindowReading::running ? "running" : "restarted"; });

TEST_P(Readings, WindowAsLongAsTheWaveEndsAtTheWholeMeasure) {
    auto const wave = testing::broad_wave(480, 0.01);

    auto const energy =
        window_energy(wave, 0.01, band, {.reading = GetParam(), .smoothed = false, .keep_history = true});

    EXPECT_TRUE(near(energy.v_wes_mps[wave.size() - 1], energy.ou_v_e_mps, exact_formula));
}

/// A wave that ends while strong offers its energy to a body that swings on: quiet appended to it changes nothing.
TEST_P(Readings, QuietAfterTheWaveChangesNothing) {
    auto const measured = [](std::vector<double> wave, std::size_t quiet) {
        wave.resize(wave.size() + quiet, 0.0);
        return window_energy(wave, 0.01, band, {.reading = GetParam()});
    };
    std::vector<double> sine(100);
    for (std::size_t n = 0; n < sine.size(); ++n) {
        sine[n] = 4 * std::sin(2 * pi * 0.01 * static_cast<double>(n));
    }
    for (auto const& wave : {sine, std::vector<double>(30, 2.0), testing::broad_wave(777, 0.01)}) {
        auto const bare = measured(wave, 0);
        for (std::size_t const quiet : {1U, 40U, 3000U}) {
            auto const padded = measured(wave, quiet);
            EXPECT_TRUE(near(padded.v_wes_max_mps, bare.v_wes_max_mps, exact_formula)) << quiet;
        }
    }
    // Shorter than T0 or T1 its whole energy lies in one window for the length of the mean: V_WES is all of it.
    auto const bare = measured(sine, 0);
    sine.push_back(0);  // the way back to quiet
    EXPECT_TRUE(near(bare.v_wes_max_mps, overturning_energy_velocity(sine, 0.01, band), exact_formula));
}

TEST_P(Readings, LongWaveEqualsDirectlySummedWindows) {
    auto wave = testing::broad_wave(120001, 0.01);
    for (std::size_t n = 3000; n < 6000; ++n) {
        wave[n] *= 1e3;  // running totals would carry this burst's rounding to the end
    }

    auto const energy =
        window_energy(wave, 0.01, band, {.reading = GetParam(), .smoothed = false, .keep_history = true});

    for (std::size_t const end : {1U, 250U, 500U, 501U, 999U, 1000U, 7123U, 60499U, 120000U}) {
        std::size_t const begin = end > 500 ? end - 500 : 0;
        auto const window = std::span(wave).subspan(begin, end - begin + 1);
        double const whole = overturning_energy_velocity(window, 0.01, band);
        double expected = whole * whole;
        // V_WES is exact to the rounding of what is strongest within ten windows.
        auto const history = std::span(energy.v_wes_mps);
        std::size_t const from = end > 5000 ? end - 5000 : 0;
        auto const near_by = history.subspan(from, std::min(end + 5000, history.size()) - from);
        double const strongest = *std::ranges::max_element(near_by);
        double scale = strongest * strongest;
        if (GetParam() == WindowReading::running) {
            double const now = overturning_energy_velocity(std::span(wave).first(end + 1), 0.01, band);
            double const then = overturning_energy_velocity(std::span(wave).first(begin + 1), 0.01, band);
            expected = std::max(0.0, now * now - then * then);
            scale = now * now;
        }
        double const computed = energy.v_wes_mps[end] * energy.v_wes_mps[end];
        EXPECT_TRUE(near(computed, expected, exact_formula, scale)) << end;
    }
}

TEST(WindowEnergy, IsLinearInAmplitude) {
    auto const wave = testing::broad_wave(4000, 0.01);
    auto tripled = wave;
    for (double& a : tripled) {
        a *= 3;
    }

    auto const one = window_energy(wave, 0.01, band);
    auto const three = window_energy(tripled, 0.01, band);

    EXPECT_TRUE(near(three.v_wes_max_mps, 3 * one.v_wes_max_mps, exact_formula));
    EXPECT_TRUE(near(three.ou_v_e_mps, 3 * one.ou_v_e_mps, exact_formula));
    EXPECT_EQ(three.v_wes_time_s, one.v_wes_time_s);
    EXPECT_GT(one.v_wes_time_s, 0);
}

/// A history ends when window and mean have left the wave, not before.
TEST_P(Readings, HistoryRunsUntilNothingIsLeft) {
    auto const wave = testing::broad_wave(1000, 0.01);
    auto const energy = window_energy(wave, 0.01, band, {.reading = GetParam(), .keep_history = true});

    ASSERT_EQ(energy.v_wes_mps.size(), 1000U + 500 + 50) << "T1 and T0 after the last sample";
    EXPECT_LT(energy.v_wes_mps.back(), 1e-6 * energy.v_wes_max_mps);
    EXPECT_GT(energy.v_wes_mps[1000 + 500], 1e-4 * energy.v_wes_max_mps) << "the mean still holds what was";
}

TEST(WindowEnergy, SmoothingIsATrailingMean) {
    std::vector<double> values(103);
    std::iota(values.begin(), values.end(), 1.0);

    auto const means = trailing_mean(values, 10);

    EXPECT_DOUBLE_EQ(means[0], 0.1);
    EXPECT_DOUBLE_EQ(means[9], 5.5);
    for (std::size_t n = 10; n < values.size(); ++n) {
        EXPECT_DOUBLE_EQ(means[n], values[n] - 4.5);
    }
}

// Property: the mean runs over T0, whatever the time step: 50 samples of 0.01 s, 25 of 0.02 s, and 34 where T0 is 33.6.
TEST_P(Readings, SmoothingRunsOverT0) {
    struct Case {
        double time_step_s, t0_s;
        std::size_t samples;
    };
    for (auto const& [time_step_s, t0_s, samples] : {Case{0.01, 0.5, 50}, Case{0.02, 0.5, 25}, Case{0.01, 0.336, 34}}) {
        auto const wave = testing::broad_wave(3000, 0.01);
        auto const measured = [&, step = time_step_s, from = t0_s](bool smoothed) {
            return window_energy(wave, step, {from, 5.0},
                                 {.reading = GetParam(), .smoothed = smoothed, .keep_history = true})
                .v_wes_mps;
        };
        auto const smoothed = measured(true);
        auto const means = trailing_mean(measured(false), samples);

        ASSERT_EQ(smoothed.size(), means.size());
        double const strongest = *std::ranges::max_element(means);
        for (std::size_t n = 0; n < means.size(); ++n) {
            ASSERT_TRUE(near(smoothed[n], means[n], exact_formula, strongest)) << n;
        }
    }
}

TEST(WindowEnergy, BandOfTypeABody) {
    auto const cm = rocking_period_band(1.2468);
    EXPECT_TRUE(near(cm.t1_s, 5 * std::sqrt(1.2468), exact_formula));
    EXPECT_TRUE(near(cm.t1_s, 10 * cm.t0_s, exact_formula));
    EXPECT_TRUE(near(rocking_period_band(4, RadiusUnit::metre).t1_s, 1.0, exact_formula));
}

// Where gravity is four times as strong a body rocks twice as quickly, and where it is Earth's the band is the paper's.
TEST(WindowEnergy, BandGoesWithGravity) {
    auto const earth = rocking_period_band(1.2468);
    auto const heavy = rocking_period_band(1.2468, RadiusUnit::centimetre, 4 * g0);
    EXPECT_EQ(2 * heavy.t0_s, earth.t0_s);
    EXPECT_EQ(2 * heavy.t1_s, earth.t1_s);
    EXPECT_EQ(rocking_period_band(1.2468, RadiusUnit::centimetre, g0).t1_s, earth.t1_s);
    EXPECT_THROW(static_cast<void>(rocking_period_band(1.2468, RadiusUnit::centimetre, 0)), InputError);
}

TEST(WindowEnergy, RefusesAnEmptyBand) {
    testing::expect_input_error([] { (void)window_energy(std::vector{1.0}, 0.01, {2, 1}); }, "0 < T0 < T1");
}

}  // namespace
}  // namespace overturn
