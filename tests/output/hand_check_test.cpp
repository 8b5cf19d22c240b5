// Requirement: a level by hand above the simulated median errs to the unsafe side, and is marked so
// wherever it is printed.
#include "results/hand_check.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "output/package_text.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

constexpr double by_hand_mps2 = 6;

BodyAnalysis curve_with_median(double median) {
    BodyAnalysis body;
    body.body = "type-b";
    body.fragility.emplace_back();
    body.fragility.front().fit.line = ProbitLine{-std::log(median) / 0.3, 1 / 0.3};
    return body;
}

CampaignSpec campaign() {
    return testing::campaign_from(testing::quick_waves + testing::type_b + testing::levels("values=[4, 5, 8]\n"));
}

// \param fallen of ten trials at 4, 5 and 8 m/s2
HandCheck checked_by(BodyAnalysis const& body, std::array<int, 3> fallen = {}) {
    auto const spec = campaign();
    Statistics statistics(spec);
    for (std::int32_t level = 0; level < 3; ++level) {
        for (std::int64_t wave = 0; wave < 10; ++wave) {
            TrialRow trial;
            trial.wave = wave;
            trial.level = level;
            trial.verdict = wave < fallen.at(static_cast<std::size_t>(level)) ? Verdict::overturned : Verdict::rocked;
            statistics.add(trial);
        }
    }

    std::vector<HandCheck> checks(1);
    checks.front().body = "type-b";
    checks.front().overturning_level = by_hand_mps2;
    compare(checks, statistics, std::span(&body, 1));
    return checks.front();
}

TEST(HandCheck, IsUnsafeAboveTheSimulatedMedian) {
    EXPECT_TRUE(checked_by(curve_with_median(5)).is_unsafe());
    EXPECT_NEAR(*checked_by(curve_with_median(5)).simulated_median, 5, 1e-12);
    EXPECT_FALSE(checked_by(curve_with_median(7)).is_unsafe());
    auto without = curve_with_median(5);
    without.fragility.front().fit.line.reset();
    EXPECT_FALSE(checked_by(without).is_unsafe()) << "nothing to compare with";
    EXPECT_FALSE(checked_by(without).simulated_median.has_value());
    EXPECT_TRUE(checked_by(without, {0, 5, 10}).is_unsafe()) << "half fell at 5 m/s2";
    EXPECT_EQ(checked_by(without, {0, 5, 10}).simulated_median, 5);
    EXPECT_FALSE(checked_by(without, {0, 4, 10}).is_unsafe()) << "half fell at 8 m/s2 only";
    auto other = curve_with_median(5);
    other.body = "type-a";
    EXPECT_FALSE(checked_by(other).is_unsafe()) << "another body's";
}

TEST(HandCheck, SaysSoBeforeItsNumber) {
    auto const spec = campaign();
    auto const line = [&](double median) {
        auto const check = checked_by(curve_with_median(median));
        return output::hand_check_lines(spec, std::span(&check, 1)).back();
    };
    EXPECT_TRUE(line(5).starts_with("type-b: unsafe, do not quote (half overturn at ")) << line(5);
    EXPECT_TRUE(line(7).starts_with("type-b: overturns above ")) << line(7);
}

// both are levels that the body withstands: rounded down, whatever is nearest.
TEST(HandCheck, RoundsLevelsDown) {
    auto const spec = campaign();
    auto check = checked_by(curve_with_median(5));
    check.overturning_level = 5.99996;
    check.simulated_median = 4.99996;
    auto const line = output::hand_check_lines(spec, std::span(&check, 1)).back();
    EXPECT_NE(line.find("half overturn at 4.999 m/s2 by"), std::string::npos) << line;
    EXPECT_NE(line.find("overturns above pga 5.999 m/s2 ("), std::string::npos) << line;
}

}  // namespace
}  // namespace overturn
