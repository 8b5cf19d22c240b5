// Requirement R-405: no root of a step's polynomial is missed or found twice, however close they lie.
#include "core/polynomial.hpp"

#include <gtest/gtest.h>

namespace overturn {
namespace {

using Cubic = std::array<double, 4>;

TEST(Polynomial, FindsAllRootsOfACubic) {
    Cubic const c{-0.006, 0.11, -0.6, 1.0};  // (t - 0.1)(t - 0.2)(t - 0.3)

    auto const roots = roots_in(c, 0.0, 1.0);

    ASSERT_EQ(roots.count, 3U);
    EXPECT_NEAR(roots.at[0], 0.1, 1e-15);
    EXPECT_NEAR(roots.at[1], 0.2, 1e-14);
    EXPECT_NEAR(roots.at[2], 0.3, 1e-15);
}

TEST(Polynomial, FindsTwoRootsBetweenEqualSigns) {
    Cubic const c{0.25 - 1e-12, -1.0, 1.0, 0.0};  // two roots 1e-6 either side of 0.5

    auto const roots = roots_in(c, 0.0, 1.0);

    ASSERT_EQ(roots.count, 2U);
    EXPECT_NEAR(roots.at[0], 0.5 - 1e-6, 1e-10);
    EXPECT_NEAR(roots.at[1], 0.5 + 1e-6, 1e-10);
}

TEST(Polynomial, ARootAtTheStartIsNotFoundAgain) {
    Cubic const c{0.0, 1.0, -2.0, 0.0};  // roots 0 and 0.5

    auto const roots = roots_in(c, 0.0, 1.0);

    ASSERT_EQ(roots.count, 1U);
    EXPECT_NEAR(roots.at[0], 0.5, 1e-15);
}

TEST(Polynomial, ARootAtTheEndIsFound) {
    Cubic const c{-1.0, 1.0, 0.0, 0.0};

    EXPECT_EQ(roots_in(c, 0.0, 1.0).count, 1U);
}

// An interval that does not begin at zero, and a root at its end that the bound only just reaches.
TEST(Polynomial, RootsAreFoundWhereverTheIntervalLies) {
    Cubic const c{-0.006, 0.11, -0.6, 1.0};  // roots 0.1, 0.2, 0.3
    EXPECT_EQ(roots_in(c, 0.15, 0.25).count, 1U);
    EXPECT_EQ(roots_in(c, 0.31, 9.0).count, 0U);

    Cubic const mirrored{-0.006, -0.11, -0.6, -1.0};  // roots -0.3, -0.2, -0.1
    EXPECT_EQ(roots_in(mirrored, -1.0, 0.0).count, 3U);
    EXPECT_EQ(roots_in(mirrored, -0.25, 0.5).count, 2U);

    Cubic const rising{-3.0, 1.0, 1.0, 1.0};  // root 1
    EXPECT_EQ(roots_in(rising, 0.0, 1.0).count, 1U);
    EXPECT_EQ(roots_in(rising, 0.0, 1 - 1e-15).count, 0U);
}

TEST(Polynomial, TailBoundHolds) {
    Cubic const c{1.0, -2.0, 3.0, -4.0};
    for (double t = 0; t <= 0.5; t += 0.01) {
        EXPECT_LE(std::abs(evaluate(c, t) - 1.0), tail_bound(c, 1, 0.5));
    }
}

}  // namespace
}  // namespace overturn
