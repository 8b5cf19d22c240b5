// Requirement: a hazard curve that is hardly one of a year, or in another unit than it says, is read and
// noted; a site's own is not doubted.
#include <algorithm>

#include <gtest/gtest.h>

#include "results/hazard_table.hpp"

namespace overturn {
namespace {

HazardAxis const over_pga{"pga", Dimension::acceleration, {"g", g0}, 0.2 * g0, 1.5 * g0};

std::vector<std::string> remarks(std::string const& table, HazardAxis const& axis = over_pga) {
    return parse_hazard(table, "h.csv", axis).remarks();
}
void expect_one(std::string const& table, std::string const& part, HazardAxis const& axis = over_pga) {
    auto const lines = remarks(table, axis);
    EXPECT_EQ(lines.size(), 1U) << table;
    EXPECT_TRUE(
        std::ranges::any_of(lines, [&](std::string const& line) { return line.find(part) != std::string::npos; }))
        << part << " in " << (lines.empty() ? "nothing" : lines.front());
}

TEST(UnusualHazard, SitesGetNoLine) {
    for (auto const* quiet_active_and_coarse :
         {"0.01, 1e-2\n0.05, 1e-4\n0.5, 1e-6\n1.5, 1e-7\n", "0.05, 0.3\n0.5, 1e-2\n1.5, 1e-4\n4, 1e-6\n",
          "0.1, 1e-3\n2, 1e-6\n", "0.2, 2e-3\n0.3, 1e-3\n0.6, 4e-4\n"}) {
        EXPECT_TRUE(remarks(std::string("pga [g], annual_exceedance\n") + quiet_active_and_coarse).empty())
            << quiet_active_and_coarse;
    }
    HazardAxis const slow{"sa(3 s)", Dimension::acceleration, {"g", g0}, 0.05 * g0, 0.5 * g0};
    EXPECT_TRUE(remarks("sa(3 s) [g], annual_exceedance\n0.001, 1e-2\n0.02, 1e-4\n0.5, 1e-7\n", slow).empty());
}

TEST(UnusualHazard, RatesThatAreNoneOfAYear) {
    expect_one("pga [g], annual_exceedance\n0.1, 1000\n0.5, 1e-3\n2, 1e-6\n",
               "it begins at 1e+03 exceedances a year of pga 0.1 g");
    expect_one("pga [g], annual_exceedance\n0.1, 0.5\n0.2, 0.2\n0.5, 0.1\n",
               "it ends at 0.1 exceedances a year of pga 0.5 g");
    expect_one("pga [g], annual_exceedance\n0.1, 3e-10\n0.5, 1e-12\n2, 1e-13\n", "it begins at 3e-10 exceedances");
}

// Numbers in g under a name that says gal, where levels begin low enough to overlap; and the reverse.
TEST(UnusualHazard, IntensitiesInAnotherUnit) {
    HazardAxis low = over_pga;
    low.lowest = 0.001 * g0;
    low.highest = 0.01 * g0;
    expect_one("pga [gal], annual_exceedance\n0.1, 1e-2\n0.9, 1e-4\n9, 1e-7\n",
               "0.9 gal of pga is exceeded 1e-4 times a year (more on any site)", low);
    expect_one("pga [g], annual_exceedance\n0.1, 1e-2\n5, 1e-4\n20, 1e-6\n",
               "5 g of pga is exceeded 1e-4 times a year (less on any site)");
}

TEST(UnusualHazard, CurvesThatHardlyMeetTheLevels) {
    expect_one("pga [g], annual_exceedance\n0.01, 1e-2\n0.1, 1e-4\n0.25, 1e-6\n", "it covers 11 % of 0.2 g to 1.5 g");
}

}  // namespace
}  // namespace overturn
