// Requirement R-701: intervals of proportions are the exact ones, from no trial at all to a million of them.
#include "stats/proportion.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;
using testing::Tolerance;

constexpr Tolerance inverted{1e-9, "inverted"};
constexpr Tolerance of_a_million{1e-7, "of_a_million"};  ///< their log factorials lose seven digits against each other

struct Count {
    std::int64_t successes, trials;
};

class ClopperPearson : public ::testing::TestWithParam<Count> {};

/// Their definition: at each bound, the binomial tail beyond what was seen holds exactly half of what confidence
/// leaves.
TEST_P(ClopperPearson, BoundsLeaveTheirShareInEachTail) {
    auto const [k, n] = GetParam();
    auto const seen = static_cast<unsigned>(k);
    auto const tried = static_cast<unsigned>(n);
    auto const& allowed = n < 100000 ? inverted : of_a_million;
    for (double const confidence : {0.5, 0.9, 0.95, 0.99, 0.999}) {
        auto const interval = clopper_pearson(k, n, confidence);
        double const tail = (1 - confidence) / 2;

        if (k > 0) {
            EXPECT_TRUE(near(gsl_cdf_binomial_Q(seen - 1, interval.lower, tried), tail, allowed)) << confidence;
        } else {
            EXPECT_EQ(interval.lower, 0);
        }
        if (k < n) {
            EXPECT_TRUE(near(gsl_cdf_binomial_P(seen, interval.upper, tried), tail, allowed)) << confidence;
        } else {
            EXPECT_EQ(interval.upper, 1);
        }
    }
}

// GSL's inverse of the beta distribution does not converge for 3 of 300 at 99 % and for 1 of 1000 at 99.9 %.
INSTANTIATE_TEST_SUITE_P(Counts, ClopperPearson,
                         ::testing::Values(Count{0, 1}, Count{1, 1}, Count{1, 2}, Count{0, 40}, Count{1, 40},
                                           Count{20, 40}, Count{39, 40}, Count{40, 40}, Count{997, 1000},
                                           Count{3, 1000000}, Count{500000, 1000000}, Count{999999, 1000000}),
                         [](auto const& info) {
                             return std::to_string(info.param.successes) + "_of_" + std::to_string(info.param.trials);
                         });

TEST(ClopperPearsonEnds, NoneAndAllHaveClosedForms) {
    for (std::int64_t const n : {1, 10, 59, 1000, 1000000}) {
        for (double const confidence : {0.8, 0.95}) {
            double const bound = -std::expm1(std::log((1 - confidence) / 2) / static_cast<double>(n));

            EXPECT_TRUE(near(clopper_pearson(0, n, confidence).upper, bound, inverted)) << n;
            EXPECT_TRUE(near(1 - clopper_pearson(n, n, confidence).lower, bound, inverted)) << n;
        }
    }
}

/// A one-sided 95 % bound is the upper end of the two-sided 90 % interval: the "rule of three".
TEST(ClopperPearsonEnds, NoneOfManyIsBelowThreeOverN) {
    for (std::int64_t const n : {100, 10000}) {
        double const bound = clopper_pearson(0, n, 0.90).upper;

        EXPECT_LT(bound, 3.0 / static_cast<double>(n));
        EXPECT_TRUE(near(bound, 3.0 / static_cast<double>(n), testing::published));
    }
}

TEST(ClopperPearsonEnds, NothingTriedReportsNothing) {
    auto const interval = clopper_pearson(0, 0, 0.95);

    EXPECT_EQ(interval.lower, 0);
    EXPECT_EQ(interval.upper, 1);
}

TEST(ClopperPearsonEnds, SuccessAndMissAreMirrorImages) {
    auto const some = clopper_pearson(7, 50, 0.95);
    auto const rest = clopper_pearson(43, 50, 0.95);

    EXPECT_TRUE(near(some.lower, 1 - rest.upper, inverted));
    EXPECT_TRUE(near(some.upper, 1 - rest.lower, inverted));
}

#if OVERTURN_CHECKED
TEST(ClopperPearsonEnds, ImpossibleCountsAreOurMistake) {
    EXPECT_THROW((void)clopper_pearson(3, 2, 0.95), ContractError);
    EXPECT_THROW((void)clopper_pearson(-1, 2, 0.95), ContractError);
    EXPECT_THROW((void)clopper_pearson(1, 2, 1.0), ContractError);
}
#endif

}  // namespace
}  // namespace overturn
