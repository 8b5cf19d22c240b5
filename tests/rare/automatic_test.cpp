// Requirement: left to itself the program chooses an estimator that fits, changes its mind where one
// cannot be trusted, and states nothing that none can be trusted with.
#include "rare/automatic.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/limit_states.hpp"

namespace overturn::rare {
namespace {

using testing::LimitState;
using testing::sum_of;

/// Linear in 64 normals, of which it says that they are lines, and cannot say when it failed.
class Misleading : public LimitState {
  public:
    Misleading() : LimitState(64, 4.0, [](auto x) { return std::abs(sum_of(x.first(4))) / 2; }) {}
    [[nodiscard]] std::optional<PulseFrame> frame() const override {
        return PulseFrame{.lines = 16, .spacing_radps = 0.1, .duration_s = 60, .body_period_s = 0.5};
    }
    [[nodiscard]] Moment moment(std::span<double const> x, double /*factor*/) const override {
        return {30 + 20 * std::sin(1000 * x[60]), 1};
    }
};

// plain trials where they do, subset simulation for what is rarer; each level's estimate in its place.
TEST(Automatic, CountsWhatIsCommonAndSamplesWhatIsRare) {
    LimitState const problem(64, 4.0, [](auto x) { return sum_of(x) / 8; });
    LoneWorker workers;
    std::vector<double> const factors{1.0, 2.0, 1.2};
    std::vector<double> const exact{3.16712e-5, 2.27501e-2, 4.29060e-4};

    auto const estimates = estimate(problem, factors, {}, {.seed = 4}, workers);

    EXPECT_EQ(estimates[0].method, Method::subset);
    EXPECT_EQ(estimates[1].method, Method::crude);
    EXPECT_EQ(estimates[2].method, Method::subset);
    for (std::size_t f = 0; f < factors.size(); ++f) {
        ASSERT_EQ(estimates[f].state, State::trusted) << estimates[f].reason;
        EXPECT_EQ(estimates[f].factor, factors[f]);
        EXPECT_NEAR(*estimates[f].probability, exact[f], 3.5 * estimates[f].cov * exact[f]);
        EXPECT_LE(estimates[f].interval_95.lower, exact[f]);
        EXPECT_GE(estimates[f].interval_95.upper, exact[f]);
    }
    EXPECT_LE(estimates[1].cov, 0.11);
}

// where pulses lead astray the pulse mixture is not trusted, and subset simulation answers.
TEST(Automatic, ChangesItsMind) {
    Misleading const problem;
    LoneWorker workers;
    std::vector<double> const factors{1.0};
    double const exact = 6.33425e-5;
    Record record;

    auto const chosen = estimate(problem, factors, {}, {.seed = 4}, workers, &record).front();
    auto const insisted = estimate(problem, factors, Method::pulse_mixture, {.seed = 4}, workers).front();

    EXPECT_EQ(chosen.method, Method::subset);
    ASSERT_EQ(chosen.state, State::trusted) << chosen.reason;
    EXPECT_NEAR(*chosen.probability, exact, 3.5 * chosen.cov * exact);
    ASSERT_EQ(record.mixtures.size(), 1U);
    EXPECT_NE(record.mixtures.front().estimates.front().state, State::trusted);
    EXPECT_GT(chosen.runs, record.subsets.front().estimate.runs);  // what was in vain counts too
    ASSERT_EQ(chosen.tried.size(), 1U);                            // and what was in vain is told
    EXPECT_NE(chosen.tried.front().find("pulse-mixture"), std::string::npos) << chosen.tried.front();
    EXPECT_NE(chosen.tried.front().find("not-"), std::string::npos) << chosen.tried.front();
    EXPECT_EQ(insisted.state, State::not_trusted);
    EXPECT_FALSE(insisted.probability.has_value());
}

/// Passed by every wave, of a problem that a mixture of pulses could be asked about.
class Certain : public LimitState {
  public:
    Certain() : LimitState(64, 4.0, [](auto) { return 5.0; }) {}
    [[nodiscard]] std::optional<PulseFrame> frame() const override {
        return PulseFrame{.lines = 16, .spacing_radps = 0.1, .duration_s = 60, .body_period_s = 0.5};
    }
    [[nodiscard]] Moment moment(std::span<double const> /*x*/, double /*factor*/) const override { return {30, 1}; }
};

// where every wave fails there are no failure pulses to look for: plain trials answer at once.
TEST(Automatic, CountsWhatIsCertainWhateverIsAskedFor) {
    Certain const problem;
    LoneWorker workers;
    std::vector<double> const factors{1.0};

    auto const made = estimate(problem, factors, Method::pulse_mixture, {.seed = 4}, workers).front();

    EXPECT_EQ(made.method, Method::crude);
    ASSERT_EQ(made.state, State::trusted) << made.reason;
    EXPECT_EQ(*made.probability, 1);
    EXPECT_GT(made.interval_95.lower, 0.999);
    EXPECT_LE(made.runs, 4200);
}

// plain trials that saw fewer than ten failures give a bound, no probability.
TEST(Crude, DoesNotResolveWhatItHardlySaw) {
    LimitState const problem(4, 4.0, [](auto x) { return sum_of(x) / 2; });
    LoneWorker workers;
    std::vector<double> const factors{1.0};

    auto const made = estimate(problem, factors, Method::crude, {.seed = 1, .max_runs = 10000}, workers).front();

    EXPECT_EQ(made.state, State::not_resolved);
    EXPECT_FALSE(made.probability.has_value());
    EXPECT_EQ(made.interval_95.lower, 0);
    EXPECT_GT(made.interval_95.upper, 3.2e-5);
}

// the intervals that estimates state are those of the formulas.
TEST(Estimate, IntervalsAreTheStatedOnes) {
    auto const none = clopper_pearson({.failed = 0, .undecided = 0, .trials = 10000});
    auto const some = clopper_pearson({.failed = 5, .undecided = 1, .trials = 20});
    auto const mean = mean_of_replicates(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});

    EXPECT_EQ(none.lower, 0);
    EXPECT_NEAR(none.upper, 3.6882e-4, 1e-8);
    EXPECT_NEAR(some.lower, 0.08657, 1e-5);  // of 5 of 20
    EXPECT_NEAR(some.upper, 0.54279, 1e-5);  // of 6 of 20
    auto const many =
        clopper_pearson({.failed = 107, .undecided = 0, .trials = 12400});  // GSL's own inverse fails here
    EXPECT_NEAR(many.lower, 7.078e-3, 5e-6);
    EXPECT_NEAR(many.upper, 1.0417e-2, 5e-6);
    EXPECT_NEAR(mean.standard_error, std::sqrt(6.0 / 8), 1e-12);
    EXPECT_NEAR(std::log(mean.interval_95.upper < 1 ? 0 : mean.mean / mean.interval_95.lower),
                2.364624 * std::sqrt(0.75) / 4.5, 1e-6);
}

}  // namespace
}  // namespace overturn::rare
