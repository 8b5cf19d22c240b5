// Requirement R-708: measures are compared by rank, ties and shared waves included, as pairs counted one by one would.
#include "stats/rank.hpp"

#include <cmath>
#include <numeric>

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

/// Any rising function of the measure ranks alike.
TEST(RankArea, KnowsOrderOnly) {
    auto bent = some;
    for (auto& trial : bent) {
        trial.intensity = std::exp(3 * trial.intensity);
    }
    EXPECT_EQ(rank_area(bent), rank_area(some));
    // One key draws the same waves; some draws lack one kind of outcome in both.
    auto const drawn = rank_area_replicates(some, {5, 0, 50});
    auto const bent_drawn = rank_area_replicates(bent, {5, 0, 50});
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
    for (double const area : rank_area_replicates(one, {5, 0, 10})) {
        EXPECT_EQ(area, rank_area(one));
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

}  // namespace
}  // namespace overturn
