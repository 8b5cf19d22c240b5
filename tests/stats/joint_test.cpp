// Requirement R-701: of several bodies under one wave it is reported how likely any of them falls, exactly, and whether
// they fall together.
#include "stats/joint.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

constexpr auto stood = JointEnd::stood;
constexpr auto fell = JointEnd::overturned;
constexpr auto open = JointEnd::undecided;

/// By hand: of ten waves at 2 the first body falls in 4, the second in 3, both in 2.
TEST(Joint, CountsByHand) {
    std::vector<JointTrial> trials;
    auto const add = [&](int times, double amplitude, std::vector<JointEnd> const& ends) {
        trials.insert(trials.end(), static_cast<std::size_t>(times), JointTrial{amplitude, ends});
    };
    add(2, 2, {fell, fell});
    add(2, 2, {fell, stood});
    add(1, 2, {stood, fell});
    add(5, 2, {stood, stood});
    add(3, 1, {stood, stood});
    add(1, 1, {stood, open});
    add(1, 1, {fell, open});
    auto const joint = study_joint(trials);

    ASSERT_EQ(joint.any.size(), 2U) << "levels rise";
    EXPECT_EQ(joint.any[0].amplitude, 1);
    EXPECT_EQ(joint.any[0].overturned, 1) << "one that fell decides, whatever the other did";
    EXPECT_EQ(joint.any[0].undecided, 1);
    EXPECT_EQ(joint.any[1].overturned, 5);
    EXPECT_EQ(joint.any[1].interval(0.95).upper, clopper_pearson(5, 10, 0.95).upper);
    EXPECT_NEAR(joint.if_independent[1], 1 - 0.6 * 0.7, 1e-12);
    ASSERT_EQ(joint.pairs.size(), 1U);
    EXPECT_FALSE(joint.pairs[0].phi[0]) << "where both were decided both stood throughout";
    EXPECT_NEAR(*joint.pairs[0].phi[1], (2 * 5 - 2 * 1) / std::sqrt(4.0 * 6 * 3 * 7), 1e-12);
    EXPECT_NEAR(*joint.pairs[0].pooled, *joint.pairs[0].phi[1], 1e-12) << "a level without variance adds nothing";
}

/// The same body twice is one body: phi is 1, any is each. Its opposite has phi -1 and always one that falls.
TEST(Joint, TwinsFallTogether) {
    std::vector<JointTrial> twins;
    std::vector<JointTrial> opposites;
    for (int i = 0; i < 20; ++i) {
        auto const end = i % 3 == 0 ? fell : stood;
        twins.push_back({1.0 + i % 2, {end, end}});
        opposites.push_back({1.0 + i % 2, {end, end == fell ? stood : fell}});
    }
    auto const same = study_joint(twins);
    EXPECT_NEAR(*same.pairs[0].pooled, 1, 1e-12);
    EXPECT_EQ(same.any[0].overturned + same.any[1].overturned, 7);
    auto const other = study_joint(opposites);
    EXPECT_NEAR(*other.pairs[0].pooled, -1, 1e-12);
    EXPECT_EQ(other.any[0].probability(), 1);
}

/// Levels by themselves: what is only the common rise with the level is no correlation under one wave.
TEST(Joint, PoolingKeepsLevelsApart) {
    std::vector<JointTrial> trials;
    for (int i = 0; i < 100; ++i) {
        trials.push_back({1, {i % 10 == 0 ? fell : stood, i / 10 == 0 ? fell : stood}});
        trials.push_back({2, {i % 10 != 0 ? fell : stood, i / 10 != 0 ? fell : stood}});
    }
    auto const joint = study_joint(trials);
    EXPECT_NEAR(*joint.pairs[0].pooled, 0, 1e-12);
    EXPECT_TRUE(study_joint({}).any.empty());
}

}  // namespace
}  // namespace overturn
