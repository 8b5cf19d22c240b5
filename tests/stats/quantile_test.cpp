// Requirement R-703: quantiles of a response come with distribution-free intervals that hold the true one as often as
// they say, and that trials without a value widen.
#include "stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace overturn {
namespace {

std::vector<double> counted(std::size_t n) {
    std::vector<double> values(n);
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

/// The ranks of the tables: the median of 20 lies between the 6th and the 15th value with 95.9 % (David & Nagaraja
/// 2003); n = 59 has no upper 95 % bound of the 95 % quantile at 95 % (two-sided), 72 is the least that has:
/// 0.95^72 < 0.025 < 0.95^71.
TEST(SampleQuantile, RanksOfTheTables) {
    auto const median = sample_quantile(counted(20), 0, 0.5, 0.95);

    EXPECT_EQ(median.value, 10.5);
    EXPECT_EQ(median.lower, 6);
    EXPECT_EQ(median.upper, 15);
    EXPECT_FALSE(sample_quantile(counted(71), 0, 0.95, 0.95).upper);
    EXPECT_EQ(sample_quantile(counted(72), 0, 0.95, 0.95).upper, 72);
    EXPECT_FALSE(sample_quantile(counted(5), 0, 0.5, 0.95).lower) << "2 (1/2)^5 > 0.05";
    EXPECT_EQ(sample_quantile(counted(6), 0, 0.5, 0.95).lower, 1);
    EXPECT_EQ(sample_quantile(counted(6), 0, 0.5, 0.95).upper, 6);
    EXPECT_TRUE(std::isnan(sample_quantile({}, 3, 0.5, 0.95).value));
}

/// Of 4000 lognormal samples at least 95 % hold the true quantile (by less than three standard errors).
TEST(SampleQuantile, ContainsTheTrueOneWithItsCoverage) {
    std::mt19937_64 source(7);
    std::lognormal_distribution<double> draw(0, 0.8);
    constexpr int samples = 4000;
    for (auto const& [q, score] :
         {std::pair{0.5, 0.0}, std::pair{0.84, 0.994457883209753}, std::pair{0.95, 1.6448536269514722}}) {
        int held = 0;
        for (int s = 0; s < samples; ++s) {
            std::vector<double> values(100);
            std::generate(values.begin(), values.end(), [&] { return draw(source); });
            std::sort(values.begin(), values.end());
            auto const found = sample_quantile(values, 0, q, 0.95);
            double const truth = std::exp(0.8 * score);
            held += (!found.lower || *found.lower <= truth) && (!found.upper || truth <= *found.upper) ? 1 : 0;
        }
        EXPECT_GE(held, samples * (0.95 - 3 * std::sqrt(0.95 * 0.05 / samples))) << q;
        EXPECT_LE(held, samples * 0.985) << "far too wide at " << q;
    }
}

/// Whatever the unknown values were, the interval of the whole sample lies within.
TEST(SampleQuantile, UnknownValuesMayLieAnywhere) {
    auto const all = counted(100);
    auto const known = std::vector<double>(all.begin() + 10, all.end() - 10);  // ten at either end, say
    auto const open = sample_quantile(known, 20, 0.5, 0.95);
    auto const whole = sample_quantile(all, 0, 0.5, 0.95);

    EXPECT_LE(*open.lower, *whole.lower);
    EXPECT_GE(*open.upper, *whole.upper);
    EXPECT_LT(*open.lower, *sample_quantile(known, 0, 0.5, 0.95).lower);
    EXPECT_FALSE(sample_quantile(known, 60, 0.5, 0.95).lower);
}

/// A fall is beyond every rotation: no mean of a number and infinity, and no NaN at a whole place.
TEST(SampleQuantile, MayBeInfinite) {
    constexpr double fell = std::numeric_limits<double>::infinity();

    EXPECT_EQ(sample_quantile(std::vector{1.0, 2.0, fell}, 0, 0.5, 0.95).value, 2);
    EXPECT_EQ(sample_quantile(std::vector{1.0, 2.0, fell, fell}, 0, 0.5, 0.95).value, fell);
    EXPECT_EQ(sample_quantile(std::vector{fell}, 0, 0.5, 0.95).value, fell);
}

}  // namespace
}  // namespace overturn
