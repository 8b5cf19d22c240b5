// Requirement: a compliant base rocks with the restitution that its body states, or says that it cannot.
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
        ContactBase base;
        double soft, usual, half, hard;  // points of 0.05, 0.25, 0.50, 0.90
    };
    ContactAccuracy const fine{.step_ratio = 0.0308};
    for (auto const& [body, base, soft, usual, half, hard] :
         {Row{body_a(), {0.3, 11}, .6826, .6971, .7465, .8557}, Row{body_a(), {0.5, 11}, .6424, .6595, .7127, .8130},
          Row{body_a(), {0.7, 11}, .6112, .6304, .6870, .7764}, Row{body_a(), {0.9, 11}, .5829, .6067, .6653, .7522},
          Row{body_a(), {}, .5687, .5964, .6556, .7443}, Row{body_b(), flat_bed(), .8809, .8930, .9125, .9653},
          Row{body_b(), {0.5, 11}, .8187, .8175, .8397, .9091}, Row{body_b(), {}, .7662, .7701, .7929, .8665}}) {
        auto const gives = [&](double e) { return emergent_restitution(body, base, {.normal_restitution = e}, fine); };
        EXPECT_NEAR(gives(0.05), soft, 0.003) << base.corner_share;
        EXPECT_NEAR(gives(0.25), usual, 0.003) << base.corner_share;
        EXPECT_NEAR(gives(0.50), half, 0.003) << base.corner_share;
        EXPECT_NEAR(gives(0.90), hard, 0.003) << base.corner_share;
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

TEST(ContactMatching, WhatNoBaseGivesIsRefused) {
    testing::expect_input_error([] { static_cast<void>(match_restitution(with_restitution(body_a(), 0.4), {}, {})); },
                                "0.4000", "at least 0.568");
    testing::expect_input_error([] { static_cast<void>(match_restitution(with_restitution(body_a(), 0.999), {}, {})); },
                                "0.9990", "at most");
    // The rigid body's own value lies just below what the most damped corners give.
    testing::expect_input_error([] { static_cast<void>(match_restitution(body_a(), {}, {})); }, "0.5538", "at least");
}

}  // namespace
}  // namespace overturn
