// Requirement: waves that share what was drawn come in groups, and a group counts as one.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "stats/criterion.hpp"
#include "stats/fragility.hpp"
#include "stats/joint.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

TEST(SharedDraws, WholeGroupsCountAsOneAndPartsOutwards) {
    auto const whole = clopper_pearson_of_groups(30, 30, 200, 10, 0.95);
    EXPECT_EQ(whole.lower, clopper_pearson(3, 20, 0.95).lower);
    EXPECT_EQ(whole.upper, clopper_pearson(3, 20, 0.95).upper);
    auto const parts = clopper_pearson_of_groups(39, 41, 209, 10, 0.95);
    EXPECT_EQ(parts.lower, clopper_pearson(3, 20, 0.95).lower);
    EXPECT_EQ(parts.upper, clopper_pearson(5, 20, 0.95).upper);
    auto const single = clopper_pearson_of_groups(7, 9, 50, 1, 0.9);
    EXPECT_EQ(single.lower, clopper_pearson(7, 50, 0.9).lower);
    EXPECT_EQ(single.upper, clopper_pearson(9, 50, 0.9).upper);
    auto const begun = clopper_pearson_of_groups(4, 4, 4, 10, 0.95);
    EXPECT_EQ(begun.lower, 0) << "a part of one group proves nothing";
    EXPECT_EQ(begun.upper, 1);
}

TEST(SharedDraws, EveryCountTakesThem) {
    Stripe const stripe{.amplitude = 1, .trials = 100, .overturned = 20, .undecided = 10, .group_size = 10};
    EXPECT_EQ(stripe.interval(0.95).lower, clopper_pearson(2, 10, 0.95).lower);
    EXPECT_EQ(stripe.interval(0.95).upper, clopper_pearson(3, 10, 0.95).upper);
    auto const share = share_of(20, 100, 0.95, 10);
    EXPECT_EQ(share.count, 20);
    EXPECT_EQ(share.interval.upper, clopper_pearson(2, 10, 0.95).upper);
    std::vector<JointTrial> const trials(40, JointTrial{1, {JointEnd::overturned, JointEnd::stood}});
    EXPECT_EQ(study_joint(trials, 10).any[0].interval(0.95).lower, clopper_pearson(4, 4, 0.95).lower);
}

// The sample ten times over: its order statistics say what those of one copy do, and where the copies differ a little
// the outermost of them.
TEST(SharedDraws, QuantilesOfCopiesAreThoseOfOne) {
    std::vector<double> once, copies, nearly;
    for (int i = 0; i < 60; ++i) {
        once.push_back(i);
        copies.insert(copies.end(), 10, i);
        for (int copy = 0; copy < 10; ++copy) {
            nearly.push_back(i + 0.01 * copy);
        }
    }
    for (double const q : {0.5, 0.84, 0.95}) {
        auto const one = sample_quantile(once, 0, q, 0.95);
        auto const ten = sample_quantile(copies, 0, q, 0.95, 10);
        EXPECT_EQ(ten.lower, one.lower) << q;
        EXPECT_EQ(ten.upper, one.upper) << q;
        auto const outermost = sample_quantile(nearly, 0, q, 0.95, 10);
        EXPECT_EQ(outermost.lower, one.lower) << q;
        EXPECT_EQ(outermost.upper, one.upper ? std::optional(*one.upper + 0.09) : std::nullopt) << q;
    }
}

// A whole group ends together with the chance `share`, else each trial for itself: correlation `share` within it.
std::int64_t fallen(RandomStream& stream, std::int64_t groups, std::int64_t group_size, double share, double p) {
    std::int64_t sum = 0;
    for (std::int64_t g = 0; g < groups; ++g) {
        bool const together = gsl_rng_uniform(stream.gsl()) < share;
        sum += together ? (gsl_rng_uniform(stream.gsl()) < p ? group_size : 0)
                        : gsl_ran_binomial(stream.gsl(), p, static_cast<unsigned>(group_size));
    }
    return sum;
}

/// Property: whatever the correlation within a group, either end of the 95 % interval misses in 2.5 % at most; the
/// interval that takes all trials as independent misses far oftener.
TEST(SharedDraws, IntervalsHoldWhateverTheirCorrelation) {
    constexpr int repetitions = 4000;
    constexpr std::int64_t groups = 60, group_size = 10;
    double const most = 0.025 * repetitions + 2.6 * std::sqrt(0.025 * repetitions);
    for (double const share : {0.0, 0.3, 0.7, 1.0}) {
        for (double const p : {0.02, 0.2, 0.5}) {
            int below = 0, above = 0, independent = 0;
            for (std::uint64_t r = 0; r < repetitions; ++r) {
                RandomStream stream(5, r, Purpose::body_scatter);
                auto const k = fallen(stream, groups, group_size, share, p);
                auto const ends = clopper_pearson_of_groups(k, k, groups * group_size, group_size, 0.95);
                auto const narrow = clopper_pearson(k, groups * group_size, 0.95);
                below += ends.upper < p ? 1 : 0;
                above += ends.lower > p ? 1 : 0;
                independent += narrow.upper < p || narrow.lower > p ? 1 : 0;
            }
            EXPECT_LE(below, most) << share << ' ' << p;
            EXPECT_LE(above, most) << share << ' ' << p;
            if (share > 0.5) {
                EXPECT_GT(independent, repetitions / 4) << share << ' ' << p;
            }
        }
    }
}

std::vector<Stripe> in_groups(std::vector<Stripe> stripes, std::int64_t group_size) {
    for (auto& stripe : stripes) {
        stripe.trials *= group_size;
        stripe.overturned *= group_size;
        stripe.group_size = group_size;
    }
    return stripes;
}

FragilityFit fit_of(std::vector<Stripe> const& stripes, std::vector<Quote> quotes = {}) {
    FragilityRequest request;
    request.quotes = std::move(quotes);
    return fit_fragility(FragilityData::of_stripes(stripes), request);
}

/// A table ten times over, in groups of ten, is judged as the table itself.
TEST(SharedDraws, CopiesTestACurveNoHarderThanTheTable) {
    std::vector<Stripe> const once{{.amplitude = 2, .trials = 40, .overturned = 3},
                                   {.amplitude = 3, .trials = 40, .overturned = 13},
                                   {.amplitude = 4, .trials = 40, .overturned = 11},
                                   {.amplitude = 6, .trials = 40, .overturned = 38}};
    auto const one = fit_of(once, {{2, 1}});
    auto const ten = fit_of(in_groups(once, 10), {{2, 1}});
    auto independent = in_groups(once, 10);
    for (auto& stripe : independent) {
        stripe.group_size = 1;
    }
    ASSERT_TRUE(one.identifiable() && ten.identifiable());
    EXPECT_NEAR(ten.line->log_median(), one.line->log_median(), 1e-9);
    EXPECT_NEAR(ten.goodness->deviance, one.goodness->deviance, 1e-9);
    EXPECT_NEAR(ten.goodness->stripe_p_value, one.goodness->stripe_p_value, 1e-9);
    EXPECT_NEAR(ten.monotone.deviance, one.monotone.deviance, 1e-9);
    EXPECT_EQ(ten.quotes[0].seen.upper, one.quotes[0].seen.upper);
    EXPECT_EQ(ten.quotes[0].least, one.quotes[0].least);
    EXPECT_EQ(ten.quotes[0].trials, 400) << "what is counted is counted";
    EXPECT_LT(fit_of(independent).goodness->least_p_value(), 1e-6) << "as independent trials they would reject it";
}

/// Of campaigns whose groups fall together few true curves are rejected; counted one by one most are.
TEST(SharedDraws, TrueCurvesAreSeldomRejected) {
    constexpr int repetitions = 300;
    int poor = 0, one_by_one = 0;
    for (std::uint64_t r = 0; r < repetitions; ++r) {
        RandomStream stream(6, r, Purpose::body_scatter);
        std::vector<Stripe> stripes;
        for (double const at : {6.0, 8.0, 9.0, 10.0, 12.0, 14.0}) {
            double const p = gsl_cdf_ugaussian_P(std::log(at / 10) / 0.3);
            stripes.push_back(
                {.amplitude = at, .trials = 400, .overturned = fallen(stream, 40, 10, 0.7, p), .group_size = 10});
        }
        poor += has(fit_of(stripes).flags, FragilityFlag::poor_fit) ? 1 : 0;
        for (auto& stripe : stripes) {
            stripe.group_size = 1;
        }
        one_by_one += has(fit_of(stripes).flags, FragilityFlag::poor_fit) ? 1 : 0;
    }
    EXPECT_LT(poor, repetitions / 12);
    EXPECT_GT(one_by_one, repetitions / 2);
}

/// A level at which nothing was decided is a stripe of groups too once its trials are taken as fallen or standing.
TEST(SharedDraws, UndecidedStripesAreGroupsToo) {
    std::vector<Stripe> const stripes{{.amplitude = 2, .trials = 100, .overturned = 10, .group_size = 10},
                                      {.amplitude = 4, .trials = 100, .undecided = 100, .group_size = 10}};
    for (auto const& point : with_undecided(FragilityData::of_stripes(stripes), true)) {
        EXPECT_EQ(point.group_size, 10) << std::exp(point.log_intensity);
    }
}

TEST(SharedDraws, ABoundCountsGroupsAsOne) {
    auto const fit =
        fit_of({{.amplitude = 2, .trials = 200, .group_size = 10}, {.amplitude = 4, .trials = 200, .group_size = 10}});
    EXPECT_EQ(fit.bound->probability.upper, clopper_pearson(0, 20, 0.95).upper);
}

}  // namespace
}  // namespace overturn
