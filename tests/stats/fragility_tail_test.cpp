// Requirement R-704: where a curve leaves what was seen, what was seen is reported: stripes contradict it one by one,
// and below what the trials can hold there is a bound.
#include <algorithm>
#include <array>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "stats/fragility.hpp"
#include "support/stripe_tables.hpp"

namespace overturn {
namespace {

using testing::table_of;

// With a stated beta_U, so that there is an HCLPF to tell.
FragilityFit fit_of(std::vector<Stripe> const& stripes, std::vector<Quote> quotes = {}) {
    return testing::fit_of(stripes, std::move(quotes), 0.3);
}

/// One of 1000 at four low levels, and 999 of 1000 far above: pooled cells see nothing wrong with a curve that gives
/// 2e-9 at the lowest; each stripe's own exact tail does, and its count is quoted.
TEST(Tail, AnOverturningThatTheCurveHoldsImpossibleIsBelieved) {
    auto const fit =
        fit_of(table_of({{2, 1000, 1}, {3, 1000, 1}, {4, 1000, 1}, {5, 1000, 1}, {20, 1000, 999}}), {{2, 1}});

    ASSERT_TRUE(fit.identifiable());
    EXPECT_LT(*fit.quotes[0].curve, 1e-6);
    EXPECT_EQ(*fit.quotes[0].probability, 0.001);
    EXPECT_EQ(fit.quotes[0].source, QuotedProbability::Source::stripe);
    EXPECT_EQ(fit.quotes[0].bounds.lower, clopper_pearson(1, 1000, 0.95).lower);
    EXPECT_LT(fit.goodness->stripe_p_value, 1e-4);
    EXPECT_GT(fit.goodness->p_value, 0.05) << "pooling hides it";
    EXPECT_TRUE(has(fit.flags, FragilityFlag::poor_fit));
}

/// The exact tail by its own sum: the farthest of three stripes.
TEST(Tail, StripesAreTestedByTheirExactTails) {
    auto const fit = fit_of(table_of({{2, 50, 6}, {4, 50, 15}, {8, 50, 48}}));
    double least = 1;
    for (auto const& [at, overturned] : {std::pair{2.0, 6U}, {4.0, 15U}, {8.0, 48U}}) {
        double const p = gsl_cdf_ugaussian_P(fit.line->at(std::log(at)));
        double below = 0;
        for (unsigned k = 0; k <= overturned; ++k) {
            below += gsl_ran_binomial_pdf(k, p, 50);
        }
        double const above = 1 - below + gsl_ran_binomial_pdf(overturned, p, 50);
        least = std::min(least, 3 * 2 * std::min(below, above));
    }
    EXPECT_NEAR(fit.goodness->stripe_p_value, std::min(1.0, least), 1e-9);
}

/// Size of both tests together, on tables that a lognormal curve made: 5 % is what either has by itself, and the
/// stripes' is far below that since the curve was fitted to them.
TEST(Tail, CurvesThatAreTrueAreSeldomRejected) {
    constexpr int repetitions = 1000;
    int poor = 0;
    for (std::uint64_t r = 0; r < repetitions; ++r) {
        RandomStream stream(7, r, Purpose::body_scatter);
        std::vector<Stripe> stripes;
        for (double const at : {5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0}) {
            double const p = gsl_cdf_ugaussian_P(std::log(at / 10) / 0.2);
            stripes.push_back({.amplitude = at,
                               .trials = 40,
                               .overturned = static_cast<std::int64_t>(gsl_ran_binomial(stream.gsl(), p, 40))});
        }
        poor += has(fit_of(stripes).flags, FragilityFlag::poor_fit) ? 1 : 0;
    }
    EXPECT_LT(poor, 90);
    EXPECT_GT(poor, 20);
}

/// Nothing fell at the quoted stripe, and the curve is rejected: not "0", but what so many trials bound.
TEST(Tail, NoneSeenUnderAPoorCurveIsABound) {
    auto const fit =
        fit_of(table_of({{6, 2000, 0}, {9, 2000, 200}, {10, 2000, 1000}, {11, 2000, 1700}, {12, 2000, 1980}}),
               {{3, 0.5}, {6, 1}});

    ASSERT_TRUE(has(fit.flags, FragilityFlag::poor_fit));
    for (auto const& quoted : fit.quotes) {
        EXPECT_FALSE(quoted.probability) << *quoted.probability;
        ASSERT_TRUE(quoted.bound);
        EXPECT_EQ(quoted.bounds.upper, clopper_pearson(0, 2000, 0.95).upper);
        EXPECT_EQ(quoted.least, 0.1 / 2000);
    }
}

/// A plateau, and proportions that fall: 5 % points of such curves are doubtful. They stand beside what the stripes
/// hold.
TEST(Tail, FivePercentPointsThatTheStripesContradictAreDoubtful) {
    auto const plateau =
        fit_of(table_of({{2, 50, 1}, {4, 50, 24}, {6, 50, 26}, {8, 50, 25}, {10, 50, 27}, {12, 50, 26}, {16, 50, 25}}));
    auto const falling = fit_of(table_of({{2, 50, 1}, {3, 50, 40}, {4, 50, 10}, {6, 50, 45}, {8, 50, 49}}));
    for (auto const& fit : {plateau, falling}) {
        ASSERT_TRUE(fit.identifiable());
        EXPECT_TRUE(has(fit.flags, FragilityFlag::five_percent_doubtful));
        ASSERT_TRUE(fit.five_percent_point());
        EXPECT_DOUBLE_EQ(*fit.five_percent_point(), std::exp(fit.line->log_median() - 1.645 * fit.line->beta()));
        EXPECT_TRUE(fit.hclpf() && fit.one_percent_point());
        ASSERT_TRUE(fit.beside_five_percent);
        EXPECT_EQ(fit.beside_five_percent->above.units, 50);
        EXPECT_EQ(fit.beside_five_percent->above.probability.upper, clopper_pearson(1, 50, 0.95).upper);
    }
    // A curve rejected by a hair that 2000 trials a stripe see, and right about where 5 % is, keeps it.
    auto const fine =
        fit_of(table_of({{6, 2000, 6}, {7, 2000, 90}, {9, 2000, 500}, {10, 2000, 850}, {13, 2000, 1750}}));
    EXPECT_TRUE(has(fine.flags, FragilityFlag::poor_fit));
    EXPECT_FALSE(has(fine.flags, FragilityFlag::five_percent_doubtful));
}

/// A dip that chance explains is no alarm.
TEST(Tail, ADipByChanceIsNone) {
    auto const fit = fit_of(table_of({{2, 50, 5}, {3, 50, 4}, {4, 50, 25}, {6, 50, 45}}));

    EXPECT_FALSE(has(fit.flags, FragilityFlag::non_monotone));
    EXPECT_EQ(fit.monotone.degrees_of_freedom, 1);
    // Of two stripes of one P, 9 of 100, that of 50 each: a difference of one or more downwards.
    double falls = 0;
    for (unsigned a = 0; a <= 50; ++a) {
        for (unsigned b = 0; b < a; ++b) {
            falls += gsl_ran_binomial_pdf(a, 0.09, 50) * gsl_ran_binomial_pdf(b, 0.09, 50);
        }
    }
    EXPECT_NEAR(fit.monotone.p_value, falls, 0.06) << "all but equal ones: none falls less";
}

/// Where P may rise but the curve cannot tell, stripes bound it together: 6 of 3000, and none of 404 from 5 m/s2 up.
TEST(Tail, StripesOfFewPoolUnderMonotonicity) {
    auto const few = fit_of(table_of({{2, 1000, 1}, {3, 1000, 2}, {4, 1000, 3}}));
    ASSERT_EQ(few.state, FragilityState::not_rising);
    ASSERT_TRUE(few.pooled);
    EXPECT_EQ(few.pooled->probability.upper, clopper_pearson(6, 3000, 0.95).upper);
    EXPECT_EQ(few.pooled->probability.lower, clopper_pearson(6, 3000, 0.95).lower);

    auto const none = fit_of(table_of({{3, 10, 0}, {5, 400, 0}, {8, 4, 0}}));
    ASSERT_TRUE(none.pooled);
    EXPECT_NEAR(none.pooled->from, 5, 1e-12);
    EXPECT_EQ(none.pooled->probability.upper, clopper_pearson(0, 404, 0.95).upper);
    EXPECT_FALSE(fit_of(table_of({{3, 10, 0}, {5, 400, 0}})).pooled) << "the highest stripe says it already";
    auto shared = FragilityData::of_stripes(table_of({{3, 10, 0}, {5, 400, 0}, {8, 4, 0}}));
    shared.waves_shared = true;
    EXPECT_FALSE(fit_fragility(shared, {}).pooled) << "levels that share waves are no further trials";
}

/// A stripe that saw nothing is bounded by all that saw nothing next above it, if P rises and levels share no waves:
/// none of 400 says more than none of 100. One that saw something ends the run.
TEST(Tail, QuotesPoolWhatSawNothingNextAbove) {
    auto const table = table_of({{1, 100, 0}, {2, 100, 0}, {3, 100, 0}, {4, 100, 0}, {6, 100, 30}, {8, 100, 80}});
    auto const fit = fit_of(table, {{1, 1}, {2, 2}, {0.5, 0.5}, {1.5, 1.5}});
    ASSERT_TRUE(fit.identifiable());
    auto const none_of = [](std::int64_t n) { return clopper_pearson(0, n, 0.95).upper; };
    EXPECT_EQ(fit.quotes[0].bounds.upper, none_of(400));
    EXPECT_EQ(fit.quotes[0].seen.upper, none_of(100)) << "the stripe's own";
    EXPECT_EQ(fit.quotes[0].pooled->to, std::exp(std::log(4.0)));
    EXPECT_EQ(fit.quotes[1].bounds.upper, none_of(300));
    EXPECT_EQ(fit.quotes[2].bounds.upper, none_of(400)) << "below all stripes";
    EXPECT_EQ(fit.quotes[3].bounds.upper, none_of(300)) << "between two";

    auto shared = FragilityData::of_stripes(table);
    shared.waves_shared = true;
    FragilityRequest request;
    request.quotes = {{1, 1}};
    EXPECT_EQ(fit_fragility(shared, request).quotes[0].bounds.upper, none_of(100)) << "the same waves again";
    auto open = table;
    open[1].undecided = 1;
    EXPECT_EQ(fit_of(open, {{1, 1}}).quotes[0].bounds.upper, none_of(100)) << "what is open may have fallen";

    auto const top = fit_of(table_of({{2, 50, 5}, {4, 50, 20}, {6, 50, 50}, {8, 50, 48}, {10, 50, 50}, {12, 50, 50}}),
                            {{9, 1}, {11, 2}, {13, 3}});
    EXPECT_EQ(top.quotes[0].neighbours->below.units, 50) << "8 has one that stood, so that 6 says nothing more";
    EXPECT_EQ(top.quotes[1].neighbours->below.units, 50);
    auto const all = fit_of(table_of({{2, 50, 0}, {10, 50, 50}, {12, 50, 50}}), {{11, 1}, {13, 2}});
    EXPECT_EQ(all.quotes[0].neighbours->below.units, 50);
    EXPECT_EQ(all.quotes[1].neighbours->below.probability.lower, clopper_pearson(100, 100, 0.95).lower);

    auto const nothing = fit_of(table_of({{2, 100, 0}, {3, 100, 0}}), {{1, 0.5}, {2, 1}});
    ASSERT_FALSE(nothing.identifiable());
    EXPECT_EQ(nothing.quotes[0].bounds.upper, none_of(200));
    EXPECT_EQ(nothing.quotes[1].bounds.upper, none_of(200));
}

/// Property: the run that is pooled is found in the data, and its end still misses P no oftener than 2.5 %.
TEST(Tail, PooledRunsCover) {
    constexpr int repetitions = 4000;
    for (double const p : {0.004, 0.01, 0.03}) {
        int missed = 0;
        for (std::uint64_t r = 0; r < repetitions; ++r) {
            RandomStream stream(12, r, Purpose::body_scatter);
            std::vector<Stripe> stripes;
            for (double const level : {1.0, 2.0, 3.0, 4.0, 5.0}) {
                double const here = p * (1 + 0.02 * level);
                stripes.push_back({.amplitude = level,
                                   .trials = 100,
                                   .overturned = static_cast<std::int64_t>(gsl_ran_binomial(stream.gsl(), here, 100))});
            }
            auto const fit = fit_of(stripes, {{1, 1}});
            bool const bound = fit.quotes[0].source == QuotedProbability::Source::stripe;
            missed += bound && fit.quotes[0].bounds.upper < 1.02 * p ? 1 : 0;
        }
        EXPECT_LE(missed, 0.025 * repetitions + 2.6 * std::sqrt(0.025 * repetitions)) << p;
    }
}

/// Above the highest stripe, and below the lowest, a curve that does not describe the data gives no P: what is left is
/// that P does not fall.
TEST(Tail, OutsideTheStripesAPoorCurveGivesNothing) {
    auto const plateau = table_of({{2, 500, 20}, {4, 500, 240}, {6, 500, 260}, {8, 500, 250}, {10, 500, 270}});
    auto const fit = fit_of(plateau, {{1.9, 1}, {20, 2}});
    ASSERT_TRUE(has(fit.flags, FragilityFlag::poor_fit) && !has(fit.flags, FragilityFlag::non_monotone));
    for (auto const& quoted : fit.quotes) {
        EXPECT_FALSE(quoted.probability);
        EXPECT_EQ(quoted.source, QuotedProbability::Source::neighbours);
    }
    EXPECT_EQ(fit.quotes[0].bounds.lower, 0);
    EXPECT_EQ(fit.quotes[0].bounds.upper, clopper_pearson(20, 500, 0.95).upper);
    EXPECT_EQ(fit.quotes[1].bounds.lower, clopper_pearson(270, 500, 0.95).lower);
    EXPECT_EQ(fit.quotes[1].bounds.upper, 1);
    EXPECT_EQ(fit.quotes[1].neighbours->above.units, 0) << "nothing was tried there";

    // P fell once: it may fall again, and nothing tried elsewhere bounds it.
    auto const falling =
        fit_of(table_of({{2, 500, 10}, {3, 500, 400}, {4, 500, 100}, {6, 500, 450}}), {{8, 2}, {3.5, 1}, {1, 0.5}});
    ASSERT_TRUE(falling.identifiable() && has(falling.flags, FragilityFlag::non_monotone));
    auto const down = fit_of(table_of({{2, 100, 90}, {4, 100, 60}, {6, 100, 20}}), {{5, 1}, {8, 2}, {1, 0.5}});
    ASSERT_FALSE(down.identifiable());
    for (auto const& fit : {falling, down}) {
        for (auto const& quoted : fit.quotes) {
            EXPECT_FALSE(quoted.probability) << quoted.quote.intensity;
            EXPECT_EQ(quoted.source, QuotedProbability::Source::none) << quoted.quote.intensity;
            EXPECT_FALSE(quoted.bound) << quoted.quote.intensity;
        }
    }
}

/// The same of single trials: tenths of them on either side, by waves, of which the upper end counts those with any
/// trial fallen and the lower one those with all.
TEST(Tail, SingleTrialsOnEitherSideBoundPWhereTheCurveIsPoor) {
    std::vector<SingleTrial> trials;
    for (std::int64_t i = 0; i < 1000; ++i) {
        double const at = 2 + 0.01 * static_cast<double>(i);
        bool const plateau = i > 100 && i % 2 == 0;  // half of them from 3 on, nearly none below: no lognormal
        trials.push_back({at, i / 2, plateau || i == 5});
    }
    FragilityRequest request;
    request.quotes = {{7, 1}};
    auto const fit = fit_fragility(FragilityData::of_trials(trials, true), request);
    ASSERT_TRUE(has(fit.flags, FragilityFlag::poor_fit));
    auto const& quoted = fit.quotes[0];
    EXPECT_FALSE(quoted.probability);
    ASSERT_TRUE(quoted.neighbours);
    EXPECT_EQ(quoted.neighbours->below.to, 7);
    EXPECT_EQ(quoted.neighbours->above.from, 7);
    // A hundred trials each way: pairs of which one fell; the one at 7 itself is half a pair on the lower side.
    EXPECT_EQ(quoted.neighbours->above.overturned, quoted.neighbours->above.units) << "each has a trial that fell";
    EXPECT_LE(quoted.neighbours->below.overturned, 1) << "none has both";
    EXPECT_NEAR(quoted.neighbours->below.units, 50, 1);
    EXPECT_EQ(quoted.bounds.upper, 1);
}

/// Property: the pooled bound holds wherever P rises. 95 % of its ends cover P at the end they speak of, at least.
TEST(Tail, PooledBoundsCover) {
    constexpr int repetitions = 2000;
    int above = 0;
    int told = 0;
    for (std::uint64_t r = 0; r < repetitions; ++r) {
        RandomStream stream(11, r, Purpose::body_scatter);
        std::vector<Stripe> stripes;
        for (std::int64_t const level : {1, 2, 3}) {
            stripes.push_back({.amplitude = static_cast<double>(level),
                               .trials = 300,
                               .overturned = static_cast<std::int64_t>(
                                   gsl_ran_binomial(stream.gsl(), 0.01 + 0.0005 * static_cast<double>(level), 300))});
        }
        auto const fit = fit_of(stripes);
        if (fit.pooled) {
            ++told;
            above += fit.pooled->probability.upper < 0.0105 ? 1 : 0;
        }
    }
    EXPECT_GT(told, repetitions / 2);
    EXPECT_LE(above, repetitions / 40 + 20);
}

}  // namespace
}  // namespace overturn
