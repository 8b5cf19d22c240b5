// Requirement: drawn waves bring the ground to rest where it began, and move it by what they are drawn
// for: nothing slower than twice the longest period wanders off in between.
#include "generators/detail/high_pass_baseline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "motion/ground_motion.hpp"
#include "spectra/named_targets.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

constexpr double dt = 0.01;
constexpr double longest_s = 5;

double largest_difference(std::vector<double> const& a, std::vector<double> const& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

/// The second derivative of a sinusoid of `period_s` under exp(-(t - middle)^2 / (2 width^2)), which is at rest at both
/// ends.
std::vector<double> packet(double period_s, double width_s, std::size_t samples) {
    double const w = 2 * pi / period_s;
    std::vector<double> a(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        double const t = dt * (static_cast<double>(i) - 0.5 * static_cast<double>(samples - 1));
        double const bell = std::exp(-0.5 * t * t / (width_s * width_s));
        double const slope = -t / (width_s * width_s);
        double const curvature = slope * slope - 1 / (width_s * width_s);
        a[i] = bell * ((curvature - w * w) * std::cos(w * t) - 2 * slope * w * std::sin(w * t));
    }
    return a;
}

TEST(HighPassBaseline, EndsAtRestWhereItBegan) {
    for (std::size_t const samples : {5U, 101U, 501U, 2999U, 3000U, 3001U, 8192U, 8193U}) {
        auto wave = testing::broad_wave(samples, dt);
        auto const before = wave;

        HighPassBaseline(samples, dt, longest_s).correct(wave);

        auto const velocity = velocity_of(wave, dt);
        auto const displacement = displacement_of(wave, dt);
        EXPECT_LT(std::abs(velocity.back()), 1e-12 * peak_of(velocity)) << samples;
        EXPECT_LT(std::abs(displacement.back()), 1e-10 * peak_of(displacement)) << samples;
        EXPECT_NEAR(wave.front(), before.front(), 1e-12) << samples;
        EXPECT_NEAR(wave.back(), before.back(), 0.01 * peak_of(before)) << samples;
    }
}

/// A packet long enough to have one period is passed as the filter's response there says: 1 / (1 + (corner / f)^8).
TEST(HighPassBaseline, RespondsAsTheFilterItIs) {
    constexpr std::size_t samples = 40001;
    for (double const period_s : {2.0, 5.0, 8.0, 10.0, 12.0, 20.0}) {
        auto const before = packet(period_s, 8 * period_s / 3, samples);
        auto after = before;

        HighPassBaseline(samples, dt, longest_s).correct(after);

        double const passed = peak_of(displacement_of(after, dt)) / peak_of(displacement_of(before, dt));
        EXPECT_NEAR(passed, 1 / (1 + std::pow(period_s / (2 * longest_s), 8)), 0.03) << period_s;
    }
}

TEST(HighPassBaseline, LeavesWhatIsFasterAlone) {
    constexpr std::size_t samples = 12001;
    for (double const period_s : {0.1, 1.0, 3.0}) {
        auto const before = packet(period_s, 10, samples);
        auto after = before;

        HighPassBaseline(samples, dt, longest_s).correct(after);

        EXPECT_LT(largest_difference(after, before), 1e-3 * peak_of(before)) << period_s;
    }
}

TEST(HighPassBaseline, IsLinear) {
    constexpr std::size_t samples = 3001;
    HighPassBaseline const baseline(samples, dt, longest_s);
    auto one = testing::broad_wave(samples, dt);
    auto other = packet(7, 5, samples);
    std::vector<double> sum(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        sum[i] = 3 * one[i] - 2 * other[i];
    }

    baseline.correct(one);
    baseline.correct(other);
    baseline.correct(sum);

    for (std::size_t i = 0; i < samples; ++i) {
        ASSERT_NEAR(sum[i], 3 * one[i] - 2 * other[i], 1e-12 * peak_of(one)) << i;
    }
}

struct Slow {
    double pgd_m, share;  // of the displacement's power that is slower than twice the longest period
};

Slow displacement_of_wave(std::vector<double> const& a, double longest) {
    auto const displacement = displacement_of(a, dt);
    RealFft const fft(RealFft::good_length(2 * displacement.size()));
    std::vector<double> padded(fft.length(), 0.0);
    std::copy(displacement.begin(), displacement.end(), padded.begin());
    std::vector<std::complex<double>> lines(fft.length() / 2);
    fft.analyse(padded, lines);
    double slow = 0, all = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        double const power = std::norm(lines[k]);
        all += power;
        slow += 2 * longest * static_cast<double>(k) < dt * static_cast<double>(fft.length()) ? power : 0;
    }
    return {peak_of(displacement), slow / all};
}

/// Of waves of the long-period target CH1, matched and not: PGD lies about the target's Sd at its longest period, and
/// most of the displacement is of periods that the target speaks of (without the filter nine tenths are slower).
TEST(HighPassBaseline, PgdOfDrawnWavesIsOfTheirTarget) {
    constexpr double longest = 10;
    constexpr int waves = 8;
    auto const target = config::find_entry(named_targets(), "mlit-ch1", "").value({});
    double const sd = target.psv_mps(longest) * longest / (2 * pi);
    struct Case {
        int iterations;
        std::size_t samples;  // whatever they are: the last one is a node
    };
    for (auto const& [iterations, samples] : {Case{0, 16384}, {40, 16384}, {0, 15873}, {0, 15874}, {0, 15900}}) {
        double const duration = dt * static_cast<double>(samples);
        SpectrumMatcher const matcher(
            {.target = target,
             .longest_s = longest,
             .time_step_s = dt,
             .samples = samples,
             .envelope = {.shape = EnvelopeShape::jennings, .rise_s = 10, .level_end_s = 60, .end_s = duration - 10},
             .iterations = iterations});
        double share = 0;
        for (std::uint64_t wave = 0; wave < waves; ++wave) {
            auto const found = displacement_of_wave(matcher.make(2013, wave, 0).acceleration_mps2, longest);
            EXPECT_GT(found.pgd_m, 0.2 * sd) << wave;
            EXPECT_LT(found.pgd_m, 0.5 * sd) << wave;
            EXPECT_LT(found.share, 0.2) << wave;
            share += found.share / waves;
        }
        EXPECT_LT(share, 0.05) << iterations << " " << samples;
    }
}

}  // namespace
}  // namespace overturn
