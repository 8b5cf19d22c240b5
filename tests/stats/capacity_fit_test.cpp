// Requirement R-711: capacities found by incremental analysis, with ties and with those not reached, give the lognormal
// curve of maximum likelihood and its intervals.
#include "stats/capacity_fit.hpp"

#include <cmath>
#include <vector>

#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"

namespace overturn {
namespace {

// The example that goes with Baker (2015), Earthquake Spectra 31(1).
std::vector<double> const example{0.49, 0.62, 0.63, 0.63, 0.65, 0.70, 0.71, 0.72, 0.77, 0.79, 0.80, 0.84, 0.91,
                                  0.92, 0.93, 0.97, 1.04, 1.04, 1.05, 1.08, 1.08, 1.09, 1.12, 1.13, 1.22, 1.32,
                                  1.33, 1.34, 1.40, 1.40, 1.47, 1.72, 1.76, 2.15, 2.31, 2.42, 2.50};

std::vector<Capacity> tried_up_to(std::vector<double> const& all, double highest) {
    std::vector<Capacity> capacities;
    for (double const capacity : all) {
        capacities.push_back({std::min(capacity, highest), capacity <= highest});
    }
    return capacities;
}

// Printed there to four digits; confirmed by a search with shrinking steps to 1.0582217147 and 0.3821388900.
TEST(CapacityFit, IsThatOfThePublishedExample) {
    auto const censored = tried_up_to(example, 1.3);
    auto const line = fit_capacities(censored);
    ASSERT_TRUE(line);
    EXPECT_NEAR(std::exp(line->log_median()), 1.0582, 5e-5);
    EXPECT_NEAR(line->beta(), 0.3821, 5e-5);
    EXPECT_NEAR(std::exp(line->log_median()), 1.0582217146530148, 1e-8);
    EXPECT_NEAR(line->beta(), 0.38213889002799983, 1e-8);
    EXPECT_FALSE(moments_of(censored)) << "not of those that were not reached";
    auto const moments = moments_of(tried_up_to(example, 4));
    ASSERT_TRUE(moments);
    EXPECT_NEAR(moments->median, 1.0692, 5e-5);
    EXPECT_NEAR(moments->beta, 0.4081, 5e-5);
}

// Without censoring the maximum is in closed form: mean, and standard deviation over n.
TEST(CapacityFit, OfAllReachedIsTheClosedForm) {
    auto const all = tried_up_to(example, 4);
    auto const line = fit_capacities(all);
    auto const moments = moments_of(all);
    ASSERT_TRUE(line && moments);
    EXPECT_NEAR(std::exp(line->log_median()) / moments->median, 1, 1e-10);
    EXPECT_NEAR(line->beta() / (moments->beta * std::sqrt(36.0 / 37)), 1, 1e-10);
    // So are the profile's ends: n ln(1 + n d^2 / S) = chi squared for the median.
    double const sum_of_squares = moments->beta * moments->beta * 36;
    double const d = std::sqrt((std::exp(3.841458820694124 / 37) - 1) * sum_of_squares / 37);
    auto const ends = profile_intensity(all, *line, 0.5, 0.95);
    EXPECT_NEAR(std::log(ends.upper / moments->median), d, 1e-7);
    EXPECT_NEAR(std::log(ends.lower / moments->median), -d, 1e-7);
}

// The ends of beta, where 2 n (ln r + (1 / r^2 - 1) / 2) = chi squared, r = beta / its estimate.
TEST(CapacityFit, EndsOfBetaSolveTheirEquation) {
    auto const all = tried_up_to(example, 4);
    auto const line = fit_capacities(all);
    ASSERT_TRUE(line);
    auto const ends = profile_beta(all, *line, 0.95);
    for (double const end : {ends.lower, ends.upper}) {
        double const r = end / line->beta();
        EXPECT_NEAR(2 * 37 * (std::log(r) + (1 / (r * r) - 1) / 2), 3.841458820694124, 1e-6);
    }
}

TEST(CapacityFit, IntervalsHoldTheTruth) {
    constexpr int tables = 100;
    int median = 0;
    int beta = 0;
    for (std::uint64_t r = 0; r < tables; ++r) {
        RandomStream stream(23, r, Purpose::body_scatter);
        std::vector<double> all;
        for (int i = 0; i < 40; ++i) {
            all.push_back(std::exp(gsl_ran_gaussian(stream.gsl(), 0.4)));
        }
        auto const capacities = tried_up_to(all, 1.2);  // a third is not reached
        auto const line = fit_capacities(capacities);
        ASSERT_TRUE(line);
        auto const m = profile_intensity(capacities, *line, 0.5, 0.95);
        auto const b = profile_beta(capacities, *line, 0.95);
        median += m.lower <= 1 && 1 <= m.upper ? 1 : 0;
        beta += b.lower <= 0.4 && 0.4 <= b.upper ? 1 : 0;
    }
    // 89 of 100 or fewer come once in a hundred times at 95 %.
    EXPECT_GE(median, 90);
    EXPECT_GE(beta, 90);
}

// A mean of equal logarithms is rounded: what is left of it is no spread.
TEST(CapacityFit, EqualCapacitiesHaveNoSpread) {
    for (double const value : {0.1, 0.3, 0.7, 611.3}) {
        auto const moments = moments_of(tried_up_to(std::vector<double>(7, value), 1e3));
        ASSERT_TRUE(moments);
        EXPECT_EQ(moments->beta, 0);
        EXPECT_EQ(moments->median, value);
    }
    EXPECT_GT(moments_of(tried_up_to({0.3, 0.3, 0.3, 0.3, 0.31}, 1))->beta, 0.01);
}

// what was stated of the body is known, however few the capacities.
TEST(CapacityFit, OfTooFewKeepsTheStatedBetaU) {
    FragilityRequest request;
    request.beta_u = 0.3;
    for (std::size_t const count : {std::size_t{3}, std::size_t{20}}) {
        auto const fit = fragility_of(tried_up_to({example.begin(), example.begin() + count}, 4), request);
        EXPECT_TRUE(fit.beta_u_known) << count;
        EXPECT_EQ(fit.beta_u, 0.3) << count;
        EXPECT_EQ(fit.beta_u_stated, 0.3) << count;
    }
    EXPECT_FALSE(fragility_of(tried_up_to({0.3, 0.4, 0.5}, 1), {}).beta_u_known);
}

TEST(CapacityFit, WhatHoldsNoCurveIsLeftToTheStripes) {
    EXPECT_FALSE(fit_capacities(std::vector<Capacity>{{1, true}, {1, true}, {2, false}}));
    EXPECT_FALSE(fit_capacities(std::vector<Capacity>{{1, true}, {2, false}}));
    std::vector<Capacity> const none(10, {1.3, false});
    auto const fit = fragility_of(none, {});
    EXPECT_EQ(fit.state, FragilityState::none_overturned);
    ASSERT_TRUE(fit.bound);
    EXPECT_EQ(fit.bound->probability.upper, clopper_pearson(0, 10, 0.95).upper);
}

// At 0.9 two fell, one of ten was given up at 0.8: it may have.
TEST(CapacityFit, StripesHoldWhatWasCensoredAsUndecided) {
    std::vector<Capacity> const capacities{{0.9, true}, {0.8, false}, {0.7, true}, {2, true}};
    auto const stripes = stripes_of(capacities);
    ASSERT_EQ(stripes.size(), 4U);
    EXPECT_EQ(stripes[1].amplitude, 0.8);
    EXPECT_EQ(stripes[1].overturned, 1);
    EXPECT_EQ(stripes[1].failed, 0) << "it stood there";
    EXPECT_EQ(stripes[2].overturned, 2);
    EXPECT_EQ(stripes[2].failed, 1);
    EXPECT_EQ(stripes[3].overturned, 3);
}

}  // namespace
}  // namespace overturn
