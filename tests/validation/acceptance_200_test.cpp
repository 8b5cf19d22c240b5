// Requirement: 200 of 200 waves pass SRP 3.7.1 and 5 % over any decade of periods to 10 s, for CH1,
// KA1 and RG 1.60; they end at rest, their phases are uniform, their components independent.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "generators/detail/real_fft.hpp"
#include "generators/wave_quality.hpp"
#include "support/kolmogorov.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

constexpr std::uint64_t waves = 200;

std::string keys(std::string const& target, std::string const& rule) {
    return "source='spectrum-compatible'\nduration='120 s'\nacceptance='" + rule + "'\n[target]\nspectrum='" + target
           + "'\n[envelope]\nrise=10\nlevel_end=60\nend=110\n";
}

// Phases of lines far enough apart for the envelope not to tie them, in turns.
void gather_phases(std::vector<double> const& a, std::vector<double>& turns) {
    RealFft const fft(RealFft::good_length(a.size()));
    std::vector<double> padded(fft.length(), 0.0);
    std::copy(a.begin(), a.end(), padded.begin());
    std::vector<std::complex<double>> lines(fft.length() / 2);
    fft.analyse(padded, lines);
    for (std::size_t k = 40; k < lines.size() / 4; k += 40) {
        turns.push_back(std::arg(lines[k]) / (2 * pi) + 0.5);
    }
}

class TwoHundred : public ::testing::TestWithParam<char const*> {};

TEST_P(TwoHundred, PassSrp371) {
    auto const source = testing::source_of(keys(GetParam(), "srp-3.7.1"));
    std::uint64_t passed = 0;
    std::vector<double> turns;
    double iterations = 0, worst_decade = 0, lowest = 9, highest = 0, mean = 0;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const made = source->make(2013, wave);
        auto const quality = wave_quality(made.motion);
        auto clauses = made.clauses;
        for (auto const& clause :
             wave_clauses(made.rule, {0.01, made.motion.duration_s(), quality.end_velocity_ratio, 0})) {
            clauses.push_back(clause);
        }
        passed += all_passed(clauses) ? 1 : 0;
        EXPECT_LT(quality.end_velocity_ratio, 1e-6);
        gather_phases(made.motion.horizontal_mps2, turns);
        iterations += made.match.iterations / static_cast<double>(waves);
        worst_decade = std::max(worst_decade, made.match.worst_decade);
        lowest = std::min(lowest, made.match.all.lowest_ratio);
        highest = std::max(highest, made.match.all.highest_ratio);
        mean += made.match.all.mean_ratio / static_cast<double>(waves);
    }
    EXPECT_EQ(passed, waves);
    constexpr double chance = 0.01;
    EXPECT_GT(testing::ks_test(turns, [](double turn) { return turn; }).p_value, chance) << "phases are not uniform";
    EXPECT_LE(iterations, 15) << "on average";
    EXPECT_LE(worst_decade, 0.05);
    EXPECT_GE(lowest, 0.9) << "the rule's own lower bound";
    EXPECT_LE(highest, 1.3) << "the rule's own upper bound";
    EXPECT_NEAR(mean, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Targets, TwoHundred, ::testing::Values("mlit-ch1", "mlit-ka1", "rg-1.60"),
                         [](auto const& one) { return "target_" + std::to_string(one.index); });

TEST(TwoHundredPairs, AreIndependent) {
    auto const source = testing::source_of(keys("mlit-ch1", "none") + "[vertical]\nratio=0.667\n");
    double largest = 0;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        largest = std::max(largest, std::abs(wave_quality(source->make(2013, wave).motion).correlation));
    }
    EXPECT_LE(largest, 0.16);
    EXPECT_GT(largest, 0.08) << "as chance has it";
}

}  // namespace
}  // namespace overturn
