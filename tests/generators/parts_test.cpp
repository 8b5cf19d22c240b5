// Requirement: the steps of wave making do each what they say.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random_stream.hpp"
#include "generators/detail/baseline.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/detail/spectral_density.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "generators/envelope.hpp"
#include "motion/ground_motion.hpp"
#include "spectra/named_targets.hpp"
#include "support/kolmogorov.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

TEST(RealFft, SumsCosines) {
    RealFft const fft(30);
    std::vector<std::complex<double>> lines(15);
    lines[0] = 0.5;
    lines[3] = std::polar(2.0, 0.7);
    lines[14] = {0, 1};
    std::vector<double> series(30);

    fft.synthesise(lines, series);

    for (int n = 0; n < 30; ++n) {
        double const exact = 0.5 + 2 * std::cos(2 * pi * 3 * n / 30 + 0.7) - std::sin(2 * pi * 14 * n / 30);
        EXPECT_NEAR(series[static_cast<std::size_t>(n)], exact, 1e-13);
    }
    EXPECT_EQ(RealFft::good_length(12001), 12150U);
    EXPECT_EQ(RealFft::good_length(16384), 16384U);
}

TEST(Envelope, JenningsValues) {
    Envelope const envelope{.shape = EnvelopeShape::jennings, .rise_s = 10, .level_end_s = 60, .end_s = 110};

    EXPECT_DOUBLE_EQ(envelope.at(5), 0.25);
    EXPECT_DOUBLE_EQ(envelope.at(10), 1);
    EXPECT_DOUBLE_EQ(envelope.at(60), 1);
    EXPECT_NEAR(envelope.at(110), 0.1, 1e-15);
    auto const samples = envelope.samples(0.01, 12001);
    EXPECT_EQ(samples.front(), 0);
    EXPECT_EQ(samples.back(), 0);
    EXPECT_EQ(samples[11899], envelope.at(0.01 * 11899));
}

TEST(Baseline, EndsAtRestWhereItBegan) {
    auto wave = testing::broad_wave(3001, 0.01);
    wave.front() = 0.7;  // stays: half a triangle of it counts
    wave.back() = -0.4;
    auto const before = wave;

    correct_baseline(wave);

    auto const velocity = velocity_of(wave, 0.01);
    auto const displacement = displacement_of(wave, 0.01);
    EXPECT_LT(std::abs(velocity.back()), 1e-12 * peak_of(velocity));
    EXPECT_LT(std::abs(displacement.back()), 1e-11 * peak_of(displacement));
    EXPECT_EQ(wave.front(), before.front());
    EXPECT_EQ(wave.back(), before.back());
    double largest = 0;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        largest = std::max(largest, std::abs(wave[i] - before[i]));
    }
    EXPECT_LT(largest, 0.02 * peak_of(before));
}

TEST(SpectralDensity, IsPositiveAndGoesWithTheSquareOfTheTarget) {
    auto const target = config::find_entry(named_targets(), "rg-1.60", "").value({});
    std::vector<double> frequencies;
    for (int k = 1; k < 3000; ++k) {
        frequencies.push_back(0.1 * k);
    }

    auto const one = density_of(target, frequencies, 50);
    auto const three = density_of(target.scaled(3), frequencies, 50);

    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_GT(one[i], 0);
        EXPECT_NEAR(three[i] / one[i], 9, 1e-9);
    }
}

// Kolmogorov-Smirnov on the phases of a stationary draw, taken back out of the samples.
TEST(SpectrumMatcher, PhasesAreUniform) {
    auto const target = config::find_entry(named_targets(), "mlit-ch1", "").value({});
    SpectrumMatcher const matcher({.target = target,
                                   .time_step_s = 0.01,
                                   .samples = 12000,  // a good length: the lines are orthogonal over the wave
                                   .envelope = {.shape = EnvelopeShape::constant},
                                   .iterations = 0});
    std::vector<double> phases;
    for (std::uint64_t wave = 0; wave < 20; ++wave) {
        auto const a = matcher.make(3, wave, 0).acceleration_mps2;
        for (int k = 200; k < 700; k += 10) {
            std::complex<double> line = 0;
            for (std::size_t n = 0; n < a.size(); ++n) {
                line += a[n] * std::polar(1.0, -2 * pi * k * static_cast<double>(n) / 12000);
            }
            phases.push_back((std::arg(line) + pi) / (2 * pi));
        }
    }
    constexpr double chance = 0.01;
    EXPECT_GT(testing::ks_test(phases, [](double turn) { return turn; }).p_value, chance);
}

TEST(MatchFigures, CountOnlyTheirBand) {
    std::vector<double> const periods{0.1, 1, 2, 20};
    std::vector<double> const ratios{3, 1.1, 0.7, 9};

    auto const figures = match_figures(periods, ratios, 1, 10);

    EXPECT_DOUBLE_EQ(figures.mean_misfit, 0.2);
    EXPECT_DOUBLE_EQ(figures.max_misfit, 0.30000000000000004);
    EXPECT_EQ(figures.max_misfit_period_s, 2);
    EXPECT_DOUBLE_EQ(figures.mean_ratio, 0.9);
    EXPECT_DOUBLE_EQ(figures.below_fraction, 0.5);
    EXPECT_EQ(match_figures(periods, ratios, 30, 40).mean_misfit, 0);
}

}  // namespace
}  // namespace overturn
