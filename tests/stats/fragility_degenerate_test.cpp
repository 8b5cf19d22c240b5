// Requirement R-704: data that hold no curve get an answer that is true of them, and never a number that is not in
// them.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "stats/fragility.hpp"
#include "support/stripe_tables.hpp"

namespace overturn {
namespace {

using testing::fit_of;
using testing::table_of;

/// 0 of 400: a fitter that does not look gives median 8.3 and beta 1.07 here. All that is known is an exact bound at
/// the highest level: 1 - 0.025^(1/100).
TEST(Degenerate, NothingOverturned) {
    auto const fit = fit_of(table_of({{2, 100, 0}, {4, 100, 0}, {6, 100, 0}, {8, 100, 0}}), {{8, 1}, {16, 2}});

    EXPECT_EQ(fit.state, FragilityState::none_overturned);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_FALSE(fit.penalised);
    ASSERT_TRUE(fit.bound);
    EXPECT_EQ(fit.bound->to, std::exp(std::log(8.0)));
    EXPECT_NEAR(fit.bound->probability.upper, -std::expm1(std::log(0.025) / 100), 1e-12);
    EXPECT_FALSE(fit.quotes[0].probability);
    EXPECT_EQ(fit.quotes[0].bounds.upper, fit.bound->probability.upper);
    EXPECT_FALSE(fit.quotes[0].outside_data);
    EXPECT_TRUE(fit.quotes[1].outside_data);
    EXPECT_EQ(fit.quotes[1].bounds.upper, 1) << "nothing was tried there";
}

/// All overturned: elsewhere median 0.0002. Here the lowest level bounds P from below.
TEST(Degenerate, EverythingOverturned) {
    auto const fit = fit_of(table_of({{2, 50, 50}, {4, 50, 50}}));

    EXPECT_EQ(fit.state, FragilityState::all_overturned);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_NEAR(fit.bound->probability.lower, std::pow(0.025, 1.0 / 50), 1e-12);
}

/// One of 400 at the top level, where others crash: it separates; the curve's place stays open upwards.
TEST(Degenerate, OneOverturnedAtTheTop) {
    auto const fit = fit_of(table_of({{2, 100, 0}, {4, 100, 0}, {8, 200, 1}}));

    EXPECT_EQ(fit.state, FragilityState::separated);
    EXPECT_TRUE(has(fit.flags, FragilityFlag::one_overturned));
    EXPECT_EQ(fit.isotonic_median.lower, std::exp(std::log(8.0)));
    EXPECT_TRUE(std::isinf(fit.isotonic_median.upper));
    EXPECT_FALSE(fit.penalised) << "at 22 times the highest level it would be made up";
    ASSERT_TRUE(fit.bound);
    EXPECT_EQ(fit.bound->probability.upper, clopper_pearson(1, 200, 0.95).upper);
}

/// One of 300 in the middle: the most likely curve rises by chance only.
TEST(Degenerate, OneOverturnedInTheMiddle) {
    auto const fit = fit_of(table_of({{2, 100, 0}, {4, 100, 1}, {8, 100, 0}}));

    EXPECT_EQ(fit.state, FragilityState::not_rising);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_TRUE(has(fit.flags, FragilityFlag::one_overturned));
}

/// Perfect separation: the median lies in a bracket, beta has no lower end; Firth's fit is finite and within it.
TEST(Degenerate, PerfectSeparation) {
    auto const fit = fit_of(table_of({{2, 20, 0}, {4, 20, 0}, {6, 20, 20}, {8, 20, 20}}));

    EXPECT_EQ(fit.state, FragilityState::separated);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_EQ(fit.isotonic_median.lower, std::exp(std::log(4.0)));
    EXPECT_EQ(fit.isotonic_median.upper, std::exp(std::log(6.0)));
    ASSERT_TRUE(fit.penalised);
    EXPECT_GT(std::exp(fit.penalised->log_median()), 4);
    EXPECT_LT(std::exp(fit.penalised->log_median()), 6);
    EXPECT_GT(fit.penalised->beta(), 0);
}

/// A stripe in which both happened does not help if all below stood and all above fell.
TEST(Degenerate, AlmostSeparated) {
    auto const fit = fit_of(table_of({{2, 20, 0}, {4, 20, 7}, {6, 20, 20}}));

    EXPECT_EQ(fit.state, FragilityState::separated);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_TRUE(fit.penalised);
}

/// Where no curve rises through the stripes, what was seen at a quoted one is still reported, with its exact interval.
TEST(Degenerate, FallingStripesStillBoundTheirQuotes) {
    auto const fit = fit_of(table_of({{1, 100, 90}, {2, 100, 50}, {3, 100, 10}}), {{1, 1}, {5, 5}});

    EXPECT_FALSE(fit.identifiable());
    EXPECT_EQ(fit.quotes[0].source, QuotedProbability::Source::stripe);
    EXPECT_EQ(fit.quotes[0].bounds.lower, clopper_pearson(90, 100, 0.95).lower);
    EXPECT_EQ(fit.quotes[1].source, QuotedProbability::Source::none);
}

/// One stripe only, no stripe at all, stripes without any verdict.
TEST(Degenerate, TooFewStripes) {
    EXPECT_EQ(fit_of(table_of({{2, 20, 7}})).state, FragilityState::one_level);
    EXPECT_EQ(fit_of({}).state, FragilityState::no_trials);
    EXPECT_EQ(fit_of({{.amplitude = 3, .trials = 5, .failed = 5}}).state, FragilityState::no_trials);
}

/// Fewer overturn at higher levels: no lognormal curve falls.
TEST(Degenerate, NegativeSlope) {
    auto const fit = fit_of(table_of({{2, 50, 30}, {4, 50, 20}, {6, 50, 10}}));

    EXPECT_EQ(fit.state, FragilityState::not_rising);
    EXPECT_FALSE(fit.identifiable());
    EXPECT_TRUE(has(fit.flags, FragilityFlag::non_monotone));
    ASSERT_EQ(fit.isotonic.size(), 1U);
    EXPECT_EQ(fit.isotonic[0].probability(), 0.4);
    EXPECT_EQ(fit_of(table_of({{2, 50, 50}, {4, 50, 0}})).state, FragilityState::not_rising) << "separated downwards";
}

/// Rocking is not monotone: 40, 10 and then 45 of 50 is no chance. The curve is given with what speaks against it.
TEST(Degenerate, NonMonotoneStripes) {
    auto const fit = fit_of(table_of({{2, 50, 1}, {3, 50, 40}, {4, 50, 10}, {6, 50, 45}, {8, 50, 49}}));

    ASSERT_TRUE(fit.identifiable());
    EXPECT_TRUE(has(fit.flags, FragilityFlag::non_monotone));
    EXPECT_TRUE(has(fit.flags, FragilityFlag::poor_fit));
    EXPECT_LE(fit.goodness->p_value, 1e-3) << "none of 999 draws is as far off";
    ASSERT_EQ(fit.isotonic.size(), 4U);
    EXPECT_EQ(fit.isotonic[1].probability(), 0.5) << "3 and 4 pooled";
    EXPECT_EQ(fit.isotonic[1].points, 2U);
}

/// Where the curve does not describe the proportions the stripe's own exact interval is quoted, not the curve's, which
/// would be sure of what is not so.
TEST(Degenerate, APoorCurveDoesNotOutvoteItsStripe) {
    auto const fit =
        fit_of(table_of({{2, 500, 1}, {3, 500, 300}, {4, 500, 310}, {6, 500, 450}, {8, 500, 470}}), {{2, 1}, {5, 2.5}});

    ASSERT_TRUE(has(fit.flags, FragilityFlag::poor_fit));
    EXPECT_EQ(fit.quotes[0].source, QuotedProbability::Source::stripe);
    EXPECT_EQ(fit.quotes[0].bounds.upper, clopper_pearson(1, 500, 0.95).upper);
    EXPECT_GT(*fit.quotes[0].curve, 10 * fit.quotes[0].bounds.upper);
    EXPECT_EQ(*fit.quotes[0].probability, 1.0 / 500) << "a P outside its own bounds is no P";
    EXPECT_EQ(fit.quotes[1].source, QuotedProbability::Source::neighbours) << "no stripe there";
    EXPECT_EQ(fit.quotes[1].bounds.lower, clopper_pearson(310, 500, 0.95).lower);
    EXPECT_EQ(fit.quotes[1].bounds.upper, clopper_pearson(450, 500, 0.95).upper);
    EXPECT_FALSE(fit.quotes[1].probability) << "a rejected curve's is none";
}

/// Between two stripes P, which rises, lies between the lower end of the one and the upper end of the other: these are
/// the bounds where both saw nothing (or everything), and where they leave the curve out there is no P.
TEST(Degenerate, BetweenStripesTheirEndsBound) {
    auto const fit =
        fit_of(table_of({{1, 400, 0}, {2, 400, 0}, {3, 54, 4}, {4, 54, 30}, {6, 54, 50}, {8, 90, 90}, {9, 90, 90}}),
               {{1.9, 0.95}, {3.5, 1.75}, {8.5, 4.25}});

    ASSERT_EQ(fit.state, FragilityState::fitted);
    EXPECT_EQ(fit.quotes[0].source, QuotedProbability::Source::neighbours);
    EXPECT_EQ(fit.quotes[0].bounds.lower, 0);
    EXPECT_EQ(fit.quotes[0].bounds.upper, clopper_pearson(0, 400, 0.95).upper);
    EXPECT_EQ(fit.quotes[0].probability, fit.quotes[0].curve);
    EXPECT_EQ(fit.quotes[1].source, QuotedProbability::Source::curve) << "both kinds on both sides";
    EXPECT_EQ(fit.quotes[2].bounds.lower, clopper_pearson(90, 90, 0.95).lower);
    EXPECT_EQ(fit.quotes[2].bounds.upper, 1);

    auto const wide = fit_of(table_of({{1, 4000, 0}, {2, 4000, 0}, {3, 20, 12}, {4, 20, 13}, {8, 20, 14}, {9, 20, 15}}),
                             {{1.9, 0.95}});
    ASSERT_TRUE(wide.identifiable());
    auto const& left_out = wide.quotes[0];
    EXPECT_GT(*left_out.curve, clopper_pearson(0, 4000, 0.95).upper);
    EXPECT_FALSE(left_out.probability);
    EXPECT_EQ(left_out.source, QuotedProbability::Source::neighbours);
    EXPECT_EQ(left_out.bounds.upper, clopper_pearson(0, 4000, 0.95).upper);

    auto const split = fit_of(table_of({{1, 50, 0}, {3, 50, 50}}), {{2, 1}});
    ASSERT_FALSE(split.identifiable());
    EXPECT_EQ(split.quotes[0].source, QuotedProbability::Source::neighbours) << "separated: no curve at all";
    EXPECT_EQ(split.quotes[0].bounds.lower, 0);
    EXPECT_EQ(split.quotes[0].bounds.upper, 1);
}

// Trials without a verdict are counted and said, left out of the curve, and widen the bound.
TEST(Degenerate, UndecidedTrials) {
    auto const fit = fit_of({{.amplitude = 2, .trials = 50}, {.amplitude = 4, .trials = 50, .failed = 10}});

    EXPECT_EQ(fit.undecided, 10);
    EXPECT_TRUE(has(fit.flags, FragilityFlag::undecided_trials));
    EXPECT_EQ(fit.bound->probability.upper, clopper_pearson(10, 50, 0.95).upper);
}

/// Levels without any overturning among others: the exact bound of that stripe, not the curve's, which leaves the
/// data; far below the lowest proportion the quoted P is warned of. Below a tenth of one in all trials there is no P at
/// all, but the bound of the nearest stripe from there on.
TEST(Degenerate, QuotesKnowTheirData) {
    auto const fit =
        fit_of(table_of({{2, 200, 0}, {3, 54, 4}, {4, 54, 30}, {6, 54, 50}}), {{2, 1}, {3, 1.5}, {1, 0.5}});

    EXPECT_EQ(fit.quotes[0].source, QuotedProbability::Source::stripe);
    EXPECT_EQ(fit.quotes[0].bounds.lower, 0);
    EXPECT_EQ(fit.quotes[0].bounds.upper, clopper_pearson(0, 200, 0.95).upper);
    EXPECT_TRUE(fit.quotes[0].in_tail);
    EXPECT_EQ(fit.quotes[1].source, QuotedProbability::Source::curve);
    EXPECT_FALSE(fit.quotes[1].in_tail);
    EXPECT_TRUE(fit.quotes[2].outside_data);
    EXPECT_LT(*fit.quotes[2].curve, 0.1 / 200);
    EXPECT_FALSE(fit.quotes[2].probability);
    ASSERT_TRUE(fit.quotes[2].bound);
    EXPECT_EQ(fit.quotes[2].bound->from, std::exp(std::log(2.0)));
    EXPECT_EQ(fit.quotes[2].bound->units, 200);
    EXPECT_EQ(fit.quotes[2].bounds.upper, clopper_pearson(0, 200, 0.95).upper);
    EXPECT_GT(*fit.quotes[0].curve, 0.1 / 200);
    EXPECT_FALSE(fit.quotes[0].bound);
}

/// Single trials: the tenth of them at or above the quoted intensity, counted by waves, since those of one wave tell no
/// more than one. P is bounded from above whatever the curve says.
TEST(Degenerate, SingleTrialsBoundWhatTheyCannotHold) {
    std::vector<SingleTrial> trials;
    for (std::int64_t i = 0; i < 200; ++i) {
        double const at = 2 + 0.01 * static_cast<double>(i);
        trials.push_back({at, i / 2, i >= 100 ? i % 10 != 0 : i % 25 == 24});
    }
    FragilityRequest request;
    request.quotes = {{0.5, 1}};
    auto const fit = fit_fragility(FragilityData::of_trials(trials, false), request);
    auto const& quoted = fit.quotes[0];

    ASSERT_TRUE(fit.identifiable());
    ASSERT_TRUE(quoted.bound);
    EXPECT_EQ(quoted.bound->from, 2);
    EXPECT_EQ(quoted.bound->to, trials[19].intensity);
    EXPECT_EQ(quoted.bound->units, 10) << "twenty trials of ten waves";
    EXPECT_EQ(quoted.bound->overturned, 0);
    EXPECT_EQ(quoted.bounds.upper, clopper_pearson(0, 10, 0.95).upper);
}

/// Single trials that share waves bound no more than their waves do: 5 waves at 40 factors are 5, not 200.
TEST(Degenerate, SharedWavesBoundNoMoreThanTheirNumber) {
    std::vector<SingleTrial> trials;
    for (int wave = 0; wave < 5; ++wave) {
        for (int level = 0; level < 40; ++level) {
            trials.push_back({1 + 0.01 * wave + 0.1 * level, wave, false});
        }
    }
    auto const fit = fit_fragility(FragilityData::of_trials(trials, true), {});

    EXPECT_EQ(fit.bound->units, 5);
    EXPECT_EQ(fit.bound->probability.upper, clopper_pearson(0, 5, 0.95).upper);
}

/// Resampled data that hold no curve widen the interval to what is still known; the wider, the rarer the event.
TEST(Degenerate, BootstrapDoesNotHideItsFailures) {
    std::vector<SingleTrial> trials;
    for (int wave = 0; wave < 12; ++wave) {
        for (double const level : {1.0, 2.0, 3.0}) {
            trials.push_back({level, wave, (wave == 0 && level > 1.5) || (wave == 1 && level > 2.5)});
        }
    }
    auto const line = fit_probit(points_of(trials, 64));
    ASSERT_TRUE(line && line->slope > 0);
    auto const bootstrap = bootstrap_waves(trials, *line, {1, 0, 400});

    EXPECT_GT(bootstrap.without_curve(), 40U) << "both waves that overturn are often not drawn";
    EXPECT_TRUE(std::isinf(bootstrap.intensity(0.5, 0.95).upper));
    EXPECT_EQ(bootstrap.beta(0.95).lower, 0);
    EXPECT_TRUE(std::isinf(bootstrap.beta(0.95).upper));
    EXPECT_EQ(bootstrap.probability(2, 0.95).lower, 0);
}

}  // namespace
}  // namespace overturn
