// Requirement R-702: a curve over two measures finds what made the trials, with intervals that hold it, and says what
// the second measure adds.
#include "stats/two_measures.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"

namespace overturn {
namespace {

// P = Phi(-6 + 2.5 ln a + of_b ln b) where ln a and ln b differ from wave to wave; three scales of each wave.
std::vector<TwoMeasureTrial> simulated(std::uint64_t seed, int waves, double of_b) {
    std::vector<TwoMeasureTrial> trials;
    for (int wave = 0; wave < waves; ++wave) {
        RandomStream stream(seed, static_cast<std::uint64_t>(wave), Purpose::body_scatter);
        double const a = 2 + gsl_ran_gaussian(stream.gsl(), 0.3);
        double const b = 0.5 + gsl_ran_gaussian(stream.gsl(), 0.5);
        for (double const scale : {-0.4, 0.0, 0.4}) {
            double const z = -6 + 2.5 * (a + scale) + of_b * (b + scale);
            trials.push_back({{a + scale, b + scale}, gsl_rng_uniform(stream.gsl()) < gsl_cdf_ugaussian_P(z), wave});
        }
    }
    return trials;
}

bool holds(Estimate const& estimate, double truth) {
    return estimate.interval.lower <= truth && truth <= estimate.interval.upper;
}

/// Known answer, in 200 repetitions: 95 % intervals of both slopes and of beta hold it in 92 to 98 % (two standard
/// errors).
TEST(TwoMeasures, IntervalsHoldWhatMadeTheTrials) {
    constexpr int repetitions = 200;
    int first = 0;
    int second = 0;
    int beta = 0;
    for (std::uint64_t r = 0; r < repetitions; ++r) {
        auto const fit = fit_two_measures(simulated(r, 400, 1.5), 0.95, {5, r, 300});
        ASSERT_TRUE(fit);
        first += holds(fit->slopes[0], 2.5) ? 1 : 0;
        second += holds(fit->slopes[1], 1.5) ? 1 : 0;
        beta += holds(fit->beta, 1 / 4.0) ? 1 : 0;
    }
    for (int const hits : {first, second, beta}) {
        EXPECT_GE(hits, 0.92 * repetitions);
        EXPECT_LE(hits, 0.985 * repetitions);
    }
}

/// A second measure without information gains what chance gains, one unit of deviance; one with information gains far
/// more.
TEST(TwoMeasures, GainIsThatOfChanceWhereTheSecondAddsNothing) {
    double gain = 0;
    constexpr int repetitions = 100;
    for (std::uint64_t r = 0; r < repetitions; ++r) {
        auto const fit = fit_two_measures(simulated(900 + r, 300, 0), 0.95, {5, r, 10});
        ASSERT_TRUE(fit);
        EXPECT_EQ(fit->better, 0U);
        gain += fit->deviance_gain / repetitions;
    }
    EXPECT_NEAR(gain, 1, 4 * std::sqrt(2.0 / repetitions)) << "mean of chi squared with one degree of freedom";
    EXPECT_GT(fit_two_measures(simulated(1, 300, 1.5), 0.95, {5, 0, 10})->deviance_gain, 20);
}

/// Other units move the constant alone.
TEST(TwoMeasures, SlopesKnowNoUnits) {
    auto trials = simulated(3, 200, 1.5);
    auto const si = fit_two_measures(trials, 0.95, {5, 0, 50});
    for (auto& trial : trials) {
        trial.log_intensity[0] += std::log(100.0);
    }
    auto const gal = fit_two_measures(trials, 0.95, {5, 0, 50});
    ASSERT_TRUE(si && gal);
    EXPECT_NEAR(gal->slopes[0].value, si->slopes[0].value, 1e-9);
    EXPECT_NEAR(gal->constant.value, si->constant.value - std::log(100.0) * si->slopes[0].value, 1e-8);
    EXPECT_NEAR(gal->deviance_gain, si->deviance_gain, 1e-8);
}

TEST(TwoMeasures, AreNothingWhereThereIsNoCurve) {
    auto trials = simulated(4, 100, 1);
    auto same = trials;
    for (auto& trial : same) {
        trial.log_intensity[1] = trial.log_intensity[0] + 1;
    }
    EXPECT_FALSE(fit_two_measures(same, 0.95, {5, 0, 10})) << "one is the other's multiple";
    for (auto& trial : trials) {
        trial.overturned = false;
    }
    EXPECT_FALSE(fit_two_measures(trials, 0.95, {5, 0, 10}));
    EXPECT_FALSE(fit_two_measures({}, 0.95, {5, 0, 10}));
}

}  // namespace
}  // namespace overturn
