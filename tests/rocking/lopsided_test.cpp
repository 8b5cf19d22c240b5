// Requirement R-407: a centre of gravity off the base's middle, inclined ground and an initial tilt: thresholds, free
// fall and single swings follow closed forms, both corners do what symmetric blocks of theirs do, energy balances.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gsl/gsl_sf_ellint.h>
#include <gtest/gtest.h>

#include "rocking/detail/checkpoint.hpp"
#include "support/bit_equal.hpp"
#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::lopsided_a;
using testing::near;

constexpr double ample = 1.2;  // friction that hardly ever gives out, below what may jam

struct Lean {
    double offset_m, slope_rad;
};
constexpr std::array<Lean, 5> leans{{{0.1, 0}, {-0.1, 0}, {0, 0.02}, {0, -0.02}, {0.06, -0.03}}};

RockingCorner const& corner(RockingBlock const& block, double side) {
    return block.lopsided->corners[side < 0 ? 1 : 0];
}

// A corner as a block of its own.
RockingBlock alone(RockingBlock const& block, double side) {
    auto const& c = corner(block, side);
    return {
        .alpha_rad = c.alpha_rad, .p_radps = c.p_radps, .restitution = c.restitution, .inertia_ratio = c.inertia_ratio};
}

// Uplift begins at g tan(alpha -/+ slope): under a ramp the instant shows the threshold.
TEST(Lopsided, UpliftsAtTheTangentOfItsOwnAngle) {
    for (auto const& [offset, slope] : leans) {
        auto const block = lopsided_a(offset, slope, ample);
        for (double const side : {1.0, -1.0}) {
            std::vector<double> ramp;
            for (int i = 0; i <= 1000; ++i) {
                ramp.push_back(-side * 0.01 * i);
            }
            double const angle = std::atan((0.68 - side * offset) / 1.045) - side * slope;

            auto const out = simulate_rocking(block, testing::shaking_of(ramp, 0.01));

            EXPECT_TRUE(near(out.first_uplift_s, g0 * std::tan(angle), testing::exact_formula));
            EXPECT_EQ(out.peak_side, side);
        }
    }
}

// Below both thresholds it rests, and what friction must hold is the tangent of the angle between gravity with the
// shaking and the ground's normal.
TEST(Lopsided, AtRestOnASlopeFrictionHoldsItsWeightToo) {
    double const slope = 0.02;
    std::vector<double> const wave{0, 0.5, -2, 1.9, 0};

    auto const out = simulate_rocking(lopsided_a(0, slope, ample), testing::shaking_of(wave, 0.01));

    EXPECT_EQ(out.verdict, Verdict::at_rest);
    EXPECT_TRUE(near(out.friction_demand, std::tan(std::atan(2 / g0) + slope), testing::exact_formula));
}

// Sliding begins at g tan(friction angle -/+ slope).
TEST(Lopsided, SlidesAtTheTangentOfTheFrictionAngle) {
    double const mu = 0.4;
    double const slope = 0.03;
    auto const block = lopsided_a(0.05, slope, mu);
    for (double const side : {1.0, -1.0}) {
        double const limit = g0 * std::tan(std::atan(mu) - side * slope);
        for (double const share : {1 - 1e-12, 1 + 1e-9}) {
            std::vector<double> const wave(200, -side * share * limit);

            auto const out = testing::simulate_slipping(block, testing::shaking_of(wave, 0.01));

            EXPECT_EQ(out.verdict, share > 1 ? Verdict::slid : Verdict::at_rest) << side;
        }
    }
}

// From a tilt it falls back as a pendulum through the upper half of its circle:
// p t = K(k) - F(xi, k), k = cos(psi0 / 2), sin xi = cos(alpha / 2) / k.
TEST(Lopsided, FallsBackFromATiltInTheTimeOfTheEllipticIntegral) {
    std::vector<double> const calm(400, 0.0);
    for (auto const& [offset, slope] : leans) {
        auto const block = lopsided_a(offset, slope, ample);
        for (double const side : {1.0, -1.0}) {
            for (double const share : {0.1, 0.5, 0.9}) {
                auto const& c = corner(block, side);
                double const psi0 = (1 - share) * c.alpha_rad;
                double const k = std::cos(0.5 * psi0);
                double const xi = std::asin(std::cos(0.5 * c.alpha_rad) / k);
                double const quarter =
                    (gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) - gsl_sf_ellint_F(xi, k, GSL_PREC_DOUBLE)) / c.p_radps;
                testing::History history;

                auto const out = simulate_rocking(block, testing::shaking_of(calm, 0.02), {},
                                                  {.rotation_rad = side * share * c.alpha_rad}, &history);

                auto const landed = std::ranges::find(history.instants, 0.0, &RockingInstant::rotation_rad);
                ASSERT_NE(landed, history.instants.end());
                EXPECT_TRUE(near(landed->time_s, quarter, testing::integrated)) << share;
                EXPECT_EQ(out.verdict, Verdict::rocked);
                EXPECT_EQ(out.first_uplift_s, 0);
                EXPECT_EQ(out.peak_rotation_rad, share * c.alpha_rad);
            }
        }
    }
}

// Until the first impact a corner knows nothing of the other one.
TEST(Lopsided, SwingsAsTheSymmetricBlockOfThatCornerUntilTheFirstImpact) {
    for (auto const& [offset, slope] : leans) {
        auto const block = lopsided_a(offset, slope, ample);
        for (double const side : {1.0, -1.0}) {
            std::vector<double> pulse(600, 0.0);
            for (std::size_t i = 0; i < 60; ++i) {
                pulse[i] = -side * 8 * std::sin(std::numbers::pi * static_cast<double>(i) / 60);
            }
            auto const shaking = testing::shaking_of(pulse, 0.01);
            testing::History both;
            testing::History one;

            (void)simulate_rocking(block, shaking, {}, {}, &both);
            (void)simulate_rocking(alone(block, side), shaking, {}, {}, &one);

            std::size_t swings = 0;
            for (std::size_t i = 0; i < both.instants.size() && i < one.instants.size(); ++i) {
                if (both.instants[i].velocity_radps * side < 0 && both.instants[i].rotation_rad == 0) {
                    break;
                }
                EXPECT_EQ(both.instants[i].time_s, one.instants[i].time_s);
                EXPECT_EQ(both.instants[i].rotation_rad, one.instants[i].rotation_rad);
                EXPECT_EQ(both.instants[i].velocity_radps, one.instants[i].velocity_radps);
                swings += both.instants[i].rotation_rad * side > 0 ? 1 : 0;
            }
            EXPECT_GT(swings, 25U);
        }
    }
}

// Mirrored body under a mirrored motion: the mirrored trial, bit for bit, in every slip mode.
TEST(Lopsided, MirrorsBitForBit) {
    auto const wave = testing::short_wave(1);
    auto const other_way = testing::mirrored(wave);
    auto const vertical = testing::short_wave(7);
    int moved = 0;
    for (auto const& [offset, slope] : leans) {
        for (double const friction : {0.4, 0.67, ample}) {
            auto const block = lopsided_a(offset, slope, friction);
            auto const mirrored = lopsided_a(-offset, -slope, friction);
            for (double const level : {4.0, 7.0, 9.0, 13.0}) {
                auto here = testing::shaking_of(wave, 0.02, level);
                auto there = testing::shaking_of(other_way, 0.02, level);
                here.vertical_mps2 = there.vertical_mps2 = vertical;
                for (Slip const slip : {Slip::ignored, Slip::simulated}) {
                    auto const one = simulate_rocking(block, here, {}, {.rotation_rad = 0.05}, nullptr, slip);
                    auto two = simulate_rocking(mirrored, there, {}, {.rotation_rad = -0.05}, nullptr, slip);
                    EXPECT_EQ(one.peak_side, -two.peak_side);
                    EXPECT_EQ(one.residual_slip_m, -two.residual_slip_m);
                    two.residual_slip_m = one.residual_slip_m;
                    EXPECT_TRUE(testing::bit_equal<Outcome>(one, two));
                    moved += one.impacts > 3 ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(moved, 60);
}

// What nothing leans on is the symmetric block to rounding: a slope or an offset of nothing in particular.
TEST(Lopsided, TendsToTheSymmetricBlock) {
    auto const wave = testing::short_wave(2);
    auto const shaking = testing::shaking_of(wave, 0.02, 7.5);
    auto leaning = lopsided_a(0, 1e-12, 0.66, 0.6);
    auto level = leaning;
    level.lopsided.reset();

    auto const one = testing::simulate_slipping(leaning, shaking);
    auto const two = testing::simulate_slipping(level, shaking);

    EXPECT_EQ(one.impacts, two.impacts);
    EXPECT_GT(two.peak_slip_m, 1e-4);
    EXPECT_NEAR(one.peak_rotation_rad, two.peak_rotation_rad, 1e-7 * two.peak_rotation_rad);
    EXPECT_NEAR(one.peak_energy_ratio, two.peak_energy_ratio, 1e-7 * two.peak_energy_ratio);
    EXPECT_NEAR(one.peak_slip_m, two.peak_slip_m, 1e-7 * two.peak_slip_m);
}

// input = mechanical + impact loss + friction work, with gravity's work along the ground in the mechanical part.
TEST(Lopsided, EnergyBalancesWithEachKey) {
    auto const wave = testing::filtered_wave(testing::set_a);
    auto vertical = testing::filtered_wave(testing::set_b);
    std::ranges::transform(vertical, vertical.begin(), [](double a) { return 0.4 * a; });
    int slipped = 0;
    int fell = 0;
    for (auto const& [offset, slope] : leans) {
        for (double const friction : {0.3, 0.66, 0.7, ample}) {
            for (double const level : {4.0, 7.0, 9.0, 14.0}) {
                for (double const tilt : {0.0, 0.2}) {
                    auto shaking = testing::shaking_of(wave, 0.01, level);
                    shaking.vertical_mps2 = tilt > 0 ? std::span<double const>(vertical) : std::span<double const>();

                    auto const out = testing::simulate_slipping(lopsided_a(offset, slope, friction, 0.9 * friction),
                                                                shaking, nullptr, {.rotation_rad = tilt});

                    auto const& e = out.energy;
                    double const turned_over =
                        std::max({std::abs(e.input), e.impact_loss + std::abs(e.friction_work), 1e-12});
                    EXPECT_NE(out.verdict, Verdict::failed);
                    EXPECT_GE(e.impact_loss, 0);
                    EXPECT_NEAR(e.input, e.mechanical + e.impact_loss + e.friction_work, 1e-9 * turned_over)
                        << offset << ' ' << slope << ' ' << friction << ' ' << level << ' ' << tilt;
                    slipped += out.peak_slip_m > 1e-6 ? 1 : 0;
                    fell += out.verdict == Verdict::overturned ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(slipped, 50);
    EXPECT_GT(fell, 20);
}

// Ended by friction and gone on with slip: bit-equal to slip from the start, a tilt included.
TEST(Lopsided, GoesOnWithSlipWhereFrictionGaveOut) {
    auto const wave = testing::short_wave(1);
    std::vector<RockingTrial> trials;
    for (auto const& [offset, slope] : leans) {
        for (double const level : {6.0, 8.0, -10.0}) {
            trials.push_back({lopsided_a(offset, slope, 0.68, 0.6),
                              testing::shaking_of(wave, 0.02, level),
                              {.rotation_rad = 0.04 * level}});
        }
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    std::vector<rocking::Checkpoint> checkpoints(trials.size());

    simulate_until_slip(trials, {}, outcomes, checkpoints);

    int gone_on = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!checkpoints[i].reached) {
            continue;
        }
        ++gone_on;
        EXPECT_TRUE(testing::bit_equal<Outcome>(
            resume_sliding(trials[i], {}, checkpoints[i]),
            simulate_rocking(trials[i].block, trials[i].shaking, {}, trials[i].start, nullptr, Slip::simulated)));
    }
    EXPECT_GT(gone_on, 6);
}

// After the wave energy decides: following the body through a minute of quiet gives the same.
TEST(Lopsided, TheVerdictNeedsNoQuietAfterTheWave) {
    auto wave = testing::short_wave(3);
    int rocked = 0;
    for (auto const& [offset, slope] : leans) {
        for (double const level : {5.0, 6.0, 7.0, 8.0, 10.0}) {
            for (std::size_t const cut : {400U, 500U, 600U}) {
                std::vector<double> shaken(wave.begin(), wave.begin() + static_cast<std::ptrdiff_t>(cut));
                shaken.back() = 0;
                auto const block = lopsided_a(offset, slope, ample);
                auto const soon = simulate_rocking(block, testing::shaking_of(shaken, 0.02, level));
                shaken.resize(cut + 3000, 0.0);
                auto const late = simulate_rocking(block, testing::shaking_of(shaken, 0.02, level));
                EXPECT_EQ(soon.verdict, late.verdict);
                EXPECT_NEAR(soon.peak_rotation_rad, late.peak_rotation_rad, 1e-9);
                EXPECT_NEAR(soon.peak_energy_ratio, late.peak_energy_ratio, 1e-9 * late.peak_energy_ratio);
                rocked += soon.verdict == Verdict::rocked ? 1 : 0;
            }
        }
    }
    EXPECT_GT(rocked, 20);
}

}  // namespace
}  // namespace overturn
