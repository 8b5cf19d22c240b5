// Requirement R-801: the block under filtered noise fails as often as tens of millions of plain trials found, by subset
// simulation and under matched waves too, and in the mirror as before it.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rare/crude.hpp"
#include "rare/detail/normals.hpp"
#include "rare/pulse_mixture.hpp"
#include "rare/subset.hpp"
#include "support/rare_answer.hpp"
#include "support/rocking_noise.hpp"

namespace overturn::rare {
namespace {

using testing::RockingNoise;

Request request(std::uint64_t seed) { return {.seed = seed, .target_cov = 1}; }

// subset simulation meets the same block's probability, 1.003e-3 +- 1.1 % at 1.25.
TEST(TestProblem, SubsetSimulationMeetsTheSameProbability) {
    RockingNoise const problem;
    LoneWorker workers;

    auto const made = estimate_subset(problem, 1.25, request(2), workers, {.samples = 1000, .chains = 100}).estimate;

    ASSERT_EQ(made.state, State::trusted) << made.reason;
    EXPECT_NEAR(*made.probability, 1.003e-3, 3 * std::hypot(made.cov, 0.011) * 1.003e-3);
}

// of waves that are each matched to a spectrum, which is hardly linear in the normals, subset simulation
// meets what plain trials count.
TEST(TestProblem, SubsetSimulationMeetsPlainTrialsOfMatchedWaves) {
    RockingNoise const problem(4096, RockingNoise::Map::matched);
    LoneWorker workers;
    constexpr double factor = 1.5;
    constexpr double failed = 119;  // of 200 000, by the test below
    constexpr double counted = failed / 200'000;
    double const counted_error = 1 / std::sqrt(failed);

    auto const made = estimate_subset(problem, factor, request(2), workers, {.samples = 500, .chains = 50}).estimate;

    ASSERT_EQ(made.state, State::trusted) << made.reason;
    EXPECT_NEAR(*made.probability, counted, 3 * std::hypot(made.cov, counted_error) * counted);
    EXPECT_LT(made.cov, 0.3);
}

// Where that count is from: a minute and a half.
TEST(TestProblem, DISABLED_PlainTrialsOfMatchedWaves) {
    RockingNoise const problem(4096, RockingNoise::Map::matched);
    LoneWorker workers;
    std::vector<double> const factors{1.5};

    auto const counts = count_failures(problem, factors, {.seed = 4}, 0, 200'000, "plain", workers);

    EXPECT_EQ(counts.front().failed, 119);
}

// of waves that are each scaled to their own peak, which is not linear in the normals, nothing is stated
// but the bound of plain trials.
TEST(PulseMixture, DoesNotTrustItselfWhereEachWaveIsScaled) {
    RockingNoise const problem(4096, RockingNoise::Map::peak_scaled);
    LoneWorker workers;
    std::vector<double> const factors{1.10};

    auto const estimate = estimate_pulse_mixture(problem, factors, 1.10, request(1), workers, {},
                                                 {.pilot_runs = 1000, .final_runs = 1000})
                              .estimates.front();

    EXPECT_EQ(estimate.state, State::not_trusted);
    EXPECT_FALSE(estimate.probability.has_value());
    EXPECT_FALSE(estimate.reason.empty());
    EXPECT_EQ(estimate.interval_95.lower, 0);
    EXPECT_GT(estimate.interval_95.upper, 1.17e-4);
}

// of matched waves the pulse mixture states nothing.
TEST(PulseMixture, DoesNotTrustItselfWhereEachWaveIsMatched) {
    RockingNoise const problem(4096, RockingNoise::Map::matched);
    LoneWorker workers;
    std::vector<double> const factors{1.4};

    auto const estimate = estimate_pulse_mixture(problem, factors, 1.4, {.seed = 1, .target_cov = 1, .replicates = 4},
                                                 workers, {}, {.pilot_runs = 500, .final_runs = 1000})
                              .estimates.front();

    EXPECT_EQ(estimate.state, State::not_trusted);
    EXPECT_FALSE(estimate.probability.has_value());
}

// a wave and its mirror image end the same, so that signs may be drawn.
TEST(TestProblem, MirroredWavesEndTheSame) {
    RockingNoise const problem;
    std::vector<double> x(problem.normals());
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        draw_normals({.seed = 8, .index = i}, x);
        auto const one = respond_at(problem, x, 2.5);
        for (double& value : x) {
            value = -value;
        }
        auto const other = respond_at(problem, x, 2.5);
        ASSERT_EQ(one.failed, other.failed);
        ASSERT_EQ(one.driver, other.driver);
    }
}

}  // namespace
}  // namespace overturn::rare
