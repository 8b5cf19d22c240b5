// Requirement R-906: a campaign says in which quantity its bodies lie outside what was held against real outcomes.
#include "campaign/validated_range.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/campaigns.hpp"

namespace overturn {
namespace {

std::string body(char const* name, double width, double height, char const* more = "") {
    return fmt::format(
        "[[bodies]]\nname='{}'\nmass=354\nbase_width={}\ncentre_height={}\ninertia='uniform-block'\nrestitution=0.9\n{"
        "}",
        name, width, height, more);
}

CampaignSpec spec_of(std::string const& bodies, std::string const& levels = testing::levels("values=[3,6]\n")) {
    return testing::campaign_from(testing::quick_waves + bodies + levels);
}

// A block like those that were tested: alpha .11, p 4.57 rad/s.
TEST(ValidatedRange, HoldsWhatWasTested) {
    auto const spec = spec_of(body("granite", 0.0773, 0.35));
    EXPECT_TRUE(outside_validated_range(spec).empty());
    EXPECT_EQ(validated_range_text(spec),
              "all bodies lie within the range of 245 shaking-table tests of two granite blocks");
}

TEST(ValidatedRange, NamesEveryQuantityThatLeavesIt) {
    auto const lines = outside_validated_range(spec_of(body("granite", 0.0773, 0.35) + body("wide", 0.2, 0.35)
                                                       + body("wide, too", 0.2, 0.35) + body("large", 0.22, 1.0)
                                                       + body("slips", 0.0773, 0.35, "friction=0.5\n")));
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], "wide, wide, too: alpha 15.9 deg (tested: 4.58 to 8.02 deg)");
    EXPECT_EQ(lines[1], "large: p 2.7 rad/s (tested: 4 to 5.4 rad/s)");
    EXPECT_EQ(lines[2], "slips: friction (no test measured it)");
    auto const fast =
        spec_of(body("granite", 0.0773, 0.35), "[levels]\nmeasure='pgv'\nvalues=['50 kine', '120 kine']\n");
    auto const in_degrees =
        spec_of(body("wide", 0.2, 0.35), testing::levels("values=[3,6]\n")
                                             + "[[limits]]\nname='tilts'\nquantity='peak_rotation'\nabove='2 deg'\n");
    EXPECT_EQ(outside_validated_range(in_degrees).at(0), "wide: alpha 15.9 deg (tested: 4.58 to 8.02 deg)");
    ASSERT_EQ(outside_validated_range(fast).size(), 1U);
    EXPECT_EQ(outside_validated_range(fast)[0], "granite: PGV 50 to 120 kine (tested: 1 to 94 kine)");
}

}  // namespace
}  // namespace overturn
