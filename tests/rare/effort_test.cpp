// Requirement R-904: before a run, the trials of its rare events are foretold from how rare failure is and from what
// the estimators' options allow.
#include "rare/effort.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "support/limit_states.hpp"

namespace overturn::rare {
namespace {

Request const asked{.seed = 1, .target_cov = 0.25, .max_runs = 1'000'000, .replicates = 8};

Sounding sounding_of(std::int64_t levels, double probability) {
    return {.factor = 1, .reached = true, .levels = levels, .probability = probability, .trials = 100, .seconds = 1};
}

// A sum of normals beyond 4.75 standard deviations: P = 1e-6, six levels of a tenth each, of which the last is the
// failure itself.
TEST(RareEffort, ASoundingFindsHowDeepFailureLies) {
    testing::LimitState const problem(64, 4.75 * 8, testing::sum_of);

    auto const sounding = sound(problem, 1, 7, 60);

    EXPECT_TRUE(sounding.reached);
    EXPECT_NEAR(static_cast<double>(sounding.levels), 5, 1.5);
    EXPECT_NEAR(std::log10(sounding.probability), -6, 1.5);
    EXPECT_EQ(sounding.trials, 16 + 200 + sounding.levels * 180);
    EXPECT_GT(sounding.seconds, 0);
}

// One that has no time to sound says so and takes failure to be as deep as may be.
TEST(RareEffort, ASoundingEndsInTime) {
    testing::LimitState const problem(64, 4.75 * 8, testing::sum_of);

    auto const sounding = sound(problem, 1, 7, 0);

    EXPECT_FALSE(sounding.reached);
    EXPECT_EQ(sounding.trials, 16);
    EXPECT_EQ(sounding.levels, 14);
    EXPECT_EQ(sounding.probability, 0);
}

// Eight replicates of 2000 plain trials and 1800 for each level below the last; four times as many at most.
TEST(RareEffort, OfSubsetSimulationIsWhatItsOptionsState) {
    std::array const six{sounding_of(6, 5e-7)};
    auto const effort = effort_of(six, false, Method::subset, asked);

    double const scout = 2048;
    EXPECT_DOUBLE_EQ(effort.least, 8 * (2000 + 5 * 1800) + scout);
    EXPECT_DOUBLE_EQ(effort.likely, 0.24 * 6 / (0.25 * 0.25) * (2000 + 6 * 1800) + 4 * scout);
    EXPECT_DOUBLE_EQ(effort.most, 32 * (2000 + 7 * 1800) + 7 * scout);
}

// (1 - P) / (P c.o.v.^2) plain waves, a trial at each factor, and no more than allowed.
TEST(RareEffort, OfPlainTrialsIsTheBinomialLaw) {
    std::array const two{sounding_of(0, 0.2), sounding_of(2, 1e-3)};

    auto const effort = effort_of(two, true, Method::crude, asked);

    EXPECT_NEAR(effort.likely, 2 * (1 - 1e-3) / (1e-3 * 0.25 * 0.25), 2);
    EXPECT_LT(effort.least, effort.likely);
    EXPECT_LT(effort.likely, effort.most);
    std::array const rarest{sounding_of(9, 1e-9)};
    EXPECT_DOUBLE_EQ(effort_of(rarest, true, Method::crude, asked).likely, 1e6);
}

// `auto` looks with 4000 waves; for the rare ones it tries pulses where it can, and subset simulation behind them.
TEST(RareEffort, OfAutoIsThatOfAllThatItTries) {
    std::array const both{sounding_of(0, 0.2), sounding_of(6, 5e-7)};
    auto const rare = std::span(both).last(1);
    auto const common = std::span(both).first(1);

    auto const without = effort_of(both, false, std::nullopt, asked);
    auto const with = effort_of(both, true, std::nullopt, asked);

    double const look = 2 * 4000;
    double const crude = effort_of(common, false, Method::crude, asked).likely;
    double const subset = effort_of(rare, false, Method::subset, asked).likely;
    double const pulses = effort_of(rare, true, Method::pulse_mixture, asked).likely - 200;
    EXPECT_DOUBLE_EQ(without.likely, look + crude + subset);
    EXPECT_DOUBLE_EQ(with.likely, look + crude + pulses + subset);
    EXPECT_LT(with.least, with.likely - subset + 1) << "a first estimator that can be trusted is the only one";
    EXPECT_LT(with.likely, with.most);
}

}  // namespace
}  // namespace overturn::rare
