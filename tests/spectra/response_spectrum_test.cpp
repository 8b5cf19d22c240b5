// Requirement R-201: response spectra equal closed forms, also where periods approach the time step.
#include "spectra/response_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "motion/ground_motion.hpp"
#include "spectra/oscillator.hpp"
#include "support/expect_input_error.hpp"
#include "support/oscillator_history.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

using testing::near;

std::vector<double> sine(double period_s, double dt, std::size_t samples) {
    std::vector<double> wave(samples);
    for (std::size_t n = 0; n < samples; ++n) {
        wave[n] = std::sin(2 * pi / period_s * dt * static_cast<double>(n));
    }
    return wave;
}

TEST(ResponseSpectrum, SteadyHarmonicAmplification) {
    auto const wave = sine(1.0, 0.0005, 40001);
    for (double const period : {0.5, 0.8, 2.0}) {
        double const steady = 1 / std::hypot(1 - period * period, 2 * 0.6 * period);
        auto const history = testing::oscillator_history(wave, 0.0005, period, 0.6);
        double const w = 2 * pi / period;

        double const last_cycle = peak_of(std::span(history.displacement_m).last(2000));

        EXPECT_TRUE(near(w * w * last_cycle, steady, testing::Tolerance{1e-5, "sampled sine"})) << period;
        EXPECT_GE(response_spectrum(wave, 0.0005, std::vector{period}, 0.6).sd_m[0], last_cycle);
    }
}

TEST(ResponseSpectrum, UndampedResonanceGrowsByPiPerCycle) {
    auto const spectrum = response_spectrum(sine(1.0, 0.001, 10001), 0.001, std::vector{1.0}, 0.0);

    // y = (sin wt - wt cos wt) / 2 w^2: after ten cycles w^2 y = 10 pi.
    EXPECT_TRUE(near(spectrum.psa_mps2[0], 10 * pi, testing::Tolerance{1e-5, "sampled sine"}));
}

// R-1002.
TEST(ResponseSpectrum, EveryLaneEqualsTheSingleOscillator) {
    auto const wave = testing::broad_wave(3000, 0.01);
    auto const periods = log_periods(0.1, 20, 37);  // not a multiple of 16; all at samples

    auto const spectrum = response_spectrum(wave, 0.01, periods, 0.05);
    auto const displacement = displacement_spectrum(wave, 0.01, periods, 0.05);

    EXPECT_EQ(displacement, spectrum.sd_m);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        auto const history = testing::oscillator_history(wave, 0.01, periods[i], 0.05);
        EXPECT_TRUE(near(spectrum.sd_m[i], peak_of(history.displacement_m), testing::exact_formula));
        EXPECT_TRUE(near(spectrum.sv_mps[i], peak_of(history.velocity_mps), testing::exact_formula));
        EXPECT_TRUE(near(spectrum.sa_mps2[i], peak_of(history.acceleration_mps2), testing::exact_formula));
        double const w = 2 * pi / periods[i];
        EXPECT_TRUE(near(spectrum.psa_mps2[i], w * w * spectrum.sd_m[i], testing::rounding));
    }
}

// R-1002.
TEST(ResponseSpectrum, NeighboursChangeNoBit) {
    auto const wave = testing::broad_wave(2000, 0.01);
    auto const periods = log_periods(0.02, 10, 50);

    auto const together = displacement_spectrum(wave, 0.01, periods, 0.05);

    for (std::size_t i = 0; i < periods.size(); ++i) {
        EXPECT_EQ(displacement_spectrum(wave, 0.01, std::vector{periods[i]}, 0.05)[0], together[i]);
    }
}

TEST(ResponseSpectrum, ShortPeriodsAreSeenBetweenSamples) {
    auto const wave = testing::broad_wave(3000, 0.01);
    auto const periods = log_periods(0.005, 0.2, 60);

    auto const seen = response_spectrum(wave, 0.01, periods, 0.05);
    auto const fine = response_spectrum(wave, 0.01, periods, 0.05, {.points_per_period = 1000});
    auto const blind = response_spectrum(wave, 0.01, periods, 0.05, {.points_per_period = 1});

    double worst_blind = 0;
    for (std::size_t i = 0; i < periods.size(); ++i) {
        EXPECT_LE(seen.sd_m[i], fine.sd_m[i] * (1 + 1e-3));
        EXPECT_GE(seen.sd_m[i], fine.sd_m[i] * std::cos(pi / 10) * (1 - 1e-3)) << periods[i];
        worst_blind = std::max(worst_blind, 1 - blind.sd_m[i] / fine.sd_m[i]);
    }
    EXPECT_GT(worst_blind, 0.04);
}

TEST(ResponseSpectrum, VeryStiffOscillatorFollowsTheGround) {
    auto const wave = testing::broad_wave(3000, 0.01);

    auto const spectrum = response_spectrum(wave, 0.01, std::vector{1e-4}, 0.05);

    EXPECT_TRUE(near(spectrum.psa_mps2[0], peak_of(wave), testing::Tolerance{1e-2, "quasi-static"}));
}

TEST(ResponseSpectrum, CutsOnlyBelowTenSteps) {
    EXPECT_EQ(steps_per_sample(0.1, 0.01, {}), 1);
    EXPECT_EQ(steps_per_sample(0.0999, 0.01, {}), 2);
    EXPECT_EQ(steps_per_sample(0.02, 0.01, {}), 5);
    EXPECT_EQ(steps_per_sample(1e-9, 0.01, {}), 32);
}

TEST(ResponseSpectrum, LogPeriodsHaveEqualRatiosAndExactEnds) {
    auto const periods = log_periods_per_decade(0.02, 10, 100);

    EXPECT_EQ(periods.size(), 271U);
    EXPECT_EQ(periods.front(), 0.02);
    EXPECT_EQ(periods.back(), 10);
    EXPECT_NEAR(periods[1] / periods[0], periods[200] / periods[199], 1e-13);
    testing::expect_input_error([] { (void)log_periods(1, 1, 5); }, "0 < from < to");
}

}  // namespace
}  // namespace overturn
