// Requirement R-703: stopping when precise enough stops by the interval's own width, and the intervals of what it
// leaves still hold.
#include "stats/precision.hpp"

#include <map>

#include <fmt/format.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

namespace overturn {
namespace {

TEST(Precision, LooksDouble) {
    EXPECT_EQ(looks(1, 32, 400), (std::vector<std::int64_t>{32, 64, 128, 256}));
    EXPECT_EQ(looks(3, 32, 400), (std::vector<std::int64_t>{48, 96, 192, 384}));
    EXPECT_EQ(looks(1, 32, 32), std::vector<std::int64_t>{}) << "the last size is no choice";
}

TEST(Precision, EveryStripeCounts) {
    Stripe const sure{.amplitude = 1, .trials = 400, .overturned = 0};
    Stripe const unsure{.amplitude = 2, .trials = 400, .overturned = 200};
    auto const width = unsure.interval(0.95).upper - unsure.interval(0.95).lower;

    EXPECT_TRUE(is_precise(std::vector{sure}, 0.01, 0.95));
    EXPECT_FALSE(is_precise(std::vector{sure, unsure}, 0.01, 0.95));
    EXPECT_TRUE(is_precise(std::vector{sure, unsure}, width / 2, 0.95));
    EXPECT_FALSE(is_precise(std::vector{sure, unsure}, width / 2 - 1e-9, 0.95));
    EXPECT_FALSE(is_precise(FragilityFit{}, 0.5)) << "no curve, no median";
}

// Intervals of all counts at some sizes, which many rules and probabilities share.
class Intervals {
  public:
    explicit Intervals(std::vector<std::int64_t> sizes) : sizes_(std::move(sizes)) {
        for (auto const n : sizes_) {
            for (std::int64_t k = 0; k <= n; ++k) {
                of_[n].push_back(clopper_pearson(k, n, 0.95));
            }
        }
    }
    [[nodiscard]] std::vector<std::int64_t> const& sizes() const { return sizes_; }
    [[nodiscard]] Interval const& at(std::size_t k, std::int64_t n) const { return of_.at(n)[k]; }

  private:
    std::vector<std::int64_t> sizes_;
    std::map<std::int64_t, std::vector<Interval>> of_;
};

struct Outcome {
    double coverage = 0, size = 0;
};

// Chance that the interval at the size where the rule stops holds p, and the mean size: exact, by carrying the
// distribution of the count from look to look. The last size is where the campaign ends anyway.
Outcome outcome_of(double p, double target, Intervals const& intervals) {
    Outcome outcome;
    std::vector<double> chance{1};
    std::int64_t before = 0;
    for (auto const size : intervals.sizes()) {
        auto const fresh = size - before;
        std::vector<double> next(static_cast<std::size_t>(size) + 1, 0.0);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(fresh); ++k) {
            double const step = gsl_ran_binomial_pdf(static_cast<unsigned>(k), p, static_cast<unsigned>(fresh));
            for (std::size_t i = 0; step > 0 && i < chance.size(); ++i) {
                next[i + k] += chance[i] * step;
            }
        }
        for (std::size_t k = 0; k < next.size(); ++k) {
            auto const& ends = intervals.at(k, size);
            if (size == intervals.sizes().back() || (ends.upper - ends.lower) / 2 <= target) {
                outcome.coverage += ends.lower <= p && p <= ends.upper ? next[k] : 0;
                outcome.size += next[k] * static_cast<double>(size);
                next[k] = 0;
            }
        }
        chance = std::move(next);
        before = size;
    }
    return outcome;
}

double lowest_coverage(double target, Intervals const& intervals) {
    double lowest = 1;
    for (double p = 0.005; p < 0.5; p += 0.005) {
        lowest = std::min(lowest, outcome_of(p, target, intervals).coverage);
    }
    return lowest;
}

/// Over P from 0.5 % to 50 % the 95 % interval at the end holds P in at least 93.5 % of all campaigns, whichever
/// target.
TEST(Precision, IntervalsHoldUnderTheRule) {
    constexpr std::int64_t most = 1024;
    auto sizes = looks(1, 32, most);
    sizes.push_back(most);
    Intervals const doubling(sizes);
    for (double const target : {0.03, 0.05, 0.1}) {
        double const lowest = lowest_coverage(target, doubling);
        EXPECT_GE(lowest, 0.935) << target;
    }
}

/// How often one looks matters little for a rule that goes by the width alone: after every wave or at doubling sizes.
TEST(Precision, TheNumberOfLooksMattersLittle) {
    constexpr std::int64_t most = 300;
    std::vector<std::int64_t> always;
    for (std::int64_t n = 32; n <= most; ++n) {
        always.push_back(n);
    }
    auto sizes = looks(1, 32, most);
    sizes.push_back(most);
    constexpr double target = 0.08;
    double const every_wave = lowest_coverage(target, Intervals(always));
    double const doubling = lowest_coverage(target, Intervals(sizes));
    EXPECT_GE(every_wave, 0.935);
    EXPECT_GE(doubling, 0.935);
}

}  // namespace
}  // namespace overturn
