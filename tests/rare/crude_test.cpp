// Requirement R-802: plain trials state a probability only where enough of them failed and few enough were undecided;
// else an exact bound, which counts undecided trials as both.
#include "rare/crude.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace overturn::rare {
namespace {

/// Fails above a bound of its only normal, and does not know right below it.
class Threshold : public Problem {
  public:
    Threshold(double undecided_from, double fails_from) : undecided_from_(undecided_from), fails_from_(fails_from) {}
    [[nodiscard]] std::size_t normals() const override { return 1; }
    void respond(std::span<double const> normals, std::span<double const> /*factors*/,
                 std::span<Answer> answers) const override {
        for (auto& answer : answers) {
            answer = {};
            answer.failed = normals[0] > fails_from_;
            answer.undecided = !answer.failed && normals[0] > undecided_from_;
        }
    }

  private:
    double undecided_from_, fails_from_;
};

Estimate estimate_of(Threshold const& problem, std::int64_t runs) {
    LoneWorker workers;
    return estimate_crude(problem, std::vector{1.0}, {.seed = 3, .target_cov = 1e-9, .max_runs = runs}, workers)
        .front();
}

// P = 2e-3 fails some of 2000, hardly ever ten.
TEST(Crude, AFewFailuresAreABoundAlone) {
    auto const made = estimate_of({3, 2.878}, 2000);

    EXPECT_EQ(made.state, State::not_resolved);
    EXPECT_FALSE(made.probability.has_value());
    EXPECT_GT(made.interval_95.upper, 2e-3);
}

// P = 0.05 fails, and 0.0005 or 0.0133 are undecided: a hundredth of it, and more than a quarter.
TEST(Crude, ManyUndecidedTrialsAreNotTrusted) {
    auto const few = estimate_of({1.6403, 1.6449}, 20'000);
    auto const many = estimate_of({1.5276, 1.6449}, 20'000);

    EXPECT_EQ(few.state, State::trusted) << few.reason;
    EXPECT_EQ(many.state, State::not_trusted);
    EXPECT_FALSE(many.probability.has_value());
    EXPECT_NE(many.reason.find("undecided"), std::string::npos) << many.reason;
    EXPECT_LT(many.interval_95.lower, 0.051);
    EXPECT_GT(many.interval_95.upper, 0.0625) << "they may all have failed";
}

// The binomial law: cov = sqrt((1 - p) / (n p)).
TEST(Crude, StatesTheBinomialScatter) {
    auto const made = estimate_of({2, 1.6449}, 20'000);

    ASSERT_EQ(made.state, State::trusted) << made.reason;
    double const p = *made.probability;
    EXPECT_NEAR(p, 0.05, 4 * 0.05 * made.cov);
    EXPECT_NEAR(made.cov, std::sqrt((1 - p) / (20'000 * p)), 1e-12);
}

}  // namespace
}  // namespace overturn::rare
