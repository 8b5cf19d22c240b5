// Requirement: a beta that a curve hardly has is a line with what it does to HCLPF, one that is a slip is
// refused; usual ones are neither.
#include "output/curve_spread.hpp"

#include "support/expect_input_error.hpp"

namespace overturn::output {
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
    overturn::testing::expect_input_error([] { check_spread("--beta-u", 30); }, "--beta-u: 30 (more than 5",
                                          "0.4 for 40 %");
    EXPECT_NO_THROW(check_spread("--beta-u", 5));
}

}  // namespace
}  // namespace overturn::output
