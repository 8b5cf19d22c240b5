// Requirement R-707: the annual frequency of passing a limit state is the integral of its fragility over a hazard
// curve, with what lies beyond either said.
#include "stats/hazard.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

// A power law k0 a^-k over so many decades about 1, of so many points.
HazardCurve power_law(double k0, double k, int points, double decades = 16) {
    std::vector<HazardPoint> list;
    for (int i = 0; i < points; ++i) {
        double const a = std::pow(10.0, decades * (i / (points - 1.0) - 0.5));
        list.push_back({a, k0 * std::pow(a, -k)});
    }
    return HazardCurve(std::move(list));
}

// Cornell (1996): under k0 a^-k a lognormal fragility is passed k0 median^-k exp(k^2 beta^2 / 2) times a year.
TEST(Hazard, FrequencyUnderAPowerLawIsTheClosedForm) {
    for (double const k : {1.5, 2.5, 4.0}) {
        for (double const beta : {0.1, 0.4, 0.6}) {
            for (int const points : {2, 7, 61}) {
                auto const found = annual_frequency(power_law(1e-4, k, points), {1.7, beta});
                double const closed = 1e-4 * std::pow(1.7, -k) * std::exp(k * k * beta * beta / 2);
                EXPECT_NEAR(found.annual / closed, 1, 1e-6) << k << ", " << beta << ", " << points;
                EXPECT_EQ(found.parts.size(), static_cast<std::size_t>(points - 1));
            }
        }
    }
}

// Pieces of different slope against the trapezoidal sum of a million steps.
TEST(Hazard, FrequencyOverABentCurveIsTheSumOfSmallSteps) {
    HazardCurve const hazard({{0.5, 1e-2}, {1, 2e-3}, {3, 5e-5}, {6, 8e-7}});
    LognormalFragility const fragility{2.4, 0.35};
    double sum = 0;
    constexpr int steps = 1'000'000;
    double before = hazard.annual_exceedance(0.5);
    for (int i = 1; i <= steps; ++i) {
        double const a = 0.5 * std::pow(12.0, static_cast<double>(i) / steps);
        double const now = i == steps ? 8e-7 : hazard.annual_exceedance(a);
        sum += fragility.probability(a / std::pow(12.0, 0.5 / steps)) * (before - now);
        before = now;
    }
    auto const found = annual_frequency(hazard, fragility);
    EXPECT_NEAR(found.annual / sum, 1, 1e-9);
    EXPECT_DOUBLE_EQ(found.beyond_most, 8e-7);
    EXPECT_DOUBLE_EQ(found.beyond_least, 8e-7 * fragility.probability(6));
    EXPECT_DOUBLE_EQ(found.at_first, fragility.probability(0.5));
    auto const shares = shares_of(hazard, fragility, 1, 3);
    EXPECT_NEAR(shares.below, found.parts[0].annual / found.annual, 1e-12);
    EXPECT_NEAR(shares.between, found.parts[1].annual / found.annual, 1e-12);
    EXPECT_NEAR(shares.above, found.parts[2].annual / found.annual, 1e-12);
}

// A steep piece, as where a curve is cut off: all its motions lie at its start.
TEST(Hazard, ASteepPieceIsNotLost) {
    for (double const beta : {0.05, 0.2, 0.6}) {
        for (double const median : {0.7, 2.0, 5.0}) {
            LognormalFragility const fragility{median, beta};
            auto const cut = annual_frequency(HazardCurve({{2, 3e-7}, {2.002, 1e-30}}), fragility);
            EXPECT_GE(cut.annual, fragility.probability(2) * 3e-7 * (1 - 1e-12));
            EXPECT_LE(cut.annual, fragility.probability(2.002) * 3e-7);
        }
    }
}

// A body that falls at one intensity passes as often as motions exceed it.
TEST(Hazard, AStepIsPassedAsOftenAsItIsExceeded) {
    auto const hazard = power_law(1e-4, 2, 13, 4);
    for (double const median : {0.05, 0.3, 2.0, 40.0}) {
        auto const step = annual_frequency(hazard, {median, 0});
        EXPECT_NEAR((step.annual + step.beyond_least) / hazard.annual_exceedance(median), 1, 1e-12);
        EXPECT_NEAR(annual_frequency(hazard, {median, 1e-4}).annual / step.annual, 1, 1e-6);
    }
    EXPECT_EQ(annual_frequency(hazard, {std::numeric_limits<double>::infinity(), 0.3}).annual, 0);
    EXPECT_EQ(annual_frequency(hazard, {1e9, 0.2}).annual, 0) << "no remainder of large numbers";
}

// Stripes of a step at 2: below 1 P is at most u, from 2 on at least 1 - u, where u is the exact upper end of 0 of 100.
TEST(Hazard, StripesBoundTheFrequencyWithoutACurve) {
    HazardCurve const hazard({{0.5, 1e-2}, {1, 2e-3}, {2, 4e-4}, {4, 5e-5}});
    std::vector<FragilityPoint> const stripes{
        {std::log(1.0), 100, 0, 0}, {std::log(2.0), 100, 100, 0}, {std::log(8.0), 100, 100, 0}};
    auto const bounds = annual_frequency_seen(hazard, stripes, 0.95);
    double const u = 1 - std::pow(0.025, 0.01);
    EXPECT_NEAR(bounds.lower, (1 - u) * 4e-4, 1e-15);
    EXPECT_NEAR(bounds.upper, u * (1e-2 - 2e-3) + 2e-3, 1e-15);
    // Nothing fell anywhere: what was seen allows as much as the exact ends, and all beyond what was tried.
    std::vector<FragilityPoint> const calm{{std::log(1.0), 100, 0, 0}, {std::log(2.0), 100, 0, 0}};
    auto const quiet = annual_frequency_seen(hazard, calm, 0.95);
    EXPECT_EQ(quiet.lower, 0);
    EXPECT_NEAR(quiet.upper, u * (1e-2 - 4e-4) + 4e-4, 1e-15);
    // A small stripe among large ones widens nothing that its neighbours hold.
    std::vector<FragilityPoint> const uneven{
        {std::log(1.0), 1000, 300, 0}, {std::log(1.5), 3, 0, 0}, {std::log(2.0), 1000, 400, 0}};
    std::vector<FragilityPoint> const even{uneven[0], uneven[2]};
    auto const three = annual_frequency_seen(hazard, uneven, 0.95);
    auto const two = annual_frequency_seen(hazard, even, 0.95);
    EXPECT_NEAR(three.lower, two.lower, 1e-15);
    EXPECT_NEAR(three.upper, two.upper, 1e-15);
    // A lognormal through finer stripes lies between its own bounds.
    LognormalFragility const fragility{2, 0.3};
    std::vector<FragilityPoint> fine;
    for (double a = 0.5; a < 5; a *= 1.1) {
        fine.push_back({std::log(a), 1e6, std::round(1e6 * fragility.probability(a)), 0});
    }
    auto const close = annual_frequency_seen(hazard, fine, 0.95);
    auto const curve = annual_frequency(hazard, fragility);
    EXPECT_LE(close.lower, curve.annual + curve.beyond_least);
    EXPECT_GE(close.upper, curve.annual + curve.beyond_least);
    EXPECT_LT(close.upper - close.lower, 0.35 * curve.annual);
}

// beta_U that is stated beside the stripes moves their bounds: they are means over bodies that fall at
// exp(beta_U z) times the intensity, here summed over z in fine steps.
TEST(Hazard, StatedBetaUMovesTheBoundsFromStripes) {
    std::vector<HazardPoint> const points{{0.02, 5}, {0.5, 1e-2}, {1, 2e-3}, {2, 4e-4}, {4, 5e-5}, {400, 1e-12}};
    std::vector<FragilityPoint> const stripes{
        {std::log(1.0), 100, 0, 0}, {std::log(2.0), 100, 7, 0}, {std::log(3.0), 100, 60, 0}};
    constexpr double beta_u = 0.4;
    for (double const nothing_below : {0.0, 0.3}) {
        Interval sum{0, 0};
        constexpr double step = 1.0 / 256;
        double weights = 0;
        for (double z = -8; z <= 8; z += step) {
            double const weight = step * std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
            auto weaker = points;
            for (auto& point : weaker) {
                point.intensity *= std::exp(-beta_u * z);
            }
            auto const of_body = annual_frequency_seen(HazardCurve(weaker), stripes, 0.95, nothing_below);
            sum.lower += weight * of_body.lower;
            sum.upper += weight * of_body.upper;
            weights += weight;
        }
        auto const bounds = annual_frequency_seen(HazardCurve(points), stripes, 0.95, nothing_below, beta_u);
        EXPECT_NEAR(weights, 1, 1e-9);
        EXPECT_NEAR(bounds.lower / sum.lower, 1, 1e-6) << nothing_below;
        EXPECT_NEAR(bounds.upper / sum.upper, 1, 1e-6) << nothing_below;
        auto const median_body = annual_frequency_seen(HazardCurve(points), stripes, 0.95, nothing_below);
        EXPECT_GT(bounds.lower, 1.2 * median_body.lower);
    }
}

TEST(Hazard, WhatIsNoHazardCurveIsRefused) {
    expect_input_error([] { HazardCurve({{1, 1e-3}}); }, "at least two");
    expect_input_error([] { HazardCurve({{1, 1e-3}, {1, 1e-4}}); }, "must rise");
    expect_input_error([] { HazardCurve({{1, 1e-3}, {2, 2e-3}}); }, "rarer");
    expect_input_error([] { HazardCurve({{0, 1}, {2, 1e-3}}); }, "intensity 0 with annual exceedance 1", "row out");
    expect_input_error([] { HazardCurve({{1, 1e-3}, {2, 0}}); }, "annual exceedance 0 at intensity 2", "row out");
    // A flat start, of a saturated analysis: nothing happens along it.
    LognormalFragility const fragility{1.7, 0.4};
    auto const flat = annual_frequency(HazardCurve({{0.1, 1e-2}, {1, 1e-2}, {10, 1e-5}}), fragility);
    EXPECT_EQ(flat.parts[0].annual, 0);
    EXPECT_DOUBLE_EQ(flat.annual, annual_frequency(HazardCurve({{1, 1e-2}, {10, 1e-5}}), fragility).annual);
    expect_input_error([] { HazardCurve({{-1, 1e-3}, {2, 1e-4}}); }, "positive");
}

}  // namespace
}  // namespace overturn
