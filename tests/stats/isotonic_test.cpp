// Requirement R-704: the estimate that rises without a curve is Ayer's (1955): neighbours that do not rise are pooled,
// and the level at which it reaches one half is a median.
#include "stats/isotonic.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "support/tolerance.hpp"

namespace overturn {
namespace {

FragilityPoint point(double intensity, double trials, double overturned) {
    return {.log_intensity = std::log(intensity), .trials = trials, .overturned = overturned};
}

// Worked by hand: 2/10 and 2/10 are one block of 4/20; 6/10 and 4/20 fall, so that they are one of 10/30.
TEST(Isotonic, PoolsWhatDoesNotRise) {
    std::array const equal{point(1, 10, 2), point(2, 10, 2), point(3, 10, 6)};
    auto const pooled = isotonic_estimate(equal);
    ASSERT_EQ(pooled.size(), 2U);
    EXPECT_EQ(pooled[0].points, 2);
    EXPECT_EQ(pooled[0].trials, 20);
    EXPECT_EQ(pooled[0].probability(), 0.2);
    EXPECT_TRUE(testing::near(pooled[0].from, 1, testing::exact_formula));
    EXPECT_TRUE(testing::near(pooled[0].to, 2, testing::exact_formula));

    std::array const falling{point(1, 10, 2), point(2, 10, 2), point(3, 10, 6), point(4, 20, 4)};
    auto const blocks = isotonic_estimate(falling);
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_EQ(blocks[0].probability(), 0.2);
    EXPECT_TRUE(testing::near(blocks[1].probability(), 1.0 / 3, testing::exact_formula));
}

// Equal neighbours are no levels of their own: nothing is left over to be tested.
TEST(Isotonic, WhatRisesOrStaysHasNothingAgainstIt) {
    std::array const points{point(1, 10, 2), point(2, 10, 2), point(3, 10, 6)};
    auto const test = test_monotone(points);
    EXPECT_EQ(test.degrees_of_freedom, 0);
    EXPECT_NEAR(test.deviance, 0, 1e-12);
}

TEST(Isotonic, MedianIsReachedAtOneHalf) {
    std::array const reached{point(1, 10, 2), point(2, 10, 5), point(3, 10, 8)};
    auto const median = isotonic_median(isotonic_estimate(reached));
    EXPECT_TRUE(testing::near(median.lower, 1, testing::exact_formula));
    EXPECT_TRUE(testing::near(median.upper, 2, testing::exact_formula));

    std::array const never{point(1, 10, 2), point(2, 10, 4)};
    EXPECT_EQ(isotonic_median(isotonic_estimate(never)).upper, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace overturn
