// Requirement R-702: a lognormal fragility is the maximum of its likelihood, its profile intervals are those of the
// likelihood-ratio test, and HCLPF follows from both betas.
#include <array>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>

#include "core/random_stream.hpp"
#include "stats/detail/profile_likelihood.hpp"
#include "stats/fragility.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;
using testing::Tolerance;

constexpr Tolerance maximum{1e-9, "maximum"};
constexpr Tolerance inverted{1e-7, "inverted"};  ///< the bisected reference is good to that

std::vector<Stripe> table_of(std::vector<std::array<double, 3>> const& rows) {
    std::vector<Stripe> stripes;
    for (auto const& [amplitude, trials, overturned] : rows) {
        stripes.push_back({.amplitude = amplitude,
                           .trials = static_cast<std::int64_t>(trials),
                           .overturned = static_cast<std::int64_t>(overturned)});
    }
    return stripes;
}

std::vector<Stripe> const known = table_of({{1, 54, 2}, {1.5, 54, 25}, {2, 54, 43}});

FragilityFit fit_of(std::vector<Stripe> const& stripes, FragilityRequest const& request = {}) {
    return fit_fragility(FragilityData::of_stripes(stripes), request);
}

/// Baker's (2015) eq. 11, the sum of k ln P + (n - k) ln(1 - P), maximised apart from this program: golden sections
/// nested in ln median and ln beta with P from the C library's erfc, then Fisher scoring to the last digits. The
/// intervals: bisection on where twice the fall of the profiled likelihood is 3.841458820694124 (95 %, chi squared
/// with 1 degree of freedom), again with golden sections. The deviance: by its sum over the six cells.
TEST(FragilityFit, MatchesAnIndependentMaximisation) {
    auto const fit = fit_of(known);

    ASSERT_TRUE(fit.identifiable());
    EXPECT_TRUE(near(std::exp(fit.line->log_median()), 1.57247651593071, maximum));
    EXPECT_TRUE(near(fit.line->beta(), 0.270033194702542, maximum));
    EXPECT_TRUE(near(log_likelihood(points_of(known), *fit.line), -73.3604691184925, maximum));
    EXPECT_TRUE(near(*fit.five_percent_point(), 1.0084829479802333, maximum));
    EXPECT_TRUE(near(fit.profile->median.lower, 1.4756879325809789, inverted));
    EXPECT_TRUE(near(fit.profile->median.upper, 1.677826922005793, inverted));
    EXPECT_TRUE(near(fit.profile->beta.lower, 0.21015594695128426, inverted));
    EXPECT_TRUE(near(fit.profile->beta.upper, 0.3627619282471869, inverted));
    EXPECT_TRUE(near(fit.goodness->deviance, 0.45589793870446194, maximum));
    EXPECT_EQ(fit.goodness->degrees_of_freedom, 1);
    EXPECT_FALSE(fit.goodness->chi_squared) << "2.5 are expected to fall in the lowest stripe";
    EXPECT_NEAR(fit.goodness->p_value, 0.4995473430558607, 0.1) << "that of chi squared, which is near";
    EXPECT_EQ(fit.flags, bit(FragilityFlag::no_beta_u)) << "nothing else is wrong";
}

/// Two stripes and two unknowns: the curve goes through both proportions, in closed form.
TEST(FragilityFit, GoesThroughTwoStripes) {
    auto const fit = fit_of(table_of({{3, 40, 10}, {5, 50, 30}}));
    double const z1 = gsl_cdf_ugaussian_Pinv(0.25);
    double const z2 = gsl_cdf_ugaussian_Pinv(0.6);
    double const beta = std::log(5.0 / 3.0) / (z2 - z1);

    ASSERT_TRUE(fit.identifiable());
    EXPECT_TRUE(near(fit.line->beta(), beta, maximum));
    EXPECT_TRUE(near(std::exp(fit.line->log_median()), 3 * std::exp(-z1 * beta), maximum));
    EXPECT_EQ(fit.goodness->degrees_of_freedom, 0);
    EXPECT_TRUE(has(fit.flags, FragilityFlag::two_levels));
}

/// Another unit moves the median with it and leaves beta alone.
TEST(FragilityFit, IsEquivariantInTheUnit) {
    auto stripes = known;
    for (auto& stripe : stripes) {
        stripe.amplitude *= 980.665;
    }
    auto const fit = fit_of(stripes);
    auto const plain = fit_of(known);

    EXPECT_TRUE(near(fit.line->beta(), plain.line->beta(), maximum));
    EXPECT_TRUE(near(std::exp(fit.line->log_median() - plain.line->log_median()), 980.665, maximum));
    EXPECT_TRUE(near(fit.profile->median.upper / plain.profile->median.upper, 980.665, inverted));
}

/// The same trials one by one give the same curve as stripes.
TEST(FragilityFit, SingleTrialsAreStripesOfOne) {
    std::vector<SingleTrial> trials;
    for (auto const& stripe : known) {
        for (std::int64_t i = 0; i < stripe.trials; ++i) {
            trials.push_back({stripe.amplitude, static_cast<std::int64_t>(trials.size()), i < stripe.overturned});
        }
    }
    auto const single = fit_fragility(FragilityData::of_trials(trials, false), {});

    EXPECT_TRUE(near(single.line->log_median(), fit_of(known).line->log_median(), maximum));
    EXPECT_TRUE(near(single.line->beta(), fit_of(known).line->beta(), maximum));
    EXPECT_EQ(single.waves, 162);
}

// the maximum is one, wherever the search begins: far off, steep, flat or falling; also with a point so far from
// the others that its chance underflows.
TEST(FitProbit, FindsOneMaximumFromAnywhere) {
    auto points = points_of(known);
    points.push_back({12, 40, 40, 0});
    auto const best = *fit_probit(points);

    for (ProbitLine const& begin :
         {ProbitLine{0, 0.01}, ProbitLine{-200, 300}, ProbitLine{5, -4}, ProbitLine{60, 1}, best}) {
        auto const line = fit_probit(points, begin);
        ASSERT_TRUE(line);
        EXPECT_TRUE(near(line->log_median(), best.log_median(), maximum)) << begin.intercept;
        EXPECT_TRUE(near(line->beta(), best.beta(), maximum)) << begin.intercept;
    }
    double const least = 1e-6;
    for (ProbitLine const& beside : {ProbitLine{best.intercept + least, best.slope},
                                     {best.intercept - least, best.slope},
                                     {best.intercept, best.slope + least},
                                     {best.intercept, best.slope - least}}) {
        EXPECT_LT(log_likelihood(points, beside), log_likelihood(points, best));
    }
}

// tables of few trials, as resampled data are: almost separated, steep, with empty levels. From the line of
// other data the search ends where it ends by itself, and no line near by is more likely.
TEST(FitProbit, ResampledTablesHaveTheMaximumOfTheirOwn) {
    int fitted = 0;
    for (std::uint64_t table = 0; table < 4000; ++table) {
        RandomStream stream(7, table, Purpose::bootstrap, 0);
        auto const next = [&](std::uint64_t below) { return gsl_rng_uniform_int(stream.gsl(), below); };
        std::vector<FragilityPoint> points;
        for (int level = 0; level < 8; ++level) {
            auto const trials = static_cast<double>(next(5));
            auto const most = static_cast<std::uint64_t>(trials) + 1;
            double const fell = level < 3 ? (next(6) == 0 ? next(most) : 0) : level > 4 ? trials : next(most);
            points.push_back({0.1 * level + 1e-4 * static_cast<double>(next(100)), trials, std::min(fell, trials), 0});
        }
        if (state_of(points) != FragilityState::fitted) {
            continue;
        }
        auto const alone = fit_probit(points);
        auto const from = fit_probit(points, {-3 + 0.01 * static_cast<double>(next(600)), 8});
        ASSERT_TRUE(alone && from) << table;
        ++fitted;
        double const top = log_likelihood(points, *alone);
        EXPECT_NEAR(log_likelihood(points, *from), top, 1e-9) << table;
        EXPECT_NEAR(from->slope / alone->slope, 1, 1e-4) << table;
        for (double const by : {0.999, 1.001}) {
            EXPECT_LE(log_likelihood(points, {alone->intercept * by, alone->slope * by}), top + 1e-12) << table;
            EXPECT_LE(log_likelihood(points, {alone->intercept, alone->slope * by}), top + 1e-12) << table;
        }
    }
    EXPECT_GT(fitted, 500);
}

// Every bound that is reported is where its own likelihood-ratio test turns: the fit that is held there falls
// short by exactly chi squared. Held by brute force: a fine scan over the slope.
TEST(ProfileLikelihood, EndsWhereTheTestTurns) {
    auto const points = points_of(known);
    auto const best = *fit_probit(points);
    ProfileLikelihood const profile(points, best, 0.9);
    double const allowed = gsl_cdf_chisq_Pinv(0.9, 1);
    auto const fall = [&](double at, double q) {
        double highest = -1e9;
        for (double slope = 1; slope < 9; slope += 1e-4) {
            highest = std::max(highest, log_likelihood(points, {q - slope * std::log(at), slope}));
        }
        return 2 * (log_likelihood(points, best) - highest);
    };
    constexpr Tolerance scanned{1e-5, "scanned"};

    for (double const p : {0.05, 0.5, 0.9}) {
        auto const ends = profile.intensity(p);
        EXPECT_TRUE(near(fall(ends.lower, gsl_cdf_ugaussian_Pinv(p)), allowed, scanned)) << p;
        EXPECT_TRUE(near(fall(ends.upper, gsl_cdf_ugaussian_Pinv(p)), allowed, scanned)) << p;
    }
    for (double const at : {0.7, 1.2, 3.0}) {
        auto const ends = profile.probability(at);
        EXPECT_TRUE(near(fall(at, gsl_cdf_ugaussian_Pinv(ends.lower)), allowed, scanned)) << at;
        EXPECT_TRUE(near(fall(at, gsl_cdf_ugaussian_Pinv(ends.upper)), allowed, scanned)) << at;
    }
}

// Without a beta_u there is no HCLPF, only the curve's 5 % point. HCLPF takes 1.645 of each beta; a stated
// beta_u moves it from there by exp(-1.645 beta_u), its interval too.
TEST(FragilityFit, HclpfTakesBothBetas) {
    FragilityRequest request;
    request.beta_u = 0.3;
    auto const wider = fit_of(known, request);
    auto const plain = fit_of(known);
    double const factor = std::exp(-1.645 * 0.3);

    EXPECT_FALSE(plain.hclpf());
    EXPECT_FALSE(plain.one_percent_point());
    EXPECT_FALSE(plain.intervals().hclpf);
    EXPECT_FALSE(plain.median_at(0.95));
    EXPECT_TRUE(has(plain.flags, FragilityFlag::no_beta_u));
    ASSERT_TRUE(wider.hclpf() && wider.one_percent_point() && wider.intervals().hclpf);
    EXPECT_FALSE(has(wider.flags, FragilityFlag::no_beta_u));
    EXPECT_TRUE(near(*wider.five_percent_point(), *plain.five_percent_point(), maximum));
    EXPECT_TRUE(near(*wider.hclpf() / *plain.five_percent_point(), factor, maximum));
    EXPECT_TRUE(near(wider.intervals().hclpf->lower / plain.intervals().five_percent_point.lower, factor, maximum));
    EXPECT_TRUE(near(*wider.one_percent_point(),
                     std::exp(wider.line->log_median() - 2.326347874040841 * std::hypot(wider.line->beta(), 0.3)),
                     maximum));
    EXPECT_LT(plain.intervals().five_percent_point.lower, *plain.five_percent_point());
    EXPECT_GT(plain.intervals().five_percent_point.upper, *plain.five_percent_point());
}

// The curve of 95 % confidence reaches 5 % at HCLPF: that is what the name says.
TEST(FragilityFit, HclpfIsWhereTheCurveOfHighConfidenceIsLow) {
    FragilityRequest request;
    request.beta_u = 0.3;
    auto const fit = fit_of(known, request);
    double const score = std::log(*fit.hclpf() / *fit.median_at(0.95)) / fit.beta_r();

    EXPECT_NEAR(gsl_cdf_ugaussian_P(score), 0.05, 1e-4) << "1.645 stands for 1.64485";
    EXPECT_TRUE(near(*fit.median_at(0.5), std::exp(fit.line->log_median()), maximum));
    EXPECT_TRUE(near(*fit.median_at(0.05) * *fit.median_at(0.95), std::exp(2 * fit.line->log_median()), maximum));
}

// What was drawn and what is stated add as independent parts do; what is stated never lessens beta_R.
TEST(FragilityFit, StatedUncertaintyAddsToWhatWasDrawn) {
    FragilityRequest request;
    request.drawn = true;
    request.split = BetaSplit{0.2, 0.15, {0.15}, {0.02}, {}};
    auto const drawn = fit_of(known, request);
    request.beta_u = 0.2;
    auto const both = fit_of(known, request);
    request.split.reset();
    auto const untold = fit_of(known, request);

    EXPECT_EQ(drawn.beta_u, 0.15);
    EXPECT_TRUE(near(drawn.beta_r(), std::sqrt(std::pow(drawn.line->beta(), 2) - 0.15 * 0.15), maximum));
    EXPECT_TRUE(near(both.beta_u, 0.25, maximum));
    EXPECT_EQ(both.beta_r(), drawn.beta_r());
    EXPECT_FALSE(untold.hclpf()) << "drawn, but not told apart: no beta_R to be had";
}

// What was drawn and moves nothing beyond chance, a mass, buys no HCLPF; nor does a beta_U of nothing.
TEST(FragilityFit, WhatWasDrawnMustMoveTheMedian) {
    FragilityRequest request;
    request.drawn = true;
    request.split = BetaSplit{0.2, 0.01, {0.022}, {0.02}, {}};
    auto const chance = fit_of(known, request);
    EXPECT_FALSE(chance.hclpf());
    EXPECT_TRUE(has(chance.flags, FragilityFlag::no_beta_u));
    EXPECT_TRUE(chance.five_percent_point());
    request.split = BetaSplit{0.2, 0.0, {0.002}, {0.02}, {}};
    EXPECT_FALSE(fit_of(known, request).hclpf());
    request.beta_u = 0.3;
    EXPECT_TRUE(fit_of(known, request).hclpf()) << "stated";
    request.beta_u = 0;
    request.split = BetaSplit{0.2, 0.15, {0.15, 0.01}, {0.06, 0.02}, {}};
    EXPECT_TRUE(fit_of(known, request).hclpf()) << "2.5 standard errors, one of two quantities";
    request.split = BetaSplit{0.2, 0.15, {0.15, 0.01}, {0.07, 0.02}, {}};
    EXPECT_FALSE(fit_of(known, request).hclpf()) << "2.1 of them: chance, where two might have done it";
}

/// Cells of equal width stand in for very many distinct intensities; what that moves is far below what sampling
/// leaves.
TEST(FragilityFit, CellsMoveNothingThatMatters) {
    std::vector<SingleTrial> trials;
    for (int i = 0; i < 6000; ++i) {
        double const quantile = (i + 0.5) / 6000;
        double const intensity = std::exp(0.8 * gsl_cdf_ugaussian_Pinv(quantile));
        // Overturns in the proportion of a curve with median 1.2 and beta 0.4, spread evenly over the trials.
        double const p = gsl_cdf_ugaussian_P(std::log(intensity / 1.2) / 0.4);
        trials.push_back({intensity, i, std::fmod(i * 0.6180339887498949, 1.0) < p});
    }
    auto const fine = fit_probit(points_of(trials, 6000));
    auto const cells = fit_probit(points_of(trials, 2048));

    EXPECT_TRUE(near(cells->log_median(), fine->log_median(), Tolerance{1e-4, "cells"}));
    EXPECT_TRUE(near(cells->beta(), fine->beta(), Tolerance{1e-4, "cells"}));
}

}  // namespace
}  // namespace overturn
