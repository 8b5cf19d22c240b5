// Requirement R-608: a flat bed of as many points as it has by default lets a body fall as often as the most points
// that are simulated; a bed of five does not.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "contact/matching.hpp"

namespace overturn {
namespace {

constexpr double step_s = 0.01;

// Sines of 0.4 to 3 Hz of random phases under an envelope, of the same largest acceleration.
std::vector<double> noise(unsigned number, double peak_mps2) {
    constexpr std::size_t samples = 2500;
    constexpr int lines = 60;
    std::mt19937 random(number);
    std::vector<double> wave(samples, 0.0);
    for (int line = 0; line < lines; ++line) {
        double const frequency_hz = 0.4 + 2.6 * line / lines;
        double const phase_rad = 2 * pi * random() / 4294967296.0;
        for (std::size_t i = 0; i < samples; ++i) {
            double const t = static_cast<double>(i) * step_s;
            wave[i] += std::sin(2 * pi * frequency_hz * t + phase_rad) / (1 + frequency_hz);
        }
    }
    double largest = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        double const share = static_cast<double>(i) / samples;
        wave[i] *= std::min(1.0, 6 * share) * std::min(1.0, 3 * (1 - share));
        largest = std::max(largest, std::abs(wave[i]));
    }
    for (auto& value : wave) {
        value *= peak_mps2 / largest;
    }
    return wave;
}

std::vector<bool> falls(std::vector<std::vector<double>> const& waves, int points) {
    auto const block = contact_block(testing::body_a(), testing::flat_bed(points), {}, {});
    std::vector<ContactTrial> trials;
    for (auto const& wave : waves) {
        trials.push_back({&block, {.horizontal_mps2 = wave, .time_step_s = step_s}});
    }
    std::vector<ContactOutcome> outcomes(trials.size());
    simulate_contact(trials, {}, outcomes);
    std::vector<bool> fell;
    for (auto const& outcome : outcomes) {
        fell.push_back(outcome.verdict == Verdict::overturned);
    }
    return fell;
}

TEST(Bed, FallsAsOftenAsTheFinest) {
    std::vector<std::vector<double>> waves;
    for (unsigned number = 0; number < 240; ++number) {
        waves.push_back(noise(number, 8 + 0.05 * number));
    }
    auto const finest = falls(waves, 41);
    struct Against {
        int more = 0, fewer = 0;  // waves that fall on one bed alone
    };
    auto const against_finest = [&](int points) {
        auto const fell = falls(waves, points);
        Against against;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            against.more += fell[i] && !finest[i] ? 1 : 0;
            against.fewer += finest[i] && !fell[i] ? 1 : 0;
        }
        return against;
    };
    auto const usual = against_finest(BasePlan::points_across);
    auto const coarse = against_finest(5);
    // Of waves that decide otherwise as many do so either way: within three standard deviations of a fair coin.
    double const noise = 3 * std::sqrt(usual.more + usual.fewer);
    EXPECT_LE(std::abs(usual.more - usual.fewer), noise) << usual.more << " more, " << usual.fewer << " fewer";
    EXPECT_LE(usual.more + usual.fewer, 48);  // a fifth
    EXPECT_GT(coarse.fewer - coarse.more, 3 * std::sqrt(coarse.more + coarse.fewer))
        << coarse.more << " more, " << coarse.fewer << " fewer";
}

// what a bed gives back has come to rest within what the amplitude makes of it.
TEST(Bed, RestitutionHasConverged) {
    auto const of = [](int points) { return emergent_restitution(testing::body_a(), testing::flat_bed(points), {}); };
    EXPECT_NEAR(of(BasePlan::points_across), of(41), 0.01);
    EXPECT_GT(of(41) - of(5), 0.02);
}

}  // namespace
}  // namespace overturn
