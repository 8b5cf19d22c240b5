// Requirement: drawn waves bring the ground to rest where it began, and move it by what they are drawn
// for: nothing slower than twice the longest period wanders off in between.
#include "generators/detail/high_pass_baseline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "generators/detail/baseline.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "motion/ground_motion.hpp"
#include "simd/instruction_sets.hpp"
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

/// A polynomial in lanes of any width, and what is left beside them.
TEST(PolynomialBaseline, HasTheSameBitsOnEveryInstructionSet) {
    for (std::size_t samples = 5; samples < 70; ++samples) {
        std::vector<double> first;
        for (auto const set : simd::instruction_sets()) {
            simd::OnlyInstructionSet const only(set);
            auto wave = testing::broad_wave(samples, dt);
            correct_baseline(wave);
            if (first.empty()) {
                first = wave;
            }
            EXPECT_EQ(wave, first) << simd::name_of(set) << " " << samples;
            EXPECT_LT(std::abs(velocity_of(wave, dt).back()), 1e-14) << samples;
            EXPECT_LT(std::abs(displacement_of(wave, dt).back()), 1e-14) << samples;
        }
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

/// The same correction written down a second time, sample by sample: cosines of the displacement that the polynomial
/// leaves, the filter's gain, the least change that makes g and g'' vanish at both ends, g'' off the acceleration.
std::vector<double> slow_part(std::vector<double> a) {
    correct_baseline(a);
    auto const displacement = displacement_of(a, dt);
    auto const n = a.size() - 1;
    double const duration = dt * static_cast<double>(n);
    std::vector<double> slow(a.size(), 0.0);
    for (std::size_t parity : {0U, 1U}) {
        std::vector<std::size_t> orders;
        std::vector<double> g, weight;
        for (std::size_t m = parity; m < 120; m += 2) {
            double sum = 0;
            for (std::size_t i = 0; i <= n; ++i) {
                double const end = i == 0 || i == n ? 0.5 : 1;
                sum += end * displacement[i] * std::cos(pi * static_cast<double>(m * i) / static_cast<double>(n));
            }
            double const gain = 1 / (1 + std::pow(static_cast<double>(m) / (2 * duration) * 2 * longest_s, 8));
            orders.push_back(m);
            g.push_back(gain * sum * (m == 0 ? 1 : 2) / static_cast<double>(n));
            weight.push_back(m == 0 ? 0.5 * gain : gain);
        }
        for (int sweep = 0; sweep < 60000; ++sweep) {  // projections onto both conditions in turn, until both hold
            for (int power : {0, 2}) {
                double missing = 0, norm = 0;
                for (std::size_t k = 0; k < g.size(); ++k) {
                    double const c = std::pow(static_cast<double>(orders[k]) / 10, power);
                    missing += c * g[k];
                    norm += c * c * weight[k];
                }
                for (std::size_t k = 0; k < g.size(); ++k) {
                    g[k] -= weight[k] * std::pow(static_cast<double>(orders[k]) / 10, power) * missing / norm;
                }
                if (power == 0 && std::abs(missing) < 1e-14) {
                    sweep = 60000;
                }
            }
        }
        for (std::size_t i = 0; i <= n; ++i) {
            for (std::size_t k = 0; k < g.size(); ++k) {
                double const w = pi * static_cast<double>(orders[k]) / duration;
                slow[i] -= g[k] * w * w * std::cos(w * dt * static_cast<double>(i));
            }
        }
    }
    return slow;
}

TEST(HighPassBaseline, TakesOffWhatAPlainSumTakesOff) {
    constexpr std::size_t samples = 3001;
    auto before = packet(17, 6, samples);  // slow, and in full swing at both ends
    auto const fast = testing::broad_wave(samples, dt);
    for (std::size_t i = 0; i < samples; ++i) {
        before[i] = before[i] * 0.5 + 0.05 * fast[i];
    }
    before.front() = 0.3;
    auto after = before;
    HighPassBaseline(samples, dt, longest_s).correct(after);

    auto expected = before;
    auto const slow = slow_part(before);
    correct_baseline(expected);
    for (std::size_t i = 0; i < samples; ++i) {
        expected[i] -= slow[i];
    }
    auto plain = before;
    correct_baseline(plain);
    EXPECT_GT(largest_difference(plain, expected), 0.02 * peak_of(before)) << "nothing to see";
    // Chords between nodes are 2 % off their arcs, on the way there and on the way back.
    EXPECT_LT(largest_difference(after, expected), 0.05 * largest_difference(plain, expected));
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
