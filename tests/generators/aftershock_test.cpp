// Requirement: a second shock follows the first after a pause: the first keeps every bit, the second is an
// independent wave of the same source, and a source that draws nothing is refused.
#include "generators/detail/aftershock.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

using testing::source_of;

std::string const noise =
    "source='filtered-noise'\nmodel='kanai-tajimi'\nrms=1\nduration='30 s'\ntime_step='0.01 s'\n"
    "[envelope]\nshape='jennings'\nrise='3 s'\nlevel_end='12 s'\nend='28 s'\n[vertical]\nratio=0.6\n";
std::string const aftershock = "[aftershock]\nscale=0.7\npause='20 s'\n";

double correlation(std::vector<double> const& a, double const* b) {
    double const ab = std::inner_product(a.begin(), a.end(), b, 0.0);
    double const aa = std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
    return ab / std::sqrt(aa * std::inner_product(b, b + a.size(), b, 0.0));
}

TEST(Aftershock, FollowsABitEqualMainshock) {
    auto const plain = source_of(noise);
    auto const both = source_of(noise + aftershock);
    for (std::uint64_t const wave : {0U, 1U, 77U}) {
        for (bool const judged : {true, false}) {
            auto const one = judged ? plain->make(2013, wave) : plain->make_unjudged(2013, wave);
            auto const two = judged ? both->make(2013, wave) : both->make_unjudged(2013, wave);
            std::size_t const n = one.motion.samples();
            ASSERT_EQ(two.motion.samples(), 2 * n + 2000);
            for (auto const component : {&GroundMotion::horizontal_mps2, &GroundMotion::vertical_mps2}) {
                auto const& first = one.motion.*component;
                auto const& whole = two.motion.*component;
                EXPECT_TRUE(std::equal(first.begin(), first.end(), whole.begin()));
                EXPECT_EQ(std::count(whole.begin() + static_cast<std::ptrdiff_t>(n),
                                     whole.begin() + static_cast<std::ptrdiff_t>(n) + 2000, 0.0),
                          2000);
                EXPECT_LT(std::abs(correlation(first, whole.data() + n + 2000)), 0.35);
            }
            EXPECT_EQ(two.motion.horizontal_mps2, both->make(2013, wave).motion.horizontal_mps2);
        }
    }
}

// Of as many shocks the second ones have the variance of the first times the square of their scale.
TEST(Aftershock, HasTheSourcesOwnDistributionTimesItsScale) {
    auto const both = source_of(noise + aftershock);
    double first = 0;
    double second = 0;
    constexpr int waves = 60;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const motion = both->make_unjudged(7, wave).motion.horizontal_mps2;
        auto const n = static_cast<std::ptrdiff_t>((motion.size() - 2000) / 2);
        first += std::inner_product(motion.begin(), motion.begin() + n, motion.begin(), 0.0);
        second += std::inner_product(motion.end() - n, motion.end(), motion.end() - n, 0.0);
    }
    EXPECT_NEAR(second / first, 0.49, 0.05);
}

TEST(Aftershock, IsRefusedWhereNothingIsDrawnOrNothingIsStated) {
    auto const refuse = [](std::string const& keys, char const* part) {
        testing::expect_input_error([&] { (void)source_of(keys); }, "c.toml:", part);
    };
    refuse("source='pulse'\nshape='one-sine'\namplitude=1\ntime_step='0.01 s'\nperiods=['1 s']\n" + aftershock,
           "of waves that are not drawn");
    refuse(noise + "[aftershock]\nscale=0.7\n", "pause");
    refuse(noise + "[aftershock]\nscale=0\npause=1\n", "scale");
    refuse(noise + "[aftershock]\npause=1\ncount=2\n", "count");
}

}  // namespace
}  // namespace overturn
