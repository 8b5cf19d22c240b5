// Requirement R-707: where levels or hazard curve end, the annual frequency is bounded by what they allow there.
#include "stats/hazard_bounds.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

HazardCurve const of_two({{0.5, 8e-3}, {4, 8e-3 / 512}});  // slope 3
constexpr double k = 3;

// Cornell (1996): of a power law that goes on at both ends.
TEST(FrequencyBounds, ContinuedPowerLawIsTheClosedForm) {
    for (double const median : {0.2, 1.0, 3.0, 20.0}) {
        for (double const beta : {0.1, 0.4, 0.8}) {
            double const closed = 1e-3 * std::pow(median, -k) * std::exp(k * k * beta * beta / 2);
            EXPECT_NEAR(continued_frequency(of_two, {median, beta}) / closed, 1, 1e-9) << median << ", " << beta;
        }
        EXPECT_NEAR(continued_frequency(of_two, {median, 0}) / (1e-3 * std::pow(median, -k)), 1, 1e-9) << median;
    }
    HazardCurve const flat({{0.1, 8e-3}, {0.5, 8e-3}, {4, 8e-3 / 512}});  // saturated: no more of weaker motions
    auto const bounded = annual_frequency(flat, {0.05, 0.1});
    EXPECT_NEAR(continued_frequency(flat, {0.05, 0.1}), bounded.annual + bounded.beyond_least, 1e-12);
}

// A wide curve lets the endless weak motions of a power law pass: exp(k^2 beta^2 / 2) is 6.6e7 of slope 3 and beta 2.
// No more of them count than down to the one that is exceeded once a year.
TEST(FrequencyBounds, NoMoreThanAMotionAYearIsAdded) {
    LognormalFragility const wide{2, 2};
    double const endless = continued_frequency(of_two, wide);
    ASSERT_GT(endless, 1e3);
    EXPECT_DOUBLE_EQ(weaker_motions(of_two), 1 - 8e-3);
    auto const bounds = frequency_bounds(of_two, wide, {1, 4, 0});
    EXPECT_DOUBLE_EQ(bounds.weaker_most, 1 - 8e-3);
    EXPECT_LE(bounds.most(), 1);
    EXPECT_LE(continued_frequency(of_two, wide, weaker_motions(of_two)), 1);
    // A usual curve keeps its own integral, below that.
    LognormalFragility const usual{2, 0.4};
    EXPECT_EQ(continued_frequency(of_two, usual, weaker_motions(of_two)), continued_frequency(of_two, usual));
    EXPECT_DOUBLE_EQ(weaker_motions(HazardCurve({{0.5, 5}, {4, 1e-3}})), 5) << "of a curve that begins above";
}

// A step between the levels is known to pass as often as it is exceeded, whatever lies outside.
TEST(FrequencyBounds, AStepWithinTheLevelsIsKnown) {
    auto const bounds = frequency_bounds(of_two, {2, 0}, {1, 3, 0});
    EXPECT_NEAR(bounds.least(), 1e-3 / 8, 1e-15);
    EXPECT_NEAR(bounds.most(), 1e-3 / 8, 1e-15);
    // Above the levels it may be anywhere from there on: never, or always.
    auto const above = frequency_bounds(of_two, {3.5, 0}, {1, 3, 0});
    EXPECT_EQ(above.least(), 0);
    EXPECT_NEAR(above.most(), 1e-3 / 27, 1e-15);
    EXPECT_DOUBLE_EQ(above.top, 3);
}

TEST(FrequencyBounds, EachPartIsWhatItsEndAllows) {
    LognormalFragility const fragility{2, 0.4};
    auto const bounds = frequency_bounds(of_two, fragility, {1, 8, 0});
    double const last = 1e-3 / 64;
    EXPECT_DOUBLE_EQ(bounds.top, 4);
    EXPECT_NEAR(bounds.above_most, last, 1e-15);
    EXPECT_NEAR(bounds.above_least, fragility.probability(4) * last, 1e-15);
    EXPECT_NEAR(bounds.below_most, fragility.probability(1) * (8e-3 - 1e-3), 1e-15);
    EXPECT_NEAR(bounds.within, annual_between(of_two, fragility, 1, 4), 1e-15);
    // No motion below 0.8 moves it, and none is weaker than the curve's first point that does.
    auto const quiet = frequency_bounds(of_two, fragility, {1, 8, 0.8});
    EXPECT_NEAR(quiet.below_most, fragility.probability(1) * (1e-3 / 0.512 - 1e-3), 1e-15);
    EXPECT_EQ(quiet.weaker_most, 0);
    // Weaker ones: of the whole power law what is left.
    double const whole = continued_frequency(of_two, fragility);
    auto const inside = annual_frequency(of_two, fragility);
    HazardCurve const longer({{0.5, 8e-3}, {4, last}, {400, last * 1e-6}});
    double const stronger = annual_frequency(longer, fragility).annual - inside.annual;
    EXPECT_NEAR(bounds.weaker_most / (whole - inside.annual - stronger), 1, 1e-4);
    EXPECT_NEAR(frequency_bounds(of_two, fragility, {1, 8, 0.3}).weaker_most,
                annual_between(HazardCurve({{0.3, 1e-3 / 0.027}, {4, last}}), fragility, 0.3, 0.5), 1e-12);
}

// Whatever the hazard does beyond its end, what was bounded before holds it.
TEST(FrequencyBounds, AProlongedHazardLiesInside) {
    std::vector<HazardPoint> const to_two{{0.05, 1e-2}, {0.1, 2e-3}, {0.3, 1e-4}, {0.5, 2.5e-5}, {1, 3e-6}, {2, 3e-7}};
    HazardCurve const ended(to_two);
    for (auto const& beyond : {HazardPoint{8, 3e-9}, HazardPoint{8, 2.9e-7}, HazardPoint{2.1, 1e-12}}) {
        auto points = to_two;
        points.push_back(beyond);
        HazardCurve const prolonged(points);
        for (double const median : {0.4, 1.0, 2.0, 5.0}) {
            for (double const beta : {0.2, 0.6}) {
                for (double const highest : {0.9, 2.0, 3.0, 10.0}) {
                    TriedRange const tried{0.2, highest, 0};
                    auto const first = frequency_bounds(ended, {median, beta}, tried);
                    auto const second = frequency_bounds(prolonged, {median, beta}, tried);
                    constexpr double rounding = 1e-12;
                    EXPECT_GE(second.least(), first.least() * (1 - rounding)) << median << ", " << highest;
                    EXPECT_LE(second.most(), first.most() * (1 + rounding)) << median << ", " << highest;
                    EXPECT_LE(second.least(), second.most());
                }
            }
        }
    }
}

// Two points over four decades: their straight line is nearly all of the answer.
TEST(FrequencyBounds, AStraightLineThatDecidesIsNumbered) {
    LognormalFragility const fragility{9, 0.35};
    HazardCurve const two({{1, 2e-2}, {20, 1.3e-6}});
    auto const wide = widest_piece(two, fragility);
    ASSERT_TRUE(wide.has_value());
    EXPECT_NEAR(wide->decades, std::log10(2e-2 / 1.3e-6), 1e-12);
    EXPECT_NEAR(wide->halfway, std::sqrt(20.0), 1e-12);
    HazardCurve const bent({{1, 2e-2}, {std::sqrt(20.0), 2 * std::sqrt(2e-2 * 1.3e-6)}, {20, 1.3e-6}});
    auto const other = annual_frequency(bent, fragility);
    EXPECT_NEAR(wide->if_doubled / (other.annual + other.beyond_least), 1, 1e-12);
    EXPECT_GT(wide->share, 0.95);
    HazardCurve const fine({{1, 2e-2}, {3, 8e-4}, {6, 1e-4}, {10, 2e-5}, {20, 1.3e-6}});
    EXPECT_FALSE(widest_piece(fine, fragility).has_value());
}

// Towards weaker motions a hazard curve goes on at its steepest slope within a factor of 2: down to where nothing
// moves, or, where it begins amid the levels, down to one motion a year, or to the lowest level.
TEST(FrequencyBounds, AHazardThatBeginsAmidTheLevelsGoesOn) {
    EXPECT_EQ(from_lower_on(of_two, {1, 3, 0}).points().size(), 2U);  // it begins below the levels
    auto const yearly = from_lower_on(of_two, {0.4, 3, 0});
    EXPECT_NEAR(yearly.first(), 0.1, 1e-12);  // 1e-3 / 0.1^3 is one a year
    EXPECT_NEAR(yearly.points().front().annual_exceedance, 1, 1e-12);
    auto const lowest = from_lower_on(of_two, {0.05, 3, 0});
    EXPECT_NEAR(lowest.first(), 0.05, 1e-12);
    EXPECT_NEAR(lowest.points().front().annual_exceedance, 8, 1e-12);
    auto const known = from_lower_on(of_two, {1, 3, 0.25});
    EXPECT_NEAR(known.first(), 0.25, 1e-12);
    EXPECT_NEAR(known.points().front().annual_exceedance, 64e-3, 1e-12);
    EXPECT_EQ(from_lower_on(of_two, {0.4, 3, 0.6}).points().size(), 2U);
    HazardCurve const flat({{0.1, 8e-3}, {0.5, 8e-3}, {4, 8e-3 / 512}});
    EXPECT_NEAR(from_lower_on(flat, {0.05, 1, 0}).points().front().annual_exceedance, 8e-3, 1e-15);
}

// A first piece that is flat, short or too gentle does not make what begins amid the levels rarer than the whole
// curve.
TEST(FrequencyBounds, AFlatOrShortStartBoundsTheWholeCurve) {
    std::vector<HazardPoint> const from_600{{6, 1e-4}, {10, 2e-5}, {20, 1.3e-6}};
    auto with = [&](std::vector<HazardPoint> first) {
        first.insert(first.end(), from_600.begin() + 1, from_600.end());
        return HazardCurve(std::move(first));
    };
    HazardCurve const whole = with({{1, 2e-2}, {3, 8e-4}, {6, 1e-4}});
    TriedRange const tried{2, 13, 0};
    for (double const median : {6.0, 9.0, 12.0}) {
        LognormalFragility const fragility{median, 0.4};
        double const truth = frequency_bounds(whole, fragility, tried).within;
        for (auto const& start :
             {std::vector<HazardPoint>{{6, 1e-4}, {6.005, 1e-4}}, {{6, 1e-4}, {6.2, 0.99e-4}}, {{6, 1e-4}}}) {
            EXPECT_GT(frequency_bounds(with(start), fragility, tried).most(), truth) << median;
        }
        HazardCurve const two({{6, 1e-4}, {6.001, 0.9999e-4}});
        EXPECT_GT(frequency_bounds(two, fragility, tried).most(), truth) << median;
        EXPECT_GT(from_lower_on(two, tried).points().front().annual_exceedance, whole.annual_exceedance(2));
    }
}

}  // namespace
}  // namespace overturn
