// Requirement R-304: uncertain quantities are drawn from the distribution stated, truncated where it must be.
#include "stats/distribution.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

// Closed forms: the normal deviate of 0.975 is 1.959963984540054.
TEST(Distribution, HasItsQuantiles) {
    constexpr double z = 1.959963984540054;
    EXPECT_TRUE(near(Distribution::normal(10, 2).quantile(0.975), 10 + 2 * z, testing::exact_formula));
    EXPECT_TRUE(
        near(Distribution::lognormal(0.8, 0.1).quantile(0.025), 0.8 * std::exp(-0.1 * z), testing::exact_formula));
    EXPECT_TRUE(near(Distribution::uniform(-1, 3).quantile(0.75), 2, testing::exact_formula));
    EXPECT_EQ(Distribution::fixed(4).quantile(0.9), 4);
    EXPECT_FALSE(Distribution::fixed(4).scatters());
}

// Property: given low <= x <= high, P(x <= q(u)) = u by the untruncated distribution function.
TEST(Distribution, TruncatedKeepsItsShapeWithin) {
    auto const cut = Distribution::normal(0, 1).truncated(-1, 2);
    double const below_low = 0.5 * std::erfc(1 / std::sqrt(2));
    double const below_high = 1 - 0.5 * std::erfc(2 / std::sqrt(2));
    for (double const u : {0.001, 0.2, 0.5, 0.9, 0.999}) {
        double const share = 0.5 * std::erfc(-cut.quantile(u) / std::sqrt(2));
        EXPECT_TRUE(near((share - below_low) / (below_high - below_low), u, testing::exact_formula)) << u;
    }
    EXPECT_GE(cut.lowest(), -1);
    EXPECT_LE(cut.highest(), 2);
    EXPECT_EQ(cut.centre(), 0);
}

TEST(Distribution, ScoreIsTheDeviateOfTheDraw) {
    for (auto const& d : {Distribution::normal(10, 2), Distribution::lognormal(0.8, 0.3), Distribution::uniform(2, 5),
                          Distribution::lognormal(0.9, 0.3).truncated(0, 1)}) {
        EXPECT_NEAR(d.score(d.quantile(0.975)), 1.959963984540054, 1e-9);
        EXPECT_NEAR(d.score(d.quantile(0.5)), 0, 1e-9);
    }
    EXPECT_EQ(Distribution::fixed(3).score(3), 0);
}

TEST(Distribution, ExtremesAreFinite) {
    EXPECT_NEAR(Distribution::normal(0, 1).lowest(), -8.2, 0.1);
    EXPECT_NEAR(Distribution::normal(0, 1).highest(), 8.2, 0.1);
    EXPECT_GT(Distribution::lognormal(1, 2).lowest(), 0);
}

TEST(Distribution, RefusesWhatIsNone) {
    auto const refuse = [](auto make, char const* part) { testing::expect_input_error(make, part, ""); };
    refuse([] { (void)Distribution::normal(1, -1); }, "no normal distribution");
    refuse([] { (void)Distribution::lognormal(0, 1); }, "no lognormal distribution");
    refuse([] { (void)Distribution::uniform(2, 1); }, "no interval");
    refuse([] { (void)Distribution::normal(0, 1).truncated(5, 6); }, "of it lies between");
    refuse([] { (void)Distribution::normal(0, 1).truncated(1, -1); }, "of it lies between");
    refuse([] { (void)Distribution::fixed(3).truncated(0, 1); }, "not between");
}

}  // namespace
}  // namespace overturn
