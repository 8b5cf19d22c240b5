// Requirement: uplift, impact and rest are decided exactly: thresholds, symmetry, no event missed or found
// twice.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/detail/impact_law.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/long_period_wave.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};

Excitation shaking(std::vector<double> const& a, double dt, double scale = 1) {
    return {.horizontal_mps2 = a, .vertical_mps2 = {}, .time_step_s = dt, .scale = scale};
}

TEST(Uplift, ExactlyTheThresholdIsRest) {
    double const threshold = std::tan(block.alpha_rad);
    RockingBlock unit = block;
    unit.gravity_mps2 = 1;  // so that the threshold itself is a double
    std::vector<double> const at(100, threshold);
    std::vector<double> const above(100, std::nextafter(threshold, 1.0));
    std::vector<double> const below(100, std::nextafter(threshold, 0.0));

    EXPECT_EQ(simulate_rocking(unit, shaking(at, 0.01)).verdict, Verdict::at_rest);
    EXPECT_EQ(simulate_rocking(unit, shaking(below, 0.01)).verdict, Verdict::at_rest);
    EXPECT_EQ(simulate_rocking(unit, shaking(above, 0.01)).verdict, Verdict::rocked);
}

TEST(Uplift, IsAwayFromTheAcceleration) {
    struct Last : RockingObserver {
        void at(RockingInstant const& i) override { rotation = i.rotation_rad != 0 ? i.rotation_rad : rotation; }
        double rotation = 0;
    };
    for (double const sign : {1.0, -1.0}) {
        std::vector<double> const a(20, sign * 4.0);
        Last last;
        (void)simulate_rocking(block, shaking(a, 0.01), {}, {}, &last);
        EXPECT_LT(sign * last.rotation, 0);
    }
}

TEST(Uplift, InstantIsExactOnARamp) {
    std::vector<double> a(101);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = 0.05 * static_cast<double>(i);  // 5 m/s3
    }
    auto const out = simulate_rocking(block, shaking(a, 0.01));
    EXPECT_NEAR(out.first_uplift_s, std::tan(0.25) * g0 / 5, 1e-15);
}

TEST(Mirror, MirroredWaveGivesTheBitEqualTrial) {
    auto const wave = testing::filtered_wave(testing::set_b);
    auto mirrored = wave;
    for (double& a : mirrored) {
        a = -a;
    }
    for (double const level : {3.2, 3.9, 4.8}) {
        auto const one = simulate_rocking(block, shaking(wave, 0.01, level));
        auto const two = simulate_rocking(block, shaking(mirrored, 0.01, level));
        EXPECT_EQ(one.verdict, two.verdict);
        EXPECT_EQ(one.peak_rotation_rad, two.peak_rotation_rad);
        EXPECT_EQ(one.time_of_peak_s, two.time_of_peak_s);
        EXPECT_EQ(one.impacts, two.impacts);
        EXPECT_EQ(one.impact_spin_radps, two.impact_spin_radps);
        EXPECT_EQ(one.friction_demand, two.friction_demand);
        EXPECT_EQ(one.peak_energy_ratio, two.peak_energy_ratio);
    }
}

//
TEST(Vertical, ZeroVerticalMotionChangesNoBit) {
    auto const wave = testing::filtered_wave(testing::set_a);
    std::vector<double> const calm(wave.size(), 0.0);
    for (double const level : {2.6, 3.2, 3.6}) {
        auto const without = simulate_rocking(block, shaking(wave, 0.01, level));
        auto const with = simulate_rocking(
            block, {.horizontal_mps2 = wave, .vertical_mps2 = calm, .time_step_s = 0.01, .scale = level});
        EXPECT_EQ(without.peak_rotation_rad, with.peak_rotation_rad);
        EXPECT_EQ(without.impacts, with.impacts);
    }
}

TEST(Vertical, ConstantVerticalMotionIsAnotherGravity) {
    auto const wave = testing::filtered_wave(testing::set_a);
    double const level = 3.2;
    double const up = 1.5;
    std::vector<double> const lift(wave.size(), up / level);
    auto heavier = block;
    heavier.gravity_mps2 = g0 + up;
    heavier.p_radps *= std::sqrt((g0 + up) / g0);

    auto const with =
        simulate_rocking(block, {.horizontal_mps2 = wave, .vertical_mps2 = lift, .time_step_s = 0.01, .scale = level});
    auto const reference = simulate_rocking(heavier, shaking(wave, 0.01, level));

    EXPECT_EQ(with.verdict, reference.verdict);
    EXPECT_NEAR(with.peak_rotation_rad, reference.peak_rotation_rad, 1e-9 * reference.peak_rotation_rad);
}

//
TEST(Scaling, LengthTimeAndGravityScaleTogether) {
    auto const wave = testing::filtered_wave(testing::set_a);
    auto small = block;
    small.p_radps *= 2;  // a quarter of the size
    for (double const level : {2.6, 3.0, 3.5}) {
        auto const one = simulate_rocking(block, shaking(wave, 0.01, level));
        auto const two = simulate_rocking(small, shaking(wave, 0.005, level));
        EXPECT_EQ(one.impacts, two.impacts);
        EXPECT_EQ(one.peak_rotation_rad, two.peak_rotation_rad);  // powers of two scale without rounding
        EXPECT_EQ(one.time_of_peak_s, 2 * two.time_of_peak_s);
    }
}

TEST(Wave, NoOneAndTwoSamplesAreTaken) {
    std::vector<double> const none;
    std::vector<double> const one{50.0};
    std::vector<double> const two{0.0, 50.0};
    EXPECT_EQ(simulate_rocking(block, shaking(none, 0.01)).verdict, Verdict::at_rest);
    EXPECT_EQ(simulate_rocking(block, shaking(one, 0.01)).verdict, Verdict::at_rest);
    EXPECT_EQ(simulate_rocking(block, shaking(two, 0.01)).verdict, Verdict::rocked);
}

//
TEST(EnergyVerdict, PeakAfterTheWaveIsStillFound) {
    // A short push: the rotation grows long after the wave has ended, up to the height its energy allows.
    std::vector<double> const push{6.0, 6.0};
    auto const out = simulate_rocking(block, shaking(push, 0.15));
    double const top = 1 - std::cos(block.alpha_rad);
    double const expected = block.alpha_rad - std::acos(std::cos(block.alpha_rad) + out.peak_energy_ratio * top);

    EXPECT_EQ(out.verdict, Verdict::rocked);
    EXPECT_GT(out.time_of_peak_s, 0.3);
    EXPECT_NEAR(out.peak_rotation_rad, expected, 1e-12);
}

//
TEST(EnergyVerdict, SlowOverturningAfterTheWaveIsFollowedToItsEnd) {
    std::vector<double> const calm{0.0, 0.0};
    auto const out = simulate_rocking(block, shaking(calm, 0.01), {}, {.rotation_rad = block.alpha_rad * (1 + 1e-9)});
    EXPECT_EQ(out.verdict, Verdict::overturned);
    EXPECT_GT(out.overturn_time_s, 10);
}

//
TEST(EnergyVerdict, ExactBalanceIsNotOverturning) {
    std::vector<double> const calm{0.0, 0.0};
    auto const out = simulate_rocking(block, shaking(calm, 0.01), {}, {.rotation_rad = block.alpha_rad});
    EXPECT_EQ(out.verdict, Verdict::rocked);
}

// whatever restitution is stated, no impact of a body that slips adds energy; where the stated one would, the
// body rebounds with what conserves it.
TEST(Impact, NeverAddsEnergy) {
    int lowered = 0;
    int kept = 0;
    for (double const alpha : {0.1, 0.25, 0.5, 0.8}) {
        for (double const restitution : {0.3, 0.7, 0.95, 1.0}) {
            for (double const friction : {0.05, 0.3, 0.9}) {
                rocking::ImpactLaw const law{.sine_alpha = std::sin(alpha),
                                             .cosine_alpha = std::cos(alpha),
                                             .kappa = 1.0 / 3,
                                             .restitution = restitution,
                                             .friction_static = 1.2 * friction,
                                             .friction_kinetic = friction,
                                             .sine_next = std::sin(alpha)};
                for (double const slip : {-2.0, -0.5, -0.1, 0.1, 0.5, 2.0}) {
                    auto const after = rocking::after_impact(law, 1.0, slip);
                    double const before = law.energy(1.0, slip);
                    double const left = law.energy_after(after.rotation_rate, after.slip_rate);
                    EXPECT_LE(left, before) << alpha << ' ' << restitution << ' ' << friction << ' ' << slip;
                    if (after.rotation_rate == restitution) {
                        ++kept;
                    } else {
                        EXPECT_NEAR(left, before, 1e-12) << alpha << ' ' << restitution << ' ' << friction;
                        ++lowered;
                    }
                }
            }
        }
    }
    EXPECT_GT(lowered, 10);
    EXPECT_GT(kept, 10);
}

// the ground's vertical impulse is the centre's momentum after an impact, which rises about the corner landed
// on, less that before it, which fell about the corner left.
TEST(Impact, ItsImpulseIsTheCentresChangeOfMomentum) {
    double const from = 0.5;
    double const onto = 0.3;
    rocking::ImpactLaw const law{.sine_alpha = from,
                                 .cosine_alpha = 0.8,
                                 .kappa = 0.3,
                                 .restitution = 0.6,
                                 .friction_static = 0.5,
                                 .friction_kinetic = 0.4,
                                 .sine_next = onto};
    double const w = 1.7;
    double const falls = -from * w;
    double const rises = onto * law.restitution * w;
    EXPECT_TRUE(testing::near(law.impulse(law.restitution) * w, rises - falls, testing::exact_formula));
    double const sideways = law.cosine_alpha * w - law.cosine_alpha * law.restitution * w;
    EXPECT_TRUE(testing::near(law.friction_demand(), sideways / (rises - falls), testing::exact_formula));
}

// beyond alpha and on its way out a block that the ground has left falls free of torque, at the rate it had.
TEST(ContactLoss, BeyondAlphaTheFallKeepsItsRate) {
    struct Last : RockingObserver {
        void at(RockingInstant const& i) override { last = i; }
        RockingInstant last{};
    };
    double const dt = 1e-3;
    std::vector<double> const calm(40, 0.0);
    std::vector<double> drop(40, 0.0);
    std::fill(drop.begin() + 20, drop.end(), -50.0 * g0);
    for (double const sign : {1.0, -1.0}) {
        Last seen;
        auto const out =
            simulate_rocking(block, {.horizontal_mps2 = calm, .vertical_mps2 = drop, .time_step_s = dt}, {},
                             {.rotation_rad = sign * 1.3 * block.alpha_rad, .velocity_radps = sign * 0.8}, &seen);
        ASSERT_EQ(out.verdict, Verdict::overturned);
        EXPECT_NEAR(out.contact_lost_s, 19 * dt, dt);
        double const spin = std::abs(seen.last.velocity_radps);
        double const rotation = std::abs(seen.last.rotation_rad) + spin * (out.contact_lost_s - seen.last.time_s);
        EXPECT_NEAR(out.overturn_time_s, out.contact_lost_s + (pi / 2 - rotation) / spin, 2e-3);
        EXPECT_GT(out.overturn_time_s, 1.0);
        EXPECT_EQ(out.landing_spin_radps, std::abs(seen.last.velocity_radps));
        EXPECT_NEAR(seen.last.rotation_rad, sign * pi / 2, 1e-12);  // histories end where it lies
        EXPECT_NEAR(seen.last.time_s, out.overturn_time_s, 1e-12);
    }
}

// Sums in fine steps the fall of a centre of gravity from the instant at which the block left the ground, to where it
// lies: at 90 degrees or below, but no lower than half its width.
struct Fall {
    double along_mps, down_mps;
    bool ends_above = false;

    Fall(RockingOutcome const& out, double sign, std::vector<double> const& horizontal,
         std::vector<double> const& vertical, double dt) {
        double const spin = out.landing_spin_radps;
        double const flight_s = out.overturn_time_s - out.contact_lost_s;
        double const radius_m = 0.75 * g0 / (block.p_radps * block.p_radps);
        double const lies_at_m = radius_m * std::sin(block.alpha_rad);
        double const angle = block.alpha_rad - (pi / 2 - spin * flight_s);
        along_mps = radius_m * std::cos(angle) * spin;
        double up_mps = radius_m * std::sin(angle) * spin;
        double height_m = radius_m * std::cos(angle);
        auto const at = [&](std::vector<double> const& wave, double time_s) {
            auto const i = static_cast<std::size_t>(time_s / dt);
            return i + 1 < wave.size() ? std::lerp(wave[i], wave[i + 1], time_s / dt - static_cast<double>(i)) : 0.0;
        };
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
            double const time_s = out.contact_lost_s + (i + 0.5) * flight_s / steps;
            along_mps -= sign * at(horizontal, time_s) * flight_s / steps;
            if (height_m > lies_at_m) {
                up_mps -= (g0 + at(vertical, time_s)) * flight_s / steps;
                height_m += up_mps * flight_s / steps;
            }
        }
        ends_above = height_m > lies_at_m;
        down_mps = std::sqrt(up_mps * up_mps + 2 * g0 * std::max(0.0, height_m - lies_at_m));
    }
};

// in flight the centre of gravity falls under gravity and the shaking of the ground, here pulled aside, and away
// after 20 samples, gently or hard. What slips before takes its slip along.
TEST(Landing, AfterAFlight) {
    double const dt = 1e-3;
    std::vector<double> drop(61, 0.0);
    std::vector<double> aside(61, 0.0);
    for (double const pull : {1.6, 20.0}) {
        std::fill(drop.begin() + 20, drop.begin() + 40, -pull * g0);
        for (double const sign : {1.0, -1.0}) {
            std::fill(aside.begin(), aside.begin() + 40, sign * 3.0);
            for (double const friction : {0.0, 0.02}) {
                auto slips = block;
                slips.friction_static = slips.friction_kinetic = friction;
                auto const out =
                    simulate_rocking(slips, {.horizontal_mps2 = aside, .vertical_mps2 = drop, .time_step_s = dt}, {},
                                     {.rotation_rad = sign * 1.3 * block.alpha_rad, .velocity_radps = sign * 1.6},
                                     nullptr, friction == 0 ? Slip::ignored : Slip::simulated);
                ASSERT_EQ(out.verdict, Verdict::overturned);
                ASSERT_NEAR(out.contact_lost_s, 19.5 * dt, dt);
                Fall const fall(out, sign, aside, drop, dt);
                EXPECT_EQ(fall.ends_above, pull > 2);
                EXPECT_NEAR(out.flight_down_mps, fall.down_mps, 1e-3);
                EXPECT_NEAR(out.flight_along_mps, fall.along_mps + out.landing_slip_mps, 1e-3);
                EXPECT_EQ(std::abs(out.landing_slip_mps) > 1e-3, friction > 0);
            }
        }
    }
    std::vector<double> const calm(61, 0.0);
    auto const stays = simulate_rocking(block, shaking(calm, dt), {}, {.rotation_rad = 1.3 * block.alpha_rad});
    EXPECT_TRUE(std::isnan(stays.flight_along_mps)) << "it fell about its corner";
}

// A history ends where the body lies, stuck or slipping, and with the velocity that it lands with.
TEST(Landing, HistoriesEndWhereTheBodyLies) {
    struct Last : RockingObserver {
        void at(RockingInstant const& i) override { last = i; }
        RockingInstant last{};
    };
    std::vector<double> push(400, 0.0);
    for (std::size_t i = 0; i < 200; ++i) {
        push[i] = 9 * std::sin(pi * 0.01 * static_cast<double>(i));
    }
    for (double const sign : {1.0, -1.0}) {
        for (auto& a : push) {
            a *= sign;
        }
        for (double const friction : {0.0, 0.3}) {
            auto grips = block;
            grips.friction_static = grips.friction_kinetic = friction;
            Last seen;
            auto const out = simulate_rocking(grips, shaking(push, 0.01), {}, {}, &seen,
                                              friction == 0 ? Slip::ignored : Slip::simulated);
            ASSERT_EQ(out.verdict, Verdict::overturned);
            EXPECT_EQ(std::abs(seen.last.rotation_rad), pi / 2);
            EXPECT_EQ(seen.last.time_s, out.overturn_time_s);
            EXPECT_EQ(std::abs(seen.last.velocity_radps), out.landing_spin_radps);
            EXPECT_EQ(std::signbit(seen.last.rotation_rad), std::signbit(seen.last.velocity_radps));
        }
    }
}

// I_O w^2 / 2 = m g R (1 - sin(alpha)), from balance; and under a constant push from rest, whose work comes on
// top.
TEST(Landing, OfARigidBlockFromBalance) {
    std::vector<double> const calm{0.0, 0.0};
    for (double const sign : {1.0, -1.0}) {
        auto const out =
            simulate_rocking(block, shaking(calm, 0.01), {}, {.rotation_rad = sign * block.alpha_rad * (1 + 1e-9)});
        ASSERT_EQ(out.verdict, Verdict::overturned);
        EXPECT_NEAR(out.landing_spin_radps, block.p_radps * std::sqrt(2 * (1 - std::sin(block.alpha_rad))), 1e-8);
    }
    EXPECT_EQ(
        simulate_rocking(block, shaking(calm, 0.01), {}, {.rotation_rad = 0.5 * block.alpha_rad}).landing_spin_radps,
        0);
}

}  // namespace
}  // namespace overturn
