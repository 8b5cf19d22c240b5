// Requirement R-305: where parts stand on parts, statics shows at which acceleration they tip or slide there.
#include "body/joints.hpp"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

/// campaigns/bodies/cask_prototype.toml.
TEST(Joints, ACaskOnItsPalletTipsAtItsOwnSlenderness) {
    auto const joints = joints_of(std::vector<BodyPart>{Cylinder{117e3, 1.25, 5.4, 0.35}, Box{21e3, 3.4, 0.35, 0.0}});

    ASSERT_EQ(joints.size(), 1U);
    auto const& joint = joints.front();
    EXPECT_EQ(joint.height_m, 0.35);
    EXPECT_EQ(joint.mass_kg, 117e3);
    EXPECT_EQ(joint.half_width_m, 1.25);
    EXPECT_TRUE(near(joint.centre_above_m, 2.7, exact_formula));
    EXPECT_TRUE(near(joint.parts_at(), 1.25 / 2.7, exact_formula));
    EXPECT_FALSE(joint.slides_first());
    EXPECT_FALSE(joint.fastened);
    EXPECT_EQ(joint.parts, std::vector<std::size_t>{0});
}

/// Each level carries all above it, on the narrower of two faces, by the parallel-axis theorem's moments.
TEST(Joints, EachLevelCarriesAllAboveIt) {
    auto const joints = joints_of(std::vector<BodyPart>{Box{20, 3.0, 1.0, 0.0}, Cylinder{40, 0.5, 2.0, 1.0},
                                                        Box{10, 2.0, 1.0, 3.0}, PointMass{5, 3.2}, PointMass{7, 0.5}});

    ASSERT_EQ(joints.size(), 2U);
    EXPECT_EQ(joints[0].mass_kg, 55);
    EXPECT_EQ(joints[0].half_width_m, 0.5);
    EXPECT_TRUE(near(joints[0].centre_above_m, (40 * 1.0 + 10 * 2.5 + 5 * 2.2) / 55, exact_formula));
    EXPECT_EQ(joints[1].mass_kg, 15);
    EXPECT_EQ(joints[1].half_width_m, 0.5) << "the part below is the narrower one";
    EXPECT_TRUE(near(joints[1].centre_above_m, (10 * 0.5 + 5 * 0.2) / 15, exact_formula));
}

TEST(Joints, FrictionBelowSlendernessSlidesFirst) {
    auto const of = [](double friction) {
        return joints_of(std::vector<BodyPart>{Box{20, 3.0, 1.0, 0.0},
                                               Cylinder{40, 0.5, 2.0, 1.0, {.fastened = false, .friction = friction}}})
            .front();
    };
    EXPECT_TRUE(of(0.3).slides_first());
    EXPECT_EQ(of(0.3).parts_at(), 0.3);
    EXPECT_FALSE(of(0.6).slides_first());
    EXPECT_EQ(of(0.6).parts_at(), 0.5);
}

/// A shell that reaches through, a gap beneath, a part on the ground and points: what holds them is not known.
TEST(Joints, NoneIsGuessedWhereNoneIsKnown) {
    EXPECT_TRUE(joints_of(std::vector<BodyPart>{Cylinder{60, 1.0, 5.0, 0.0}, Cylinder{20, 0.8, 4.0, 0.5}}).empty());
    EXPECT_TRUE(joints_of(std::vector<BodyPart>{Box{20, 3.0, 0.3, 0.0}, Cylinder{40, 0.5, 2.0, 0.35}}).empty());
    EXPECT_TRUE(joints_of(std::vector<BodyPart>{Box{20, 3.0, 0.3, 0.0}, PointMass{40, 0.3}}).empty());
    EXPECT_FALSE(joints_of(std::vector<BodyPart>{Box{20, 3.0, 0.3, 0.0}, Cylinder{40, 0.5, 2.0, 0.301}}).empty())
        << "they meet within a thousandth of the height";
}

// What stands a little too low or too high is not passed over.
TEST(Joints, PartsThatMeetNothingAreNamed) {
    using Places = std::vector<std::size_t>;
    auto const of = [](BodyPart const& upper) {
        return without_joint(std::vector<BodyPart>{Box{20, 3.0, 0.35, 0.0}, upper});
    };
    EXPECT_EQ(of(Cylinder{40, 0.5, 2.0, 0.34}), Places{1}) << "a centimetre too low";
    EXPECT_EQ(of(Cylinder{40, 0.5, 2.0, 0.40}), Places{1}) << "a gap";
    EXPECT_EQ(of(Cylinder{40, 0.5, 2.0, 0.34, {true, {}}}), Places{}) << "fastened";
    EXPECT_EQ(of(Cylinder{40, 0.5, 2.0, 0.35}), Places{}) << "it stands there";
    EXPECT_EQ(of(Cylinder{40, 0.5, 0.2, 0.1}), Places{}) << "contents";
    EXPECT_EQ(of(Cylinder{40, 0.5, 2.0, 0.0}), Places{}) << "on the ground";
    EXPECT_EQ(of(PointMass{40, 0.4}), Places{});
}

// A container reaches as far as its contents in height and in width.
TEST(Joints, OnlyWhatIsWideEnoughHoldsContents) {
    using Places = std::vector<std::size_t>;
    auto const of = [](BodyPart const& first, BodyPart const& second) {
        return without_joint(std::vector<BodyPart>{Box{20, 3.0, 0.35, 0.0}, first, second});
    };
    Cylinder const cask{40, 1.0, 2.0, 0.40};
    EXPECT_EQ(of(cask, cask), (Places{1, 2})) << "two over one gap: neither holds the other";
    EXPECT_EQ(of(cask, Cylinder{40, 0.8, 2.0, 0.40}), Places{1}) << "a liner as tall as its shell";
    EXPECT_EQ(of(cask, Cylinder{1, 0.1, 3.0, 0.0}), Places{1}) << "a thin post beside it";
    EXPECT_EQ(of(cask, Box{10, 2.0, 1.0, 0.8}), Places{1}) << "contents as wide as what holds them";
}

TEST(Joints, AreFastenedWhereAllThatStandsThereIs) {
    auto const of = [](bool cask, bool crate) {
        std::vector<BodyPart> const parts{Box{20, 3.0, 1.0, 0.0}, Cylinder{40, 0.5, 2.0, 1.0, {cask, {}}},
                                          Box{1, 0.2, 0.2, 1.0, {crate, {}}}};
        EXPECT_EQ(any_loose(parts), !(cask && crate));
        return joints_of(parts).front().fastened;
    };
    EXPECT_TRUE(of(true, true));
    EXPECT_FALSE(of(true, false));
    EXPECT_FALSE(of(false, true));
    EXPECT_FALSE(any_loose(std::vector<BodyPart>{Box{20, 3.0, 1.0, 0.0}, PointMass{1, 1.0}}));
    EXPECT_TRUE(any_loose(std::vector<BodyPart>{Cylinder{60, 1.0, 5.0, 0.0}, Cylinder{20, 0.8, 4.0, 0.5}}))
        << "contents that may be loose, though nothing is known of how";
}

}  // namespace
}  // namespace overturn
