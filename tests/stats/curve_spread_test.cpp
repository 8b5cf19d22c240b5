// Requirement: a beta that a curve hardly has is a line with what it does to HCLPF, one that is a slip is
// refused; usual ones are neither.
#include "stats/curve_spread.hpp"

#include <cmath>

#include "stats/fragility.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

TEST(CurveSpread, UsualOnesGetNoLine) {
    for (double const beta : {0.2, 0.4, 0.6, 0.9}) {
        EXPECT_TRUE(unusual_spread({beta, beta, true, true}).empty()) << beta;
    }
    EXPECT_TRUE(unusual_spread({0.04, 0.03, false, false}).empty()) << "waves that hardly differ, bodies hardly drawn";
    EXPECT_TRUE(unusual_spread({0, 0, false, false}).empty());
}

TEST(CurveSpread, WideAndNarrowOnesGetOne) {
    auto const stated = unusual_spread({0.4, 3, true, true});
    ASSERT_EQ(stated.size(), 1U);
    EXPECT_EQ(stated[0], "beta_U 3 divides HCLPF by 139 (usual: 0.2 to 0.6). Check it: 0.4 for 40 %");
    ASSERT_EQ(unusual_spread({0.4, 0.03, true, true}).size(), 1U) << "too narrow errs to the unsafe side";
    ASSERT_EQ(unusual_spread({1.5, 0.3, false, true}).size(), 1U);
    EXPECT_NE(unusual_spread({1.5, 0, false, false})[0].find("levels' measure"), std::string::npos);
    ASSERT_EQ(unusual_spread({0.4, 1.2, false, false}).size(), 1U);
    EXPECT_NE(unusual_spread({0.4, 1.2, false, false})[0].find("distributions of the body"), std::string::npos);
}

TEST(CurveSpread, SlipsAreRefused) {
    testing::expect_input_error([] { check_spread("--beta-u", 30); }, "--beta-u: 30 (more than 5", "0.4 for 40 %");
    EXPECT_NO_THROW(check_spread("--beta-u", 5));
}

// Every fit whose beta_U is wide says so, before anything but its state.
TEST(CurveSpread, StandsAmongTheWarningsOfAFit) {
    FragilityData data;
    for (double const a : {0.5, 1.0, 2.0}) {
        data.points.push_back({std::log(a), 100, std::round(100 * 0.5 * std::erfc(-std::log(a) / 0.4 / std::sqrt(2)))});
    }
    FragilityRequest request;
    request.beta_u = 3;
    auto const lines = warnings_of(fit_fragility(data, request), {"g", 1}, 0.95);
    ASSERT_FALSE(lines.empty());
    EXPECT_NE(lines.front().find("beta_U 3 divides HCLPF by 139"), std::string::npos) << lines.front();
    request.beta_u = 0.3;
    for (auto const& line : warnings_of(fit_fragility(data, request), {"g", 1}, 0.95)) {
        EXPECT_EQ(line.find("divides"), std::string::npos) << line;
    }
}

}  // namespace
}  // namespace overturn
