// Requirement: stripes and the criterion's matrix count, and failed trials never pass for stable ones.
#include "stats/stripe.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

// R-1104.
TEST(Stripe, FailedTrialsAreLeftOutOfTheProportion) {
    Stripe const stripe{.amplitude = 6, .trials = 12, .overturned = 5, .failed = 2};

    EXPECT_EQ(stripe.decided(), 10);
    EXPECT_EQ(stripe.probability(), 0.5);
    // The undecided may have stood or fallen: the bounds hold either way.
    EXPECT_EQ(stripe.interval(0.95).lower, clopper_pearson(5, 12, 0.95).lower);
    EXPECT_EQ(stripe.interval(0.95).upper, clopper_pearson(7, 12, 0.95).upper);
}

TEST(Stripe, NothingDecidedReportsNothing) {
    Stripe const stripe{.amplitude = 6, .trials = 3, .failed = 3};

    EXPECT_EQ(stripe.decided(), 0);
    EXPECT_TRUE(std::isnan(stripe.probability())) << "an estimate from nothing would be made up";
    EXPECT_EQ(stripe.interval(0.95).lower, 0);
    EXPECT_EQ(stripe.interval(0.95).upper, 1);
}

TEST(Confusion, EveryTrialFallsIntoItsCell) {
    Confusion confusion;
    confusion.add(true, true);
    for (int i = 0; i < 2; ++i) {
        confusion.add(false, false);
    }
    for (int i = 0; i < 3; ++i) {
        confusion.add(true, false);
    }
    for (int i = 0; i < 4; ++i) {
        confusion.add(false, true);
    }

    EXPECT_EQ(confusion.false_safe, 1);
    EXPECT_EQ(confusion.false_alarm, 2);
    EXPECT_EQ(confusion.true_safe, 3);
    EXPECT_EQ(confusion.true_overturn, 4);
}

}  // namespace
}  // namespace overturn
