// Requirement R-412: every quantity that a limit state may be set to has a limit as the step shrinks, in every model:
// over many trials its error falls with the step and its mean stays.
#include "relations/step_error.hpp"

#include <iostream>

#include <gtest/gtest.h>

namespace overturn {
namespace {

using testing::Family;
using testing::Halving;

constexpr std::size_t times = 3;  // the step, its half and its quarter, each against the half of it

/// From a step to its half: median of the differences, of trials that end the same way, by how much the mean may move,
/// and trials that end otherwise.
struct Bounds {
    double median, drift, flips_per_thousand;
};
/// Rigid bodies step from event to event: what is left is rounding, but that slow bounces are counted by the sample.
constexpr Bounds rigid{1e-12, 5e-3, 0};
constexpr Bounds on_points{0.03, 0.06, 20};
/// Of first order it would be a quarter after two halvings.
constexpr double falls_to = 0.5;

void print(std::string const& name, std::vector<Halving> const& all) {
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::cout << fmt::format("{:<16} step / {}: {} of {} end otherwise\n", name, 1 << k, all[k].flips,
                                 all[k].trials);
    }
    for (auto const& [quantity, values] : all.front().differences) {
        std::cout << fmt::format("{:<16} {:<26}", name, quantity);
        for (auto const& halving : all) {
            std::cout << fmt::format("  {:.1e} {:.1e} drift {:.1e}", halving.quantile(quantity, 0.5),
                                     halving.quantile(quantity, 0.95), halving.drift(quantity));
        }
        std::cout << "\n";
    }
}

void expect_limits(std::string const& name, std::vector<Halving> const& all, Bounds const& bounds) {
    print(name, all);
    auto const& first = all.front();
    EXPECT_LE(static_cast<double>(first.flips), bounds.flips_per_thousand / 1000 * static_cast<double>(first.trials));
    ASSERT_GE(first.differences.size(), 1U);
    for (auto const& [quantity, values] : first.differences) {
        double const median = first.quantile(quantity, 0.5);
        EXPECT_LE(median, bounds.median) << quantity;
        for (auto const& halving : all) {
            EXPECT_LE(halving.drift(quantity), bounds.drift) << quantity;
        }
        if (median > rigid.median) {
            EXPECT_LE(all.back().quantile(quantity, 0.5), falls_to * median) << quantity;
        }
    }
}

/// Models of a kind together: so many trials that a median does not hang on a few of them.
void expect_limits_of_kind(std::string const& name, bool points, bool space, Bounds const& bounds) {
    std::vector<Halving> all(times);
    for (auto const& family : testing::families) {
        if (family.points == points && family.space == space) {
            auto const one = testing::halvings(family, 1, 2, times);
            for (std::size_t k = 0; k < times; ++k) {
                all[k].add(one[k]);
            }
        }
    }
    expect_limits(name, all, bounds);
}

TEST(StepError, FallsInEveryQuantityOfRigidBodies) { expect_limits_of_kind("rigid", false, false, rigid); }
TEST(StepError, FallsInEveryQuantityOfBodiesOnPoints) { expect_limits_of_kind("contact", true, false, on_points); }
TEST(StepError, FallsInEveryQuantityInSpace) { expect_limits_of_kind("space", true, true, on_points); }

class StepErrorLong : public ::testing::TestWithParam<Family> {};
TEST_P(StepErrorLong, FallsInEveryModel) {
    auto const& family = GetParam();
    expect_limits(family.name, testing::halvings(family, 3, 14, times), family.points ? on_points : rigid);
}
INSTANTIATE_TEST_SUITE_P(Models, StepErrorLong, ::testing::ValuesIn(testing::families), [](auto const& info) {
    std::string name = info.param.name;
    std::erase_if(name, [](char c) { return c == ' ' || c == '-'; });
    return name;
});

}  // namespace
}  // namespace overturn
