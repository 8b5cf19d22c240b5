// Requirement R-708: measures are compared by rank, ties and shared waves included, as pairs counted one by one would.
#include "stats/rank.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "stats/quantile.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

double counted_in_pairs(std::vector<SingleTrial> const& trials) {
    double above = 0, pairs = 0;
    for (auto const& fell : trials) {
        for (auto const& stood : trials) {
            if (fell.overturned && !stood.overturned) {
                ++pairs;
                above += fell.intensity > stood.intensity ? 1 : fell.intensity == stood.intensity ? 0.5 : 0;
            }
        }
    }
    return above / pairs;
}

std::vector<SingleTrial> const some{{1, 0, false}, {2, 0, true},  {2, 1, false}, {3, 1, false},
                                    {3, 2, true},  {3, 2, false}, {4, 3, true},  {0.5, 3, true}};

TEST(RankArea, CountsPairs) {
    EXPECT_EQ(rank_area(some), counted_in_pairs(some));
    EXPECT_EQ(rank_area(points_of(some, 8)), counted_in_pairs(some));
    EXPECT_EQ(rank_area(std::vector<SingleTrial>{{1, 0, false}, {2, 0, true}}), 1);
    EXPECT_EQ(rank_area(std::vector<SingleTrial>{{1, 0, true}, {2, 0, false}}), 0);
    EXPECT_EQ(rank_area(std::vector<SingleTrial>{{2, 0, true}, {2, 1, false}}), 0.5) << "a tie";
    EXPECT_TRUE(std::isnan(rank_area(std::vector<SingleTrial>{{2, 0, true}})));
}

/// Any rising function of the measure gives the same rank.
TEST(RankArea, KnowsOrderOnly) {
    auto bent = some;
    for (auto& trial : bent) {
        trial.intensity = std::exp(3 * trial.intensity);
    }
    EXPECT_EQ(rank_area(bent), rank_area(some));
    // One key draws the same waves; some draws lack one kind of outcome in both.
    auto const drawn = rank_area(some, {5, 0, 50}).replicates;
    auto const bent_drawn = rank_area(bent, {5, 0, 50}).replicates;
    ASSERT_EQ(drawn.size(), 50U);
    for (std::size_t r = 0; r < drawn.size(); ++r) {
        EXPECT_TRUE(drawn[r] == bent_drawn[r] || (std::isnan(drawn[r]) && std::isnan(bent_drawn[r]))) << r;
    }
}

/// Each wave is drawn whole: with one wave every replicate is the data.
TEST(RankArea, ResamplesWaves) {
    std::vector<SingleTrial> one = some;
    for (auto& trial : one) {
        trial.wave = 7;
    }
    for (double const area : rank_area(one, {5, 0, 10}).replicates) {
        EXPECT_EQ(area, rank_area(one));
    }
}

/// Replicates are the pairs of as many waves drawn anew, each with all its trials.
TEST(RankArea, ReplicatesCountPairsOfDrawnWaves) {
    RandomStream stream(3, 0, Purpose::body_scatter, 0);
    for (int const waves : {1, 7, 60}) {
        std::vector<SingleTrial> trials;
        for (int w = 0; w < waves; ++w) {
            for (int i = 0; i < 8; ++i) {
                double const x = 1 + std::floor(20 * gsl_rng_uniform(stream.gsl())) / 4;
                trials.push_back({x, (11 * w) % waves, gsl_rng_uniform(stream.gsl()) < (x - 1.5) / 3, w});
            }
        }
        auto const drawn = rank_area(trials, {9, 2, 37}).replicates;
        ASSERT_EQ(drawn.size(), 37U);
        for (std::size_t r = 0; r < drawn.size(); ++r) {
            RandomStream draws(9, r, Purpose::bootstrap, 2);
            std::vector<SingleTrial> again;
            for (int draw = 0; draw < waves; ++draw) {
                auto const wave =
                    static_cast<std::int64_t>(gsl_rng_uniform_int(draws.gsl(), static_cast<unsigned long>(waves)));
                std::ranges::copy_if(trials, std::back_inserter(again),
                                     [&](SingleTrial const& trial) { return trial.wave == wave; });
            }
            double const counted = counted_in_pairs(again);
            EXPECT_TRUE(drawn[r] == counted || (std::isnan(drawn[r]) && std::isnan(counted))) << r;
        }
    }
}

TEST(Quantiles, UnknownValuesWidenTheInterval) {
    std::vector<double> values;
    for (int i = 1; i <= 99; ++i) {
        values.push_back(i);
    }
    auto const whole = middle_of(values, 0.9, {-1, 1000});
    EXPECT_EQ(whole.lower, 5);  // ranks 5 and 95 of 99: 0.05 (n + 1), 0.95 (n + 1)
    EXPECT_EQ(whole.upper, 95);
    for (int i = 0; i < 8; ++i) {
        values[static_cast<std::size_t>(10 * i)] = std::nan("");
    }
    auto const wider = middle_of(values, 0.9, {-1, 1000});
    EXPECT_EQ(wider.lower, -1);
    EXPECT_EQ(wider.upper, 1000);
    EXPECT_EQ(quantile(std::vector<double>{1, 2, 4}, 0.75), 3);
}

/// A confidence that would need values beyond the outermost ones is not feigned.
TEST(MiddleOf, IsOpenWhereTheValuesAreTooFew) {
    std::vector<double> values(1000);
    std::iota(values.begin(), values.end(), 1.0);

    EXPECT_EQ(middle_of(values, 0.998, {-1, 2000}).lower, 1);
    EXPECT_EQ(middle_of(values, 0.9999, {-1, 2000}).lower, -1);
    EXPECT_EQ(middle_of(values, 0.9999, {-1, 2000}).upper, 2000);
}

// Replicates normal about 0.3 where the estimate is 0, which has a bias of 0.3 then: what they resample has it too.
class MiddleAbout : public ::testing::Test {
  protected:
    MiddleAbout() {
        for (int i = 1; i < count; ++i) {
            values.push_back(bias + gsl_cdf_ugaussian_Pinv(static_cast<double>(i) / count));
        }
    }
    static constexpr int count = 100'000;
    static constexpr double bias = 0.3;
    static constexpr double most = std::numeric_limits<double>::infinity();
    std::vector<double> values;
};

/// Closed form: normal replicates' middle moves to the other side of the estimate, and is as wide as before.
TEST_F(MiddleAbout, TakesTheBiasOff) {
    auto const ends = middle_about(0, values, 0.95, {-most, most});

    EXPECT_NEAR(ends.lower, -bias - 1.959964, 1e-3);
    EXPECT_NEAR(ends.upper, -bias + 1.959964, 1e-3);
}

TEST_F(MiddleAbout, IsThePlainMiddleWhereTheEstimateHalvesThem) {
    auto const plain = middle_of(values, 0.9, {-most, most});
    auto const about = middle_about(bias, values, 0.9, {-most, most});

    EXPECT_NEAR(about.lower, plain.lower, 1e-4);
    EXPECT_NEAR(about.upper, plain.upper, 1e-4);
}

/// An interval of ln x is the logarithm of that of x: nothing hangs on the scale that the estimate is reported in.
TEST_F(MiddleAbout, IsTheSameOnAnyRisingScale) {
    auto const ends = middle_about(0, values, 0.95, {-most, most});
    std::transform(values.begin(), values.end(), values.begin(), [](double x) { return std::exp(x); });
    auto const grown = middle_about(1, values, 0.95, {0, most});

    EXPECT_EQ(grown.lower, std::exp(ends.lower));
    EXPECT_EQ(grown.upper, std::exp(ends.upper));
}

/// Replicates that all lie below their estimate do not say how far above it the truth may be.
TEST(MiddleAboutFew, IsOpenBeyondReplicatesOfOneSide) {
    std::vector<double> values(1000);
    std::iota(values.begin(), values.end(), 1.0);
    auto const ends = middle_about(5000, values, 0.95, {-1, 1e6});

    EXPECT_EQ(ends.upper, 1e6);
    EXPECT_EQ(ends.lower, 1000);
    EXPECT_EQ(middle_about(-5000, values, 0.95, {-1, 1e6}).lower, -1);
    EXPECT_EQ(middle_about(3, {}, 0.95, {-1, 1e6}).upper, 1e6);
}

/// Replicates that all are the estimate halve at it: separated data put every beta at 0, for example.
TEST(MiddleAboutFew, TiesCountHalf) {
    auto const ends = middle_about(2, std::vector<double>(1000, 2.0), 0.95, {-1, 1e6});

    EXPECT_EQ(ends.lower, 2);
    EXPECT_EQ(ends.upper, 2);
}

/// What is unknown widens, and does not shift.
TEST(MiddleAboutFew, UnknownValuesWidenTheInterval) {
    std::vector<double> values(1000);
    std::iota(values.begin(), values.end(), 1.0);
    values[400] = values[599] = std::nan("");
    auto const ends = middle_about(500.5, values, 0.95, {-1, 2000});

    EXPECT_EQ(ends.lower, 23);  // the 25th of all, two of them unknown
    EXPECT_EQ(ends.upper, 978);
}

}  // namespace
}  // namespace overturn
