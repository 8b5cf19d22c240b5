// Requirement R-603: a compliant base rocks with the restitution that its body states, or says that it cannot.
#include "contact/matching.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::flat_bed;

RigidBody with_restitution(RigidBody const& body, double e) {
    return RigidBody({.mass_kg = body.mass_kg(),
                      .half_width_m = body.half_width_m(),
                      .centre_height_m = body.centre_height_m(),
                      .inertia_kgm2 = body.inertia_kgm2(),
                      .restitution = e});
}

// Of a prototype, at steps of 50 us.
TEST(ContactMatching, RestitutionEmergesFromBaseAndPoints) {
    struct Row {
        RigidBody body;
        BasePlan base;
        double soft, usual, half, hard;  // points of 0.05, 0.25, 0.50, 0.90
    };
    ContactAccuracy const fine{.step_ratio = 0.0308};
    for (auto const& [body, base, soft, usual, half, hard] :
         {Row{body_a(), testing::bed(0.3), .6826, .6971, .7465, .8557},
          Row{body_a(), testing::bed(0.5), .6424, .6595, .7127, .8130},
          Row{body_a(), testing::bed(0.7), .6112, .6304, .6870, .7764},
          Row{body_a(), testing::bed(0.9), .5829, .6067, .6653, .7522}, Row{body_a(), {}, .5687, .5964, .6556, .7443},
          Row{body_b(), flat_bed(), .8809, .8930, .9125, .9653},
          Row{body_b(), testing::bed(0.5), .8187, .8175, .8397, .9091},
          Row{body_b(), {}, .7662, .7701, .7929, .8665}}) {
        auto const gives = [&](double e) { return emergent_restitution(body, base, {.normal_restitution = e}, fine); };
        EXPECT_NEAR(gives(0.05), soft, 0.003) << *base.corner_share;
        EXPECT_NEAR(gives(0.25), usual, 0.003) << *base.corner_share;
        EXPECT_NEAR(gives(0.50), half, 0.003) << *base.corner_share;
        EXPECT_NEAR(gives(0.90), hard, 0.003) << *base.corner_share;
    }
}

TEST(ContactMatching, AFlatBedGivesBackMoreThanHousner) {
    ContactAccuracy const fine{.step_ratio = 0.0308};
    EXPECT_NEAR(emergent_restitution(body_a(), flat_bed(), {.normal_restitution = 0.05}, fine), 0.7510, 0.003);
    EXPECT_NEAR(emergent_restitution(body_a(), flat_bed(), {}, fine), 0.7639, 0.003);
    EXPECT_NEAR(emergent_restitution(body_a(), flat_bed(), {.normal_restitution = 0.5}, fine), 0.8058, 0.003);
}

TEST(ContactMatching, SharePointsOrBothGiveTheStatedRestitution) {
    for (double const e : {0.58, 0.62, 0.70, 0.76, 0.80, 0.88}) {
        auto const match = match_restitution(with_restitution(body_a(), e), {}, {});
        EXPECT_NEAR(match.restitution, e, 2e-4) << e;
        EXPECT_EQ(match.base.corner_share == 1, e < 0.596) << e;
        EXPECT_EQ(match.pad.normal_restitution < 0.25, e < 0.596) << e;
        EXPECT_EQ(match.pad.normal_restitution > 0.25, e > 0.765) << e;
    }
    auto const slender = match_restitution(with_restitution(body_b(), 0.85), {}, {});
    EXPECT_NEAR(slender.restitution, 0.85, 2e-4);
}

// The rigid body's own value lies just below what the most damped corners give.
TEST(ContactMatching, TheNearestIsTakenWhereNoBaseGivesWhatIsStated) {
    auto const least = emergent_restitution(body_a(), {}, {.normal_restitution = 0.05});
    for (double const e : {0.4, body_a().restitution()}) {
        auto const match = match_restitution(with_restitution(body_a(), e), {}, {});
        EXPECT_EQ(match.restitution, least) << e;
        EXPECT_EQ(match.base.corner_share, 1) << e;
        EXPECT_EQ(match.pad.normal_restitution, 0.05) << e;
    }
    auto const most = match_restitution(with_restitution(body_a(), 0.999), {}, {});
    EXPECT_EQ(most.restitution,
              emergent_restitution(body_a(), flat_bed(BasePlan::points_across), {.normal_restitution = 0.95}));
}

// A bed that is stated stays: only its points are tuned.
TEST(ContactMatching, AStatedBedKeepsItsShare) {
    for (double const e : {0.68, 0.72}) {
        auto const match = match_restitution(with_restitution(body_a(), e), testing::bed(0.5), {});
        EXPECT_EQ(match.base.corner_share, 0.5);
        EXPECT_NEAR(match.restitution, e, 1e-4) << e;
    }
    auto const unmatched = match_restitution(with_restitution(body_a(), 0.72), {}, {.match_restitution = false});
    EXPECT_EQ(unmatched.restitution, emergent_restitution(body_a(), {}, {}));
    EXPECT_EQ(unmatched.pad.normal_restitution, 0.25);
}

// Points all around share the load as neighbours of the lowest one come down: a round base gives back more than
// corners.
TEST(ContactMatching, ARoundBaseIsItsRimSeenFromTheSide) {
    auto const round = [](int points) { return BasePlan{.shape = BaseShape::round, .points = points}; };
    auto const block = contact_block(body_a(), round(32), {}, {});
    ASSERT_EQ(block.points.size(), 17U);
    double share = 0;
    double second = 0;
    for (auto const& point : block.points) {
        share += point.stiffness_share;
        second += point.stiffness_share * point.offset_m * point.offset_m;
    }
    EXPECT_NEAR(share, 1, 1e-15);
    EXPECT_NEAR(second, 0.5 * 0.68 * 0.68, 1e-15);  // a ring's
    EXPECT_EQ(block.points[8].offset_m, 0);
    EXPECT_GT(emergent_restitution(body_a(), round(32), {}), emergent_restitution(body_a(), {}, {}));
    EXPECT_EQ(contact_block(body_a(), round(128), {}, {}).points.size(), 33U) << "a plane takes 64 at most";
    for (int const points : {8, 18, 260}) {
        testing::expect_input_error([&] { static_cast<void>(contact_block(body_a(), round(points), {}, {})); },
                                    "round base");
    }
}

}  // namespace
}  // namespace overturn
