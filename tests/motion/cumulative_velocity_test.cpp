// Requirement R-206: cumulative absolute velocity meets closed forms, whole and of the windows of a second that count.
#include "motion/cumulative_velocity.hpp"

#include <cmath>
#include <vector>

#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

// Half cycles of a sine, each of so many steps, drawn straight from sample to sample.
std::vector<double> sine(double amplitude, int half_cycles, int steps) {
    std::vector<double> samples;
    for (int i = 0; i <= half_cycles * steps; ++i) {
        samples.push_back(amplitude * std::sin(pi * i / steps));
    }
    return samples;
}

std::vector<double> times(std::vector<double> samples, double factor) {
    for (double& a : samples) {
        a *= factor;
    }
    return samples;
}

// A sine's is 2 A / pi a second. Of the chords between its samples it is exactly A dt cot(pi / 2 n) a half cycle of n
// steps, the sum of sin(k pi / n) over k.
TEST(CumulativeVelocity, OfASineIsTwoOverPiOfItsAmplitudeASecond) {
    constexpr double amplitude = 3;
    for (int const steps : {2, 7, 50, 1000}) {
        double const dt = 0.5 / steps;  // 1 Hz
        auto const wave = sine(amplitude, 20, steps);

        EXPECT_TRUE(near(cav_mps(wave, dt), 20 * amplitude * dt / std::tan(pi / (2 * steps)), exact_formula)) << steps;
    }
    EXPECT_NEAR(cav_mps(sine(amplitude, 20, 1000), 0.0005) / (10 * 2 * amplitude / pi), 1, 1e-6);
}

TEST(CumulativeVelocity, TurnsInsideAStepAreCounted) {
    // |1 - 3 t| over 1 s: 1/6 before the turn, 2/3 after it.
    EXPECT_TRUE(near(cav_mps(std::vector{1.0, -2.0}, 1), 5.0 / 6, exact_formula));
    EXPECT_TRUE(near(cav_mps(std::vector{-1.0, 2.0}, 1), 5.0 / 6, exact_formula));
    EXPECT_EQ(cav_mps(std::vector{0.0, 0.0, 0.0}, 1), 0);
    EXPECT_EQ(cav_mps(std::vector{5.0}, 1), 0);
    EXPECT_EQ(cav_mps({}, 1), 0);
}

TEST(StandardisedCav, IsNothingOfAWaveThatStaysBelowTheThreshold) {
    auto const wave = sine(1, 20, 25);  // 1 Hz at 0.02 s; its peak is a sample of no window's end
    double const peak = std::sin(pi * 12 / 25);
    double const barely = standardised_cav_threshold_mps2 / peak;

    EXPECT_EQ(standardised_cav_mps(times(wave, 0.999 * barely), 0.02), 0);
    EXPECT_EQ(standardised_cav_mps(wave, 0.02, 0.999 * barely), 0);
    EXPECT_GT(cav_mps(times(wave, 0.999 * barely), 0.02), 0);
    EXPECT_TRUE(
        near(standardised_cav_mps(wave, 0.02, 1.001 * barely), 1.001 * barely * cav_mps(wave, 0.02), exact_formula))
        << "every window counts";
}

// a = 0.1 t: of the windows those from 2 s on reach 0.025 g = 0.245, also the last one, of 0.01 s. No window but the
// first begins at a sample.
TEST(StandardisedCav, CountsWholeWindowsAndCutsStepsWhereTheyEnd) {
    std::vector<double> ramp;
    for (int i = 0; i <= 143; ++i) {
        ramp.push_back(0.1 * 0.07 * i);
    }

    EXPECT_TRUE(near(standardised_cav_mps(ramp, 0.07), 0.05 * (10.01 * 10.01 - 4), exact_formula));
    EXPECT_TRUE(near(standardised_cav_mps(ramp, 0.07, 2), 2 * 0.05 * (10.01 * 10.01 - 1), exact_formula))
        << "twice the motion has a window more";
    EXPECT_TRUE(near(standardised_cav_mps(times(ramp, -1), 0.07), 0.05 * (10.01 * 10.01 - 4), exact_formula));
}

// A pulse in the third second lifts that second alone, its quiet parts with it.
TEST(StandardisedCav, AWindowCountsWithItsQuietParts) {
    constexpr double quiet = 0.1;
    std::vector<double> wave(601, quiet);
    for (int i = 0; i <= 10; ++i) {
        wave[240 + static_cast<std::size_t>(i)] = quiet + 0.09 * (i <= 5 ? i : 10 - i);  // to 0.55 and back in 0.1 s
    }

    EXPECT_TRUE(near(standardised_cav_mps(wave, 0.01), quiet + 0.45 * 0.1 / 2, exact_formula));
    EXPECT_TRUE(near(cav_mps(wave, 0.01), 6 * quiet + 0.45 * 0.1 / 2, exact_formula));
}

// Steps longer than a window, a record shorter than one.
TEST(StandardisedCav, HoldsForStepsOfAnyLength) {
    EXPECT_TRUE(near(standardised_cav_mps(std::vector{1.0, 1.0}, 5.5), 5.5, exact_formula));
    EXPECT_TRUE(near(standardised_cav_mps(std::vector{0.0, 1.0}, 5.0), 0.1 * (25 - 1), exact_formula))
        << "0.2 t reaches 0.245 in the second window";
    EXPECT_TRUE(near(standardised_cav_mps(std::vector{1.0, 1.0}, 0.25), 0.25, exact_formula));
    EXPECT_EQ(standardised_cav_mps({}, 0.01), 0);
}

}  // namespace
}  // namespace overturn
