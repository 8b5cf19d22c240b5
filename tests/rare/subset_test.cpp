// Requirement R-801: subset simulation gives probabilities that are known in closed form, over many shapes of failure,
// and gives none where it cannot.
#include "rare/subset.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/limit_states.hpp"

namespace overturn::rare {
namespace {

using testing::LimitState;
using testing::squares_of;
using testing::sum_of;

constexpr std::size_t dimension = 2048;

SubsetOptions const tuned{.samples = 1000, .chains = 100};

struct Known {
    char const* name;
    double probability;
    double cov;  ///< measured of one replicate; 0: not known
    double limit;
    LimitState::Value value;
};

std::vector<Known> known_cases() {
    double const root = std::sqrt(static_cast<double>(dimension));
    auto const largest = [](std::span<double const> x) {
        double most = 0;
        for (double const one : x) {
            most = std::max(most, std::abs(one));
        }
        return most;
    };
    auto const linear = [=](auto x) { return sum_of(x) / root; };
    auto const two_sided = [=](auto x) { return std::abs(sum_of(x)) / root; };
    return {
        {"linear_1e3", 1.0001e-3, 0, 3.0902, linear},
        {"linear_1e6", 1.0001e-6, 0.43, 4.7534, linear},
        {"linear_1e8", 1.00001e-8, 0, 5.6120, linear},
        {"two_sided_6e5", 6.3342e-5, 0, 4.0, two_sided},
        {"two_sided_1e6", 9.5837e-7, 0, 4.9, two_sided},
        {"radius_7e5", 7.3229e-5, 0, 2300, squares_of},
        {"radius_3e6", 3.1627e-6, 0.33, 2350, squares_of},
        {"radius_9e8", 8.7823e-8, 0, 2400, squares_of},
        {"curved_away", 3.78456e-6, 0.49, 5.5, [](auto x) { return x[0] + .005 * squares_of(x.subspan(1, 200)); }},
        {"curved_towards", 1.76153e-5, 0, 3, [](auto x) { return x[0] - .025 * squares_of(x.subspan(1, 50)); }},
        {"many_modes_1e3", 1.17344e-3, 0, 5, largest},
        {"many_modes_4e6", 4.04105e-6, 0.51, 6, largest},
        {"unequal_modes_4e5", 3.50688e-5, 0, 4, [](auto x) { return std::max(x[0], x[1] - 0.5); }},
        {"unequal_modes_1e5", 1.36324e-5, 0.41, 4.2, [](auto x) { return std::max(x[0], x[1] - 0.8); }},
    };
}

void PrintTo(Known const& known, std::ostream* out) { *out << known.name; }

class SubsetOf : public ::testing::TestWithParam<Known> {};

// the mean over replicates lies within 3.5 standard errors of the exact probability, and their scatter is
// what was measured for this shape, within 40 %.
TEST_P(SubsetOf, MeetsTheExactProbability) {
    LimitState const problem(dimension, GetParam().limit, GetParam().value);
    LoneWorker workers;
    auto const result = estimate_subset(problem, 1, {.seed = 11, .target_cov = 1, .replicates = 16}, workers, tuned);
    auto const& estimate = result.estimate;

    ASSERT_EQ(estimate.state, State::trusted) << estimate.reason;
    EXPECT_NEAR(*estimate.probability, GetParam().probability, 3.5 * estimate.cov * *estimate.probability);
    double const cov_of_one = estimate.cov * std::sqrt(16);
    if (GetParam().cov > 0) {
        EXPECT_NEAR(cov_of_one, GetParam().cov, 0.4 * GetParam().cov);
    }
    EXPECT_LT(cov_of_one, 0.8);
}

// chains accept about as often as is best, at every level.
TEST_P(SubsetOf, AcceptsAsOftenAsWanted) {
    LimitState const problem(dimension, GetParam().limit, GetParam().value);
    LoneWorker workers;
    auto const result = estimate_subset(problem, 1, {.seed = 5, .target_cov = 1, .replicates = 2}, workers, tuned);

    for (auto const& replicate : result.replicates) {
        for (double const acceptance : replicate.acceptance) {
            EXPECT_NEAR(acceptance, tuned.wanted_acceptance, 0.12);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Known, SubsetOf, ::testing::ValuesIn(known_cases()),
                         [](auto const& info) { return info.param.name; });

LimitState small(double limit) {
    return {64, limit, [](auto x) { return sum_of(x) / 8; }};
}

// the 95 % interval holds the probability in at least 92 of 100 repetitions.
TEST(Subset, IntervalHoldsTheProbability) {
    auto const problem = small(3.0902);
    LoneWorker workers;
    int held = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        auto const estimate =
            estimate_subset(problem, 1, {.seed = seed}, workers, {.samples = 500, .chains = 50}).estimate;
        held += estimate.interval_95.lower <= 1.0001e-3 && 1.0001e-3 <= estimate.interval_95.upper ? 1 : 0;
    }
    EXPECT_GE(held, 92);
}

// replicates are added until the wanted c.o.v. is met, as far as four times as many and max_runs go, and
// the estimate is theirs all.
TEST(Subset, AddsReplicatesUntilItIsPreciseEnough) {
    auto const problem = small(3.0902);
    LoneWorker workers;
    SubsetOptions const options{.samples = 500, .chains = 50};
    auto const coarse = estimate_subset(problem, 1, {.seed = 3, .target_cov = 1}, workers, options);
    double const wanted = 0.7 * coarse.estimate.cov;
    auto const close = estimate_subset(problem, 1, {.seed = 3, .target_cov = wanted}, workers, options);
    auto const bounded = estimate_subset(problem, 1, {.seed = 3, .target_cov = 0.01}, workers, options);
    EXPECT_EQ(coarse.replicates.size(), 8U);
    EXPECT_GT(close.replicates.size(), 8U);
    EXPECT_TRUE(close.estimate.cov <= wanted || close.replicates.size() == 32U);
    EXPECT_EQ(bounded.replicates.size(), 32U);
    for (std::size_t r = 0; r < 8; ++r) {
        EXPECT_EQ(close.estimate.replicates[r], coarse.estimate.replicates[r]) << "the first ones stay";
    }
    EXPECT_NE(close.estimate.replicates[8], close.estimate.replicates[0]);
    auto const few = estimate_subset(problem, 1, {.seed = 3, .target_cov = 0.01, .max_runs = 30000}, workers, options);
    EXPECT_LE(few.estimate.runs, 30000 + 40 * 2048);
    EXPECT_LT(few.replicates.size(), 32U);
}

// where failure is common from the start, the interval is that of plain trials.
TEST(Subset, CountsWhatIsCommon) {
    auto const problem = small(-9);
    LoneWorker workers;
    auto const estimate = estimate_subset(problem, 1, {.seed = 1}, workers).estimate;
    ASSERT_TRUE(estimate.probability.has_value());
    EXPECT_EQ(*estimate.probability, 1);
    EXPECT_EQ(estimate.interval_95.upper, 1);
    EXPECT_LT(estimate.interval_95.lower, 1);
    EXPECT_GT(estimate.interval_95.lower, 0.999);
    EXPECT_GT(estimate.crude_runs, 0);
}

// a driver that answers the same for most trials leads nowhere: nothing is stated.
TEST(Subset, RefusesAPlateau) {
    LimitState const problem(64, 4.0, [](auto x) { return x[0] > 1.5 ? x[0] : -1.0; });
    LoneWorker workers;
    auto const estimate = estimate_subset(problem, 1, {.seed = 1}, workers).estimate;

    EXPECT_EQ(estimate.state, State::not_trusted);
    EXPECT_FALSE(estimate.probability.has_value());
    EXPECT_NE(estimate.reason.find("ties"), std::string::npos) << estimate.reason;
}

/// Fails by one quantity, is driven by another that follows it loosely.
class LooselyDriven : public Problem {
  public:
    [[nodiscard]] std::size_t normals() const override { return 8; }
    void respond(std::span<double const> x, std::span<double const> factors, std::span<Answer> answers) const override {
        for (std::size_t f = 0; f < factors.size(); ++f) {
            answers[f] = {0.7 * x[0] + 0.7 * x[1], factors[f] * x[0] > 4.5, false};
        }
    }
};

// a driver that failures do not lie on top of is refused.
TEST(Subset, RefusesADriverThatIsNotNested) {
    LooselyDriven const problem;
    LoneWorker workers;
    auto const estimate = estimate_subset(problem, 1, {.seed = 1}, workers).estimate;

    EXPECT_EQ(estimate.state, State::not_trusted);
    EXPECT_FALSE(estimate.probability.has_value());
    EXPECT_NE(estimate.reason.find("driver"), std::string::npos) << estimate.reason;
}

// what cannot be reached in the levels that are allowed is not resolved, and bounded by plain trials only.
TEST(Subset, DoesNotResolveWhatItDoesNotReach) {
    auto const problem = small(6);
    LoneWorker workers;
    auto const estimate = estimate_subset(problem, 1, {.seed = 1}, workers, {.most_levels = 3}).estimate;

    EXPECT_EQ(estimate.state, State::not_resolved);
    EXPECT_FALSE(estimate.probability.has_value());
    EXPECT_EQ(estimate.interval_95.lower, 0);
    EXPECT_NEAR(estimate.interval_95.upper, 3.69 / (16000 + 2048), 1e-6);
}

// moves alone, all accepted, keep the standard normal and forget by sqrt(1 - s^2) a step.
TEST(ChainStates, MovesKeepTheNormal) {
    std::vector<SubsetNode> nodes{{}};
    for (std::int64_t step = 1; step <= 9; ++step) {
        nodes.push_back({.parent = step - 1, .level = 1, .step = step, .step_size = 0.5});
    }
    constexpr std::size_t n = 100000;
    std::vector<double> first(n);
    std::vector<double> last(n);
    normals_of_node(nodes, 0, {.seed = 3, .phase = Phase::subset}, first);
    normals_of_node(nodes, 9, {.seed = 3, .phase = Phase::subset}, last);
    double product = 0;
    double square = 0;
    double beyond = 0;
    for (std::size_t i = 0; i < n; ++i) {
        product += first[i] * last[i] / n;
        square += last[i] * last[i] / n;
        beyond += last[i] > 2 ? 1.0 : 0.0;
    }
    EXPECT_NEAR(product, .27402, 4.5 / std::sqrt(n));
    EXPECT_NEAR(square, 1, 4.5 * std::sqrt(2.0 / n));
    EXPECT_NEAR(beyond, n * .0227501, 4.5 * std::sqrt(n * .0227501));
}

/// Gives back the rows of the first stages as they were kept, and does the others' blocks last to first.
class Resumed : public Workforce {
  public:
    explicit Resumed(std::size_t kept) : kept_(kept) {}
    [[nodiscard]] std::vector<std::byte> rows_of(Stage const& stage, Work const& work) override {
        if (stage_ < first_.size()) {
            return first_[stage_++];
        }
        std::vector<std::byte> rows(static_cast<std::size_t>(stage.items) * stage.row_bytes);
        for (auto from = (stage.items - 1) / stage.block * stage.block; from >= 0; from -= stage.block) {
            auto const count = std::min(stage.block, stage.items - from);
            work(from, std::span(rows).subspan(static_cast<std::size_t>(from) * stage.row_bytes,
                                               static_cast<std::size_t>(count) * stage.row_bytes));
        }
        if (all_.size() < kept_) {
            all_.push_back(rows);
        }
        return rows;
    }
    void resume() {
        first_ = all_;
        stage_ = 0;
    }

  private:
    std::size_t kept_, stage_ = 0;
    std::vector<std::vector<std::byte>> all_, first_;
};

// R-1101: after a stop in the middle of a level chains go on as if nothing had happened, bit for bit: their states
// are made again from the identities of their draws.
TEST(Subset, GoesOnInTheMiddleOfALevel) {
    auto const problem = small(4.7534);
    LoneWorker lone;
    SubsetOptions const options{.samples = 500, .chains = 50};
    auto const whole = estimate_subset(problem, 1, {.seed = 7}, lone, options).estimate;
    for (std::size_t const kept : {1U, 7U, 24U}) {
        Resumed workers(kept);
        (void)estimate_subset(problem, 1, {.seed = 7}, workers, options);
        workers.resume();
        auto const again = estimate_subset(problem, 1, {.seed = 7}, workers, options).estimate;

        EXPECT_EQ(again.replicates, whole.replicates) << kept;
    }
}

}  // namespace
}  // namespace overturn::rare
