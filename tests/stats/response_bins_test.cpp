// Requirement R-708: V_resp is set against V_WES in numbers, with and without slip, so that a plateau can be seen or
// refuted.
#include "stats/response_bins.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

TEST(ResponseBins, SortTrialsByWhatWasOffered) {
    std::vector<ResponseTrial> const trials{{0.9, 0.1, false, false}, {1.0, 0.2, false, false},
                                            {1.1, 0.3, false, false}, {1.2, 0.0, true, false},
                                            {1.2, 1.0, false, true},  {7.0, 1.0, true, true}};
    auto const bins = response_bins(trials);

    ASSERT_EQ(bins.size(), 3);
    EXPECT_EQ(bins[0].from, 0.75);
    EXPECT_EQ(bins[0].without_slip->count, 1);
    EXPECT_FALSE(bins[0].with_slip);
    EXPECT_EQ(bins[1].from, 1) << "an edge belongs to the bin above it";
    EXPECT_EQ(bins[1].without_slip->count, 2);
    EXPECT_EQ(bins[1].without_slip->lowest, 0.2);
    EXPECT_EQ(bins[1].without_slip->highest, 0.3);
    EXPECT_TRUE(std::isnan(bins[1].without_slip->median)) << "of two";
    EXPECT_EQ(bins[1].with_slip->highest, 0.0);
    EXPECT_EQ(bins[1].overturned, 1) << "and is no part of the quantiles of what stood";
    EXPECT_FALSE(bins[2].without_slip);
    EXPECT_EQ(bins[2].overturned, 1);
    EXPECT_TRUE(std::isinf(bins[2].to));
    EXPECT_TRUE(response_bins({}).empty());
}

/// A response that follows what is offered rises through the bins; one that is cut off at a level does not.
TEST(ResponseBins, ShowAPlateauWhereThereIsOne) {
    std::vector<ResponseTrial> trials;
    constexpr double plateau = 0.6;
    for (int i = 0; i < 400; ++i) {
        double const offered = 0.005 * i;
        trials.push_back({offered, offered / 2, false, false});
        trials.push_back({offered, std::min(offered / 2, plateau), true, false});
    }
    auto const bins = response_bins(trials);

    EXPECT_NEAR(bins.back().without_slip->median, 0.9375, 0.002);
    EXPECT_EQ(bins.back().with_slip->median, plateau);
    EXPECT_EQ(bins[bins.size() - 2].with_slip->median, plateau);
    EXPECT_EQ(bins[1].with_slip->median, bins[1].without_slip->median);
}

}  // namespace
}  // namespace overturn
