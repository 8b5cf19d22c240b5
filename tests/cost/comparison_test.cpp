// Requirement R-904: flips, peak errors, distributions and the balance of errors are counted as stated.
#include "cost/comparison.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cost/sampling.hpp"
#include "rocking/planar_rocking.hpp"
#include "stats/proportion.hpp"

namespace overturn::cost {
namespace {

TrialRow row(Verdict verdict, double peak_rad = 0) {
    TrialRow row;
    row.verdict = verdict;
    row.peak_rotation_rad = peak_rad;
    row.peak_rotation_ratio = peak_rad / 0.5;
    return row;
}

TEST(Spread, QuantilesAreOfTheValuesThemselves) {
    std::vector<double> values;
    for (int i = 20; i >= 1; --i) {
        values.push_back(i);
    }
    auto const spread = spread_of(values);

    EXPECT_EQ(spread.count, 20);
    EXPECT_EQ(spread.median, 10);  // 10 of 20 do not exceed it
    EXPECT_EQ(spread.p95, 19);
    EXPECT_EQ(spread.worst, 20);
    EXPECT_TRUE(std::isnan(spread_of({}).p95));
}

TEST(Comparison, CountsFlips) {
    std::vector<TrialRow> const exact{row(Verdict::at_rest),         row(Verdict::rocked, 0.2),
                                      row(Verdict::rocked, 0.1),     row(Verdict::overturned),
                                      row(Verdict::contact_lost, 1), row(Verdict::failed)};
    std::vector<TrialRow> const rows{
        row(Verdict::slid),       row(Verdict::rocked, 0.202), row(Verdict::overturned, 1.5),
        row(Verdict::overturned), row(Verdict::rocked, 0.3),   row(Verdict::failed)};
    auto const found = compare(rows, exact);

    EXPECT_EQ(found.trials, 5);  // one failed in both
    EXPECT_EQ(found.flips, 3);
    EXPECT_EQ(found.overturning_flips, 2);  // slid instead of at rest is none
    EXPECT_EQ(found.peak.count, 1);         // rocked in both
    EXPECT_NEAR(found.peak.worst, 0.01, 1e-14);
    EXPECT_DOUBLE_EQ(found.probability, 2.0 / 5);
    EXPECT_DOUBLE_EQ(found.probability_error, 2.0 / 5 - 1.0 / 4);
}

TEST(Comparison, OfTheSameIsNothing) {
    std::vector<TrialRow> const rows{row(Verdict::rocked, 0.2), row(Verdict::overturned, 1.5)};
    auto const found = compare(rows, rows);

    EXPECT_EQ(found.flips, 0);
    EXPECT_EQ(found.peak.worst, 0);
    EXPECT_EQ(found.probability_error, 0);
    EXPECT_EQ(found.ks, 0);
}

Comparison verdicts(std::int64_t trials, std::int64_t flips) {
    Comparison comparison;
    comparison.trials = trials;
    comparison.flips = comparison.overturning_flips = flips;
    return comparison;
}

TEST(Balance, TheLargerErrorDecides) {
    auto const seen = balance_of(verdicts(1000, 2), 0.05, 0.95);
    EXPECT_EQ(seen.dominates, Dominates::sampling);
    EXPECT_DOUBLE_EQ(seen.numerical, 0.002);
    EXPECT_DOUBLE_EQ(seen.factor, 25);
    EXPECT_FALSE(seen.is_bound);

    auto const many = balance_of(verdicts(1000, 200), 0.05, 0.95);
    EXPECT_EQ(many.dominates, Dominates::numerical);
    EXPECT_DOUBLE_EQ(many.factor, 4);
}

/// Nothing seen is not nothing there: 0 of n leaves 1 - (alpha/2)^(1/n) (Clopper & Pearson 1934).
TEST(Balance, WithoutFlipsABoundStandsIn) {
    auto const bound = balance_of(verdicts(1000, 0), 0.05, 0.95);
    EXPECT_TRUE(bound.is_bound);
    EXPECT_NEAR(bound.numerical, 1 - std::pow(0.025, 1e-3), 1e-12);
    EXPECT_EQ(bound.dominates, Dominates::sampling);

    EXPECT_EQ(balance_of(verdicts(10, 0), 0.05, 0.95).dominates, Dominates::unknown);  // too few to tell
    EXPECT_EQ(balance_of(verdicts(0, 0), 0.05, 0.95).dominates, Dominates::unknown);
}

}  // namespace
}  // namespace overturn::cost
