// Requirement R-601: points grip the ground by Coulomb friction without creep, and hard cases of contact stay sound.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "contact/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::constant;
using testing::ContactHistory;
using testing::flat_bed;
using testing::on_corners;
using testing::shaken;

constexpr ContactAccuracy bare{.longest_after_s = 0, .rest_gate = false};

double sway_speed_at(ContactHistory const& history, double time_s) {
    return std::ranges::find_if(history.instants, [&](auto const& i) { return i.time_s > time_s - 1e-9; })->sway_mps;
}

TEST(ContactGrip, SlidesWithTheKineticFriction) {
    ContactHistory history;
    auto const out = shaken(on_corners(body_a(), 0.3), constant(5, 1001), 1e-3, bare, &history);
    EXPECT_NEAR(sway_speed_at(history, 1) - sway_speed_at(history, 0.5), -1.029002500, 1e-8);
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_NEAR(out.residual_slip_m, -0.5 * (5 - 0.3 * g0), 0.01);
}

TEST(ContactGrip, HoldsBelowFriction) {
    ContactHistory history;
    auto const out = shaken(on_corners(body_a(), 0.8), constant(5, 10001), 1e-3, bare, &history);
    EXPECT_LT(std::abs(history.instants.back().sway_mps), 1e-12);
    EXPECT_LT(out.peak_slip_m, 1e-4);
}

TEST(ContactGrip, WithoutFrictionTheGroundLeavesTheBody) {
    auto const out = shaken(on_corners(body_a(), 0), constant(5, 1001), 1e-3, bare);
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_NEAR(out.end_sway_mps, -5, 1e-9);
    EXPECT_LT(out.peak_rotation_rad, 1e-12);
}

// Stiff or strongly damped grips need shorter steps than the bed does: at the bed's own step a base under ten times
// critical damping chattered, slipped the other way and never came to rest.
TEST(ContactGrip, StrongDampingAndStiffSpringsShortenTheStep) {
    auto const wave = testing::sine(6, 1.2, 4, 1, 0.01);
    struct Case {
        double ratio, damping;
    };
    for (auto const& [ratio, damping] : {Case{0.8, 10}, Case{0.8, 100}, Case{100, 0.3}}) {
        auto const block = on_corners(body_a(), 0.5, {.tangential_ratio = ratio, .tangential_damping = damping});
        auto const usual = shaken(block, wave, 0.01);
        auto const fine = shaken(block, wave, 0.01, {.step_ratio = 0.003});
        EXPECT_GT(fine.peak_slip_m, 0.01);
        EXPECT_NEAR(usual.peak_slip_m, fine.peak_slip_m, 1e-3 * fine.peak_slip_m) << ratio << " " << damping;
        EXPECT_NEAR(usual.residual_slip_m, fine.residual_slip_m, 1e-3 * fine.peak_slip_m) << ratio << " " << damping;
    }
}

// Rocking moves the middle of the base by b (1 - cos theta); until the impact the corner that it leans on stays.
TEST(ContactGrip, RockingIsNoSlip) {
    auto const body = body_a();
    auto const block = on_corners(body, firm_grip);
    for (double const side : {-1.0, 1.0}) {
        auto const out = shaken(block, constant(0, 501), 1e-3, {.longest_after_s = 0, .rest_gate = false}, nullptr,
                                leaning_start(block, side * 0.5 * body.alpha_rad()));
        EXPECT_GT(block.half_width_m * (1 - std::cos(out.peak_rotation_rad)), 0.02);
        EXPECT_LT(out.peak_slip_m, 5e-5);
        EXPECT_GT(out.peak_slip_m, 1e-6);
    }
}

TEST(ContactGrip, TenMinutesAtRestDoNotCreep) {
    for (bool const flat : {false, true}) {
        auto const block = contact_block(body_a(), flat ? flat_bed() : BasePlan{}, {}, Friction{0.4, 0.3});
        ContactHistory early;
        static_cast<void>(shaken(block, constant(0.15 * g0, 501), 1e-2, bare, &early));
        auto const late = shaken(block, constant(0.15 * g0, 60001), 1e-2, bare);
        auto const& there = early.instants.back();
        double const half = std::sin(there.rotation_rad / 2);
        double const settled = there.sway_m - block.centre_height_m * std::sin(there.rotation_rad)
                               - std::copysign(2 * block.half_width_m * half * half, there.rotation_rad);
        EXPECT_EQ(late.verdict, Verdict::at_rest);
        EXPECT_NEAR(late.residual_slip_m, settled, 1e-12);
        EXPECT_LT(std::abs(late.end_sway_mps), 1e-12);
    }
}

// Thrown up and caught again, over and over; nothing tips what falls flat.
TEST(ContactHardCases, TenTimesGravityUpAndDown) {
    auto const up = testing::sine(10 * g0, 2, 10, 2);
    std::vector<double> const calm(up.size(), 0.0);
    for (bool const flat : {false, true}) {
        auto const block = contact_block(body_a(), flat ? flat_bed() : BasePlan{}, {}, Friction{0.8, 0.8});
        auto const out = simulate_contact(block, {.horizontal_mps2 = calm, .vertical_mps2 = up, .time_step_s = 1e-3});
        EXPECT_EQ(out.failure, FailureReason::none);
        EXPECT_EQ(out.verdict, Verdict::rocked);  // every point parted from the ground
        EXPECT_LT(out.peak_rotation_rad, 1e-6);
        EXPECT_GT(out.extra.peak_contact_force_ratio, 10);
        EXPECT_GT(out.extra.peak_rise_m, 0.1);
        EXPECT_EQ(out.min_contact_force_ratio, 0);
    }
}

// Both corners at the same instant and one alone: the flat drop does not turn, the other keeps its energy's sign.
TEST(ContactHardCases, ACornerLandsExactly) {
    auto const block = on_corners(body_a(), 0.8);
    auto const flat = shaken(block, constant(0, 2001), 1e-3, bare, nullptr, ContactStart{.rise_m = 0.05});
    EXPECT_EQ(flat.peak_rotation_rad, 0);
    EXPECT_EQ(flat.trough_rad, 0);
    double const s = std::sin(0.01);
    double const c = std::cos(0.01);
    // the corner touches at depth 0 to the last bit of the start
    ContactStart const touching{
        .rise_m = block.half_width_m * s - block.centre_height_m * (1 - c) + block.settlement_m(),
        .rotation_rad = 0.01};
    auto const out = shaken(block, constant(0, 5001), 1e-3, {}, nullptr, touching);
    EXPECT_EQ(out.verdict, Verdict::rocked);
    EXPECT_LT(out.peak_rotation_rad, 0.01 + 1e-4);
    EXPECT_LT(out.peak_energy_ratio, 0.1);
}

// All but balanced on its corner at rest: nothing moves at first, yet it may not be held there.
TEST(ContactHardCases, BalanceIsNoRest) {
    auto const block = on_corners(body_a(), 0.8);
    auto const out =
        shaken(block, constant(0, 1501), 1e-2, {}, nullptr, leaning_start(block, (1 - 1e-6) * body_a().alpha_rad()));
    EXPECT_TRUE(out.verdict == Verdict::overturned || out.impacts > 0);
}

// A pad that yields keeps the crush, and bounds the force of a point.
TEST(ContactHardCases, AWeakPadIsCrushed) {
    auto const wave = testing::sine(1.3 * body_a().uplift_acceleration_mps2(), 1, 1, 2);
    auto const run = [&](std::optional<double> strength_pa) {
        return shaken(contact_block(body_a(), {}, {.strength_pa = strength_pa}, Friction{0.8, 0.8}), wave, 1e-3);
    };
    auto const elastic = run({});
    auto const strong = run(1e12);
    auto const weak = run(1e6);
    EXPECT_EQ(elastic.extra.peak_crush_m, 0);
    EXPECT_EQ(strong.peak_rotation_rad, elastic.peak_rotation_rad);
    EXPECT_EQ(strong.extra.peak_crush_m, 0);
    EXPECT_GT(weak.extra.peak_crush_m, 1e-3);
    EXPECT_LT(weak.extra.peak_crush_m, 0.1);
    // Damping stands on top of the strength, half of the base's area to a corner.
    double const strength_ratio = 1e6 * (1.36 * 1.36 / 2) / (body_a().mass_kg() * g0);
    EXPECT_LT(weak.extra.peak_contact_force_ratio, strength_ratio * (1 + normal_damping(0.25)));
    EXPECT_GT(elastic.extra.peak_contact_force_ratio, strength_ratio * (1 + normal_damping(0.25)));
}

// A block at rest that nothing shakes enough is never stepped.
TEST(ContactHardCases, RestCostsNothing) {
    auto const block = on_corners(body_a(), 0.8);
    auto const out = shaken(block, testing::sine(3.5, 1, 20, 0), 1e-3);
    EXPECT_EQ(out.verdict, Verdict::at_rest);
    EXPECT_EQ(out.steps, 0);
    EXPECT_EQ(shaken(block, {}, 1e-3).verdict, Verdict::at_rest);
    EXPECT_EQ(shaken(block, {9.0}, 1e-3).verdict, Verdict::at_rest);
}

}  // namespace
}  // namespace overturn
