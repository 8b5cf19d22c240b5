// Requirement R-601: a point of the base presses as the stated law says: it settles, vibrates and rebounds as the
// closed forms do, and a base or a pad that makes no sense is refused.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::constant;
using testing::ContactHistory;
using testing::on_corners;
using testing::shaken;
using testing::steps_of;

// Dropped by 1 mm, after 3 s: g / w_v^2 below where it would touch.
TEST(ContactLaw, SettlesByItsWeight) {
    auto const block = on_corners(body_a(), 0.8);
    ContactHistory history;
    static_cast<void>(shaken(block, constant(0, 3001), 1e-3, {.longest_after_s = 0, .rest_gate = false}, &history,
                             ContactStart{.rise_m = 1e-3 + block.settlement_m()}));
    EXPECT_NEAR(history.instants.back().rise_m, -2.586478e-5, 1e-11);  // the digits of the reference
    EXPECT_NEAR(history.instants.back().rise_m, -block.settlement_m(), 1e-12);
}

TEST(ContactLaw, VibratesAtTheStatedFrequency) {
    auto const block = on_corners(body_a(), 0.8, {.normal_restitution = 1});
    ContactHistory history;
    auto accuracy = steps_of(5e-5, block);
    accuracy.longest_after_s = 0;
    static_cast<void>(shaken(block, constant(0, 501), 1e-3, accuracy, &history, ContactStart{.rise_m = 1e-6}));
    for (auto& instant : history.instants) {
        instant.rise_m += block.settlement_m();
    }
    auto const zero = [&](double from) {
        return history.zero_of(&ContactInstant::rise_m, &ContactInstant::rise_mps, from);
    };
    double const first = zero(0);
    double const last = zero(first + (40 - 0.25) / 98);  // 40 periods on
    EXPECT_NEAR(40 / (last - first) / 98, 1, 1e-6);
}

// Dropped flat on both corners, as good as without weight: e_n, whatever the speed.
TEST(ContactLaw, ReboundsWithTheStatedRestitution) {
    for (double const e : {0.25, 0.5, 0.8}) {
        for (double const speed : {0.1, 1.0, 5.0}) {
            auto block = on_corners(body_a(), 0.8, {.normal_restitution = e});
            block.gravity_mps2 = 1e-9;
            auto const rebound = [&](double step_s) {
                auto accuracy = steps_of(step_s, block);
                accuracy.longest_after_s = 0;
                ContactHistory history;
                static_cast<void>(shaken(block, constant(0, 41), 1e-3, accuracy, &history,
                                         ContactStart{.rise_m = 1e-3 * speed, .rise_mps = -speed}));
                return history.instants.back().rise_mps / speed;
            };
            EXPECT_NEAR(rebound(5e-4), e, e == 0.8 ? 0.0025 : 0.001) << speed;
            EXPECT_NEAR(rebound(1e-5), e, 1e-6) << speed;
        }
    }
}

// The largest force of a flat drop over v sqrt(k m), which says what impact may crush a pad: elastic 1, and the law of
// one point integrated apart from this program.
TEST(ContactLaw, PeakForceOfADropByRestitution) {
    struct Peak {
        double restitution, force;
    };
    for (auto const& [e, force] : {Peak{1, 1}, {0.25, 1.31}, {0.1, 1.87}, {0.05, 2.54}}) {
        for (double const speed : {0.1, 1.0}) {
            auto block = on_corners(body_a(), 0.8, {.normal_restitution = e});
            block.gravity_mps2 = 1e-9;
            auto accuracy = steps_of(1e-5, block);
            accuracy.longest_after_s = 0;
            ContactHistory history;
            static_cast<void>(shaken(block, constant(0, 41), 1e-3, accuracy, &history,
                                     ContactStart{.rise_m = 1e-3 * speed, .rise_mps = -speed}));
            double largest = 0;  // over the weight
            for (auto const& instant : history.instants) {
                largest = std::max(largest, instant.contact_force_ratio);
            }
            double const found = largest * block.gravity_mps2 / (speed * block.vertical_radps());
            EXPECT_NEAR(found, force, 0.01) << e;
        }
    }
}

// y of e_n, and e_n of y = chi v (Hunt & Crossley's law with one approach speed).
TEST(ContactLaw, DampingFollowsFromRestitution) {
    struct Pair {
        double restitution, damping, digits;
    };
    for (auto const& [e, y, digits] : {Pair{0.10, 9.99815940, 1e-8},
                                       {0.25, 3.84080604, 1e-8},
                                       {0.50, 1.43275053, 1e-8},
                                       {0.80, 0.37314620, 1e-8},
                                       {0.90, 0.16648195, 1e-8},
                                       {0.93747558, 0.1, 1e-7},
                                       {0.74843493, 0.5, 1e-7},
                                       {0.59362426, 1, 1e-7},
                                       {0.19698025, 5, 1e-6}}) {
        EXPECT_NEAR(normal_damping(e), y, digits) << e;
    }
    EXPECT_EQ(normal_damping(1), 0);
}

//
TEST(ContactLaw, LayoutsShareTheStiffness) {
    for (auto const& base : {BasePlan{}, testing::flat_bed(), testing::flat_bed(31), testing::bed(0.3)}) {
        auto const block = contact_block(body_a(), base, {}, {});
        double sum = 0;
        double second = 0;
        for (auto const& point : block.points) {
            sum += point.stiffness_share;
            second += point.stiffness_share * point.offset_m * point.offset_m / (0.68 * 0.68);
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_EQ(block.points.size(), base.corner_share == 1 ? 2U : static_cast<std::size_t>(base.points));
        if (base.points == 11 && base.corner_share < 0.2) {
            EXPECT_NEAR(second, 0.34, 1e-14);  // an even bed has 1/3
        }
    }
}

void expect_refused(BasePlan const& base, Pad const& pad, std::string const& part) {
    testing::expect_input_error([&] { static_cast<void>(contact_block(body_a(), base, pad, {})); }, part);
}

//
TEST(ContactLaw, WhatBearsNothingIsRefused) {
    expect_refused({}, {.strength_pa = 0}, "strength");
    expect_refused(testing::bed(1, 1), {}, "1 points");
    expect_refused(testing::bed(0.5, 1000), {}, "1000 points");
    expect_refused(testing::bed(0.05), {}, "share");
    expect_refused(testing::bed(1.1), {}, "share");
    expect_refused({.shape = BaseShape::polygon}, {}, "in space");
    expect_refused({}, {.normal_restitution = 0}, "restitution");
    expect_refused({}, {.normal_restitution = 1.01}, "restitution");
    expect_refused({}, {.vertical_frequency_hz = -1}, "frequency");
    expect_refused({}, {.vertical_frequency_hz = std::numeric_limits<double>::quiet_NaN()}, "frequency");
}

}  // namespace
}  // namespace overturn
