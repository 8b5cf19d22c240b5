// Requirement: rocking and sliding hold at the edges: degenerate bodies, waves, steps and instants.
#include <array>
#include <limits>

#include "rocking/closed_forms.hpp"
#include "support/sliding_blocks.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::History;
using testing::near;
using testing::shaking_of;
using testing::short_wave;
using testing::simulate_slipping;
using testing::type_a;
using testing::type_a_tips;

RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};

/// Both never, or at the same time.
bool same_time(double one_s, double other_s, double within_s) {
    return std::isnan(one_s) ? std::isnan(other_s) : std::abs(one_s - other_s) <= within_s;
}

RockingOutcome release(RockingBlock const& body, double rotation_rad, RockingObserver* observer = nullptr,
                       std::size_t samples = 3000, double dt = 0.01, RockingAccuracy const& accuracy = {}) {
    std::vector<double> const calm(samples, 0.0);
    return simulate_rocking(body, shaking_of(calm, dt), accuracy, {.rotation_rad = rotation_rad}, observer);
}

/// Time and speed of every impact.
struct ImpactTimes : RockingObserver {
    void at(RockingInstant const& i) override {
        if (i.rotation_rad == 0 && i.time_s > last) {
            speeds.push_back(std::abs(i.velocity_radps));
            times.push_back(i.time_s);
            last = i.time_s;
        }
    }
    double last = 0;
    std::vector<double> speeds, times;
};

std::vector<double> resampled(std::vector<double> const& wave, int parts) {
    std::vector<double> fine;
    for (std::size_t i = 0; i + 1 < wave.size(); ++i) {
        for (int k = 0; k < parts; ++k) {
            fine.push_back(wave[i] + (wave[i + 1] - wave[i]) * k / parts);
        }
    }
    fine.push_back(wave.back());
    return fine;
}

std::vector<double> every_fifth(std::vector<double> const& wave) {
    std::vector<double> coarse;
    for (std::size_t i = 0; i < wave.size(); i += 5) {
        coarse.push_back(wave[i]);
    }
    return coarse;
}

double imbalance(EnergyBalance const& e) {
    return std::abs(e.input - e.mechanical - e.impact_loss - e.friction_work)
           / std::max({std::abs(e.input), e.impact_loss + e.friction_work, 1e-300});
}

// --- restitution -----------------------------------------------------------------------------------------------------

TEST(HardCases, TenThousandElasticImpactsKeepTheEnergy) {
    auto elastic = block;
    elastic.restitution = 1;
    ImpactTimes impacts;
    (void)release(elastic, 0.5 * block.alpha_rad, &impacts, 900000, 0.02);
    EXPECT_GT(impacts.speeds.size(), 10000U);
    double const ratio = impacts.speeds.back() / impacts.speeds.front();
    EXPECT_NEAR(ratio * ratio, 1, 1e-10);
}

TEST(HardCases, NoRestitutionEndsInTheFirstImpact) {
    auto dead = block;
    dead.restitution = 0;
    auto const out = release(dead, 0.5 * block.alpha_rad);
    EXPECT_EQ(out.verdict, Verdict::rocked);
    EXPECT_EQ(out.impacts, 1);
}

TEST(HardCases, LittleRestitutionLeavesATenthAtEveryImpact) {
    auto dull = block;
    dull.restitution = 0.1;
    ImpactTimes impacts;
    auto const out = release(dull, 0.5 * block.alpha_rad, &impacts);
    ASSERT_GE(impacts.speeds.size(), 4U);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_TRUE(near(impacts.speeds[i], 0.1 * impacts.speeds[i - 1], testing::integrated));
    }
    EXPECT_LT(out.impacts, 10);
    EXPECT_GE(out.impacts, 4);
}

// Small swings from v last 2 v/(p^2 sin alpha) each, but for phi/alpha; e times shorter each: their sum is
// 2 v/[p^2 sin(alpha) (1 - e)].
TEST(HardCases, EndlessBouncingEndsAtTheSumOfItsSeries) {
    std::vector<double> const calm(3, 0.0);
    for (double const e : {0.1, 0.5, 0.9, 0.99}) {
        for (double const v : {1e-3, 1e-4}) {
            auto body = block;
            body.restitution = e;
            History history;
            double const start = v * body.p_radps;
            auto const out = simulate_rocking(body, shaking_of(calm, 2.0), {}, {.velocity_radps = start}, &history);
            double settled = -1;
            for (auto const& i : history.instants) {
                if (settled < 0 && i.time_s > 0 && i.rotation_rad == 0 && i.velocity_radps == 0) {
                    settled = i.time_s;
                }
            }
            double const sum = 2 * start / (body.p_radps * body.p_radps * std::sin(body.alpha_rad) * (1 - e));
            EXPECT_TRUE(near(settled, sum, {20 * v * v, "the swings' own height"})) << e;
            EXPECT_LT(out.steps, 10 + std::log(1e-6) / std::log(e));
        }
    }
}

// --- thresholds ------------------------------------------------------------------------------------------------------

//
TEST(HardCases, OneUlpAroundTheThresholdsOfUpliftAndSlip) {
    RockingBlock unit{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9, .gravity_mps2 = 1};
    auto const verdict = [&](double a) {
        std::vector<double> const constant(100, a);
        return simulate_slipping(unit, shaking_of(constant, 0.01)).verdict;
    };
    for (double const sign : {1.0, -1.0}) {
        unit.friction_static = unit.friction_kinetic = 1.2;
        double const tips = std::tan(unit.alpha_rad);
        EXPECT_EQ(verdict(sign * tips), Verdict::at_rest);
        EXPECT_EQ(verdict(sign * std::nextafter(tips, 0.0)), Verdict::at_rest);
        EXPECT_EQ(verdict(sign * std::nextafter(tips, 1.0)), Verdict::rocked);
        unit.friction_static = unit.friction_kinetic = 0.2;
        EXPECT_EQ(verdict(sign * 0.2), Verdict::at_rest);
        EXPECT_EQ(verdict(sign * std::nextafter(0.2, 0.0)), Verdict::at_rest);
        EXPECT_EQ(verdict(sign * std::nextafter(0.2, 1.0)), Verdict::slid);
    }
}

//
TEST(HardCases, ThresholdTouchedAtOneSampleIsRest) {
    RockingBlock unit{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9, .gravity_mps2 = 1};
    double const tips = std::tan(unit.alpha_rad);
    std::vector<double> const peak{0, 0.5 * tips, tips, 0.5 * tips, 0, -tips, 0};
    EXPECT_EQ(simulate_rocking(unit, shaking_of(peak, 0.1)).verdict, Verdict::at_rest);
}

TEST(HardCases, ReleaseJustBelowTheCriticalAngleTakesItsTime) {
    // Linear block: back at zero after acosh(alpha / (alpha - theta)) / p. The gap holds 1e-4 of itself.
    double const theta = block.alpha_rad * (1 - 1e-12);
    ImpactTimes impacts;
    (void)release(block, theta, &impacts, 4000, 0.01, {.restoring = Restoring::linear});
    ASSERT_FALSE(impacts.times.empty());
    double const first = impacts.times[0];
    EXPECT_NEAR(first * block.p_radps, std::acosh(block.alpha_rad / (block.alpha_rad - theta)), 1e-3);
    EXPECT_EQ(release(block, theta).verdict, Verdict::rocked);
}

TEST(HardCases, ReleaseAtTheCriticalAngleBalances) {
    auto const out = release(block, block.alpha_rad);
    EXPECT_EQ(out.verdict, Verdict::rocked);
    EXPECT_EQ(out.peak_rotation_rad, block.alpha_rad);
    EXPECT_EQ(release(block, block.alpha_rad * (1 + 1e-12)).verdict, Verdict::overturned);
}

// From phi = 0 the energy p^2 (1 - cos alpha) just reaches the top.
TEST(HardCases, SeparatrixFromBothSides) {
    std::vector<double> const calm(2, 0.0);
    double const limit = block.p_radps * std::sqrt(2 * (1 - std::cos(block.alpha_rad)));
    for (double const gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
        double const slower = limit * (1 - gap);
        auto const below = simulate_rocking(block, shaking_of(calm, 0.01), {}, {.velocity_radps = slower});
        auto const above = simulate_rocking(block, shaking_of(calm, 0.01), {}, {.velocity_radps = limit * (1 + gap)});
        EXPECT_EQ(below.verdict, Verdict::rocked) << gap;
        EXPECT_EQ(above.verdict, Verdict::overturned) << gap;
        // 2 sin^2((alpha - peak)/2) = 1 - cos(alpha) - (v/p)^2/2
        double const short_of_top = (1 - std::cos(block.alpha_rad)) * gap * (2 - gap);
        double const expected = 2 * std::asin(std::sqrt(0.5 * short_of_top));
        EXPECT_NEAR(block.alpha_rad - below.peak_rotation_rad, expected, 1e-3 * expected + 1e-15 / expected) << gap;
    }
}

// --- amplitudes and bodies -------------------------------------------------------------------------------------------

TEST(HardCases, AmplitudeOfAMillionthOfAMillionthIsRest) {
    auto const wave = short_wave(1);
    auto const out = simulate_slipping(type_a(0.7), shaking_of(wave, 0.02, 1e-12));
    EXPECT_EQ(out.verdict, Verdict::at_rest);
    EXPECT_TRUE(near(out.friction_demand, 1e-12 / g0, testing::rounding));
    EXPECT_EQ(out.steps, 0);
}

// What 1e-11 of alpha per step may leave behind grows with the pull: 1e-6 of the slip at 100 g, so it is asked for
// more.
TEST(HardCases, HundredGAgreesWithFinerSteps) {
    auto const wave = short_wave(2);
    for (double const mu : {0.3, 0.64, 0.66, 0.7, 0.9, 1.3}) {
        for (double const level_g : {10.0, 100.0}) {
            auto const shaking = shaking_of(wave, 0.02, level_g * g0);
            auto const coarse = simulate_rocking(type_a(mu), shaking, {.step_tolerance = level_g > 50 ? 1e-14 : 1e-11},
                                                 {}, nullptr, Slip::simulated);
            auto const fine = simulate_rocking(type_a(mu), shaking, {.taylor_order = 12, .substeps = 64}, {}, nullptr,
                                               Slip::simulated);
            EXPECT_NE(coarse.verdict, Verdict::failed);
            EXPECT_EQ(coarse.verdict, fine.verdict) << mu;
            EXPECT_NEAR(coarse.peak_slip_m, fine.peak_slip_m, 1e-8 * fine.peak_slip_m) << mu << ' ' << level_g;
            EXPECT_NEAR(coarse.peak_rotation_rad, fine.peak_rotation_rad, 1e-8 * fine.peak_rotation_rad);
            EXPECT_TRUE(same_time(coarse.contact_lost_s, fine.contact_lost_s, 1e-8));
            EXPECT_LT(imbalance(coarse.energy), 1e-9);
        }
    }
}

// Samples of 0.05 s under 10 to 50 g: forces dip and return inside a sample. Steps of 1 ms see the same first
// dip.
TEST(HardCases, NoLossOfContactOrSlipHidesInsideAStep) {
    int lost = 0;
    int slipped = 0;
    for (int number = 0; number < 600; ++number) {
        std::vector<double> coarse(12);
        for (std::size_t i = 0; i < coarse.size(); ++i) {
            double const golden = 0.6180339887498949 * static_cast<double>((i + 1) * (i + 3 * number + 2));
            coarse[i] = 2 * (golden - std::floor(golden)) - 1;
        }
        auto const fine = resampled(coarse, 50);
        double const level = (10 + 40 * (number % 41) / 40.0) * g0;
        for (Slip const slip : {Slip::ignored, Slip::detected}) {
            auto const body = type_a(0.66 + 0.06 * (number % 11));
            auto const one = simulate_rocking(body, shaking_of(coarse, 0.05, level), {}, {}, nullptr, slip);
            auto const two = simulate_rocking(body, shaking_of(fine, 0.001, level), {}, {}, nullptr, slip);
            EXPECT_EQ(one.slip_onset, two.slip_onset) << number;
            EXPECT_EQ(one.verdict, two.verdict) << number;
            EXPECT_TRUE(same_time(one.contact_lost_s, two.contact_lost_s, 1e-7)) << number;
            lost += !std::isnan(two.contact_lost_s);
            slipped += two.slip_onset;
        }
    }
    EXPECT_GT(lost, 100);
    EXPECT_GT(slipped, 100);
}

TEST(HardCases, SlenderAndSquatBodiesStrikeWithTheirPotential) {
    for (double const alpha : {0.01, 1.4}) {
        auto body = block;
        body.alpha_rad = alpha;
        for (double const share : {1e-6, 0.5, 0.99}) {
            ImpactTimes impacts;
            (void)release(body, share * alpha, &impacts);
            double const drop = 2 * std::sin(alpha * (1 - 0.5 * share)) * std::sin(0.5 * share * alpha);
            EXPECT_TRUE(near(impacts.speeds.at(0), body.p_radps * std::sqrt(2 * drop), testing::integrated)) << share;
        }
    }
}

// --- friction --------------------------------------------------------------------------------------------------------

TEST(HardCases, SmoothGroundMovesNothingAndOverturnsNothing) {
    auto const out = simulate_slipping(type_a(0), shaking_of(short_wave(1), 0.02, 100));
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_EQ(out.peak_rotation_rad, 0);
    EXPECT_EQ(out.energy.friction_work, 0);
    EXPECT_EQ(out.friction_demand, 0);
}

//
TEST(HardCases, FrictionOfExactlyTheEdgeSlidesFlat) {
    auto const wave = short_wave(1);
    auto body = type_a(type_a_tips);
    double const tips = std::tan(body.alpha_rad);
    body.friction_static = body.friction_kinetic = tips;
    auto const at = simulate_slipping(body, shaking_of(wave, 0.02, 9));
    body.friction_static = body.friction_kinetic = std::nextafter(tips, 0.0);
    auto const below = simulate_slipping(body, shaking_of(wave, 0.02, 9));
    body.friction_static = body.friction_kinetic = std::nextafter(tips, 1.0);
    auto const above = simulate_slipping(body, shaking_of(wave, 0.02, 9));
    EXPECT_EQ(at.verdict, Verdict::slid);
    EXPECT_EQ(below.verdict, Verdict::slid);
    EXPECT_NEAR(at.peak_slip_m, below.peak_slip_m, 1e-12);
    EXPECT_NEAR(above.peak_slip_m, below.peak_slip_m, 1e-6);
    EXPECT_LT(above.peak_rotation_rad, 1e-6);
}

//
TEST(HardCases, FrictionJustBelowThePainleveBoundBehaves) {
    double const mu = painleve_bound(0.75) * (1 - 1e-12);
    int slipped = 0;
    for (int number = 0; number < 10; ++number) {
        for (double const level : {8.0, 12.0, 20.0, 80.0}) {
            auto const wave = short_wave(number);
            auto const shaking = shaking_of(wave, 0.02, level);
            auto const out = simulate_slipping(type_a(mu, 0.9 * mu), shaking);
            auto const finer = simulate_rocking(type_a(mu, 0.9 * mu), shaking, {.taylor_order = 12, .substeps = 16}, {},
                                                nullptr, Slip::simulated);
            EXPECT_NE(out.verdict, Verdict::failed);
            EXPECT_EQ(out.verdict, finer.verdict) << number << ' ' << level;
            // Close to the bound the equation of slip divides by what nearly vanishes: a digit is lost.
            EXPECT_NEAR(out.peak_slip_m, finer.peak_slip_m, 1e-7 * (1 + finer.peak_slip_m)) << number << ' ' << level;
            EXPECT_LT(imbalance(out.energy), 1e-9);
            slipped += out.peak_slip_m > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(slipped, 5) << "the bound is of bodies that slip";
}

// --- steps and instants ----------------------------------------------------------------------------------------------

TEST(HardCases, TimeStepIsNoPartOfTheMotion) {
    auto const coarse = every_fifth(short_wave(0));  // 0.1 s
    auto const fine = resampled(coarse, 100);        // 1 ms
    for (double const mu : {0.4, 0.66, 0.69, 1.2}) {
        for (double const level : {7.0, 8.0, 10.0}) {
            auto const one = simulate_slipping(type_a(mu), shaking_of(coarse, 0.1, level));
            auto const two = simulate_slipping(type_a(mu), shaking_of(fine, 0.001, level));
            EXPECT_EQ(one.verdict, two.verdict) << mu << ' ' << level;
            EXPECT_NEAR(one.peak_rotation_rad, two.peak_rotation_rad, 1e-8 * two.peak_rotation_rad);
            EXPECT_NEAR(one.peak_slip_m, two.peak_slip_m, 1e-8 * two.peak_slip_m);
            EXPECT_NEAR(one.residual_slip_m, two.residual_slip_m, 1e-8 * two.peak_slip_m);
        }
    }
}

TEST(HardCases, ManyEventsInsideOneSample) {
    // Samples of 1 s and a body of 5 cm: uplift, slip, reversals and bouncing all lie within one sample.
    std::vector<double> const coarse{0, 8, -9, 7, 0, 0};
    auto const fine = resampled(coarse, 1000);
    for (double const mu : {0.3, 0.66, 0.7, 1.0}) {
        auto body = type_a(mu, 0.95 * mu);
        body.p_radps = 12;
        auto const one = simulate_slipping(body, shaking_of(coarse, 1.0));
        auto const two = simulate_slipping(body, shaking_of(fine, 0.001));
        EXPECT_EQ(one.verdict, two.verdict) << mu;
        EXPECT_EQ(one.impacts > 5, two.impacts > 5);
        EXPECT_NEAR(one.peak_rotation_rad, two.peak_rotation_rad, 1e-8 * two.peak_rotation_rad) << mu;
        EXPECT_NEAR(one.peak_slip_m, two.peak_slip_m, 1e-8 * two.peak_slip_m) << mu;
        EXPECT_LT(imbalance(one.energy), 1e-9);
    }
}

TEST(HardCases, ImpactOnASampleCountsOnce) {
    double const quarter = std::acosh(2.0) / block.p_radps;  // release at half the critical angle, linear block
    for (int parts = 1; parts <= 64; ++parts) {
        for (double const nudge : {1 - 1e-15, 1.0, 1 + 1e-15}) {
            ImpactTimes impacts;
            auto const out = release(block, 0.5 * block.alpha_rad, &impacts, parts + 2, quarter / parts * nudge,
                                     {.restoring = Restoring::linear});
            EXPECT_LE(out.impacts, 1 + (parts == 1));
            EXPECT_GE(out.impacts, 1);
            EXPECT_NEAR(impacts.speeds.at(0), block.p_radps * block.alpha_rad * std::sqrt(0.75), 1e-11);
        }
    }
}

TEST(HardCases, StartOnTheBaseIsNoImpact) {
    std::vector<double> const calm(200, 0.0);
    for (double const v : {1e-3, 0.1, 0.3}) {
        for (double const sign : {1.0, -1.0}) {
            ImpactTimes impacts;
            auto const out = simulate_rocking(block, shaking_of(calm, 0.01), {.restoring = Restoring::linear},
                                              {.velocity_radps = sign * v}, &impacts);
            ASSERT_GT(out.impacts, 0);
            double const first = impacts.times.at(0);
            // phi = alpha - alpha cosh(pt) + (v/p) sinh(pt) = 0: tanh(pt/2) = v/(p alpha)
            double const expected = 2 * std::atanh(v / (block.p_radps * block.alpha_rad)) / block.p_radps;
            EXPECT_TRUE(near(first, expected, testing::integrated)) << v;
        }
    }
}

TEST(HardCases, MillionSamplesChangeNoBit) {
    auto const wave = short_wave(0);
    std::vector<double> late(1000000 - wave.size(), 0.0);
    late.insert(late.end(), wave.begin(), wave.end());
    auto const body = type_a(0.66, 0.62);
    auto const one = simulate_slipping(body, shaking_of(wave, 0.02, 8));
    auto const two = simulate_slipping(body, shaking_of(late, 0.02, 8));
    EXPECT_EQ(one.peak_rotation_rad, two.peak_rotation_rad);
    EXPECT_EQ(one.residual_slip_m, two.residual_slip_m);
    EXPECT_EQ(one.steps, two.steps);
    EXPECT_NEAR(two.time_of_peak_s - one.time_of_peak_s, 0.02 * (1000000.0 - 1001), 1e-9);

    std::vector<double> dense;
    while (dense.size() < 1000000) {
        dense.insert(dense.end(), wave.begin(), wave.end());
    }
    auto const out = simulate_slipping(body, shaking_of(dense, 0.02, 7));
    EXPECT_NE(out.verdict, Verdict::failed);
    EXPECT_LT(imbalance(out.energy), 1e-9);
}

// --- vertical motion -------------------------------------------------------------------------------------------------

TEST(HardCases, WeightlessGroundEndsContactWhenItIsReached) {
    std::vector<double> const calm(5, 0.0);
    auto const lost = [&](std::vector<double> const& vertical, Slip slip, double mu) {
        return simulate_rocking(type_a(mu),
                                {.horizontal_mps2 = calm, .vertical_mps2 = vertical, .time_step_s = 0.5, .scale = g0},
                                {}, {}, nullptr, slip);
    };
    for (Slip const slip : {Slip::ignored, Slip::simulated}) {
        for (double const mu : {0.3, 0.9}) {
            auto const touching = lost({0, -1, 0, 0, 0}, slip, mu);
            EXPECT_EQ(touching.verdict, Verdict::contact_lost);
            EXPECT_NEAR(touching.contact_lost_s, 0.5, 1e-14);
            auto const beyond = lost({0, -2, 0, 0, 0}, slip, mu);
            EXPECT_EQ(beyond.verdict, Verdict::contact_lost);
            EXPECT_NEAR(beyond.contact_lost_s, 0.25, 1e-14);
            auto const short_of_it = lost({0, -0.999999, 0, 0, 0}, slip, mu);
            EXPECT_EQ(short_of_it.verdict, Verdict::at_rest);
            EXPECT_NEAR(short_of_it.min_contact_force_ratio, 1e-6, 1e-12);
        }
    }
}

//
TEST(HardCases, SlidingBaseLosesContactWithItsEnergyInOrder) {
    // 0.5 g throughout, gv from 1 to -1 in 1 s, mu = 0.3: v/g = -0.5 t + 0.3 (t - t^2), contact ends at 0.5 s.
    std::vector<double> const push(3, 0.5 * g0);
    std::vector<double> const vertical{0, -2 * g0, -2 * g0};
    auto body = type_a(0.3);
    auto const out = simulate_slipping(body, {.horizontal_mps2 = push, .vertical_mps2 = vertical, .time_step_s = 1.0});
    EXPECT_EQ(out.verdict, Verdict::contact_lost);
    EXPECT_NEAR(out.contact_lost_s, 0.5, 1e-14);
    double const slip = g0 * (-0.25 * 0.25 + 0.3 * (0.125 - 0.125 / 3));
    EXPECT_NEAR(out.residual_slip_m, slip, 1e-13);
    EXPECT_LT(imbalance(out.energy), 1e-12);
}

// --- waves -----------------------------------------------------------------------------------------------------------

// A pulse that is as high at its first and last sample as between them, against Housner's limit of its length.
TEST(HardCases, WaveThatStartsAndEndsAtItsPeak) {
    for (double const ratio : {1.001, 1.5, 4.0, 40.0}) {
        double const limit = rectangular_pulse_limit(ratio) / block.p_radps;
        std::vector<double> const pulse(11, ratio * g0 * block.alpha_rad);
        auto const verdict = [&](double length) {
            return simulate_rocking(block, shaking_of(pulse, length / 10), {.restoring = Restoring::linear}).verdict;
        };
        EXPECT_EQ(verdict(limit * (1 - 1e-9)), Verdict::rocked) << ratio;
        EXPECT_EQ(verdict(limit * (1 + 1e-9)), Verdict::overturned) << ratio;
    }
}

TEST(HardCases, ConstantZeroOneAndTwoSamples) {
    for (std::size_t const samples : {0U, 1U, 2U, 5000U}) {
        std::vector<double> const zero(samples, 0.0);
        EXPECT_EQ(simulate_slipping(type_a(0.5), shaking_of(zero, 0.01)).verdict, Verdict::at_rest);
        std::vector<double> const constant(samples, 4.0);  // 0.41 g: holds at 0.5, slides at 0.3
        EXPECT_EQ(simulate_slipping(type_a(0.5), shaking_of(constant, 0.01)).verdict, Verdict::at_rest);
        auto const slides = simulate_slipping(type_a(0.3), shaking_of(constant, 0.01));
        EXPECT_EQ(slides.verdict, samples < 2 ? Verdict::at_rest : Verdict::slid);
        if (samples >= 2) {
            double const length = 0.01 * static_cast<double>(samples - 1);
            double const v = (4.0 - 0.3 * g0) * length;
            EXPECT_TRUE(near(slides.peak_slip_m, 0.5 * v * length + v * v / (0.6 * g0), testing::integrated));
        }
    }
}

TEST(HardCases, LengthTimeAndGravityScaleWithoutABit) {
    auto const wave = short_wave(0);
    auto const body = type_a(1.05 * type_a_tips, 0.95 * 1.05 * type_a_tips);
    auto const one = simulate_slipping(body, shaking_of(wave, 0.02, 9));
    ASSERT_GT(one.peak_slip_m, 0);
    ASSERT_GT(one.impacts, 0);

    auto smaller = body;  // a quarter of the length in half the time
    smaller.p_radps *= 2;
    auto const two = simulate_slipping(smaller, shaking_of(wave, 0.01, 9));
    EXPECT_EQ(one.peak_rotation_rad, two.peak_rotation_rad);
    EXPECT_EQ(one.peak_slip_m, 4 * two.peak_slip_m);
    EXPECT_EQ(one.energy.friction_work, 4 * two.energy.friction_work);

    auto heavier = body;  // the same length in half the time under four times the gravity
    heavier.p_radps *= 2;
    heavier.gravity_mps2 *= 4;
    auto const three = simulate_slipping(heavier, shaking_of(wave, 0.01, 36));
    EXPECT_EQ(one.peak_rotation_rad, three.peak_rotation_rad);
    EXPECT_EQ(one.peak_slip_m, three.peak_slip_m);
    EXPECT_EQ(4 * one.energy.friction_work, three.energy.friction_work);
}

}  // namespace
}  // namespace overturn
