// Requirement R-504: sliding changes nothing where nothing slips: detected, simulated and ignored slip agree bit for
// bit there.
#include <gtest/gtest.h>

#include "rocking/detail/checkpoint.hpp"
#include "support/bit_equal.hpp"
#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

using testing::shaking_of;
using testing::type_a;
using testing::type_a_tips;

RockingOutcome simulate(RockingBlock const& block, Excitation const& shaking, Slip slip) {
    return simulate_rocking(block, shaking, {}, {}, nullptr, slip);
}

void expect_same_motion(RockingOutcome const& one, RockingOutcome const& other) {
    EXPECT_TRUE(testing::bit_equal<Outcome>(one, other));
}

//
TEST(SlipModes, AgreeBitForBitUnlessSomethingSlips) {
    int still = 0;
    int slipping = 0;
    int at_impacts = 0;
    for (int number = 0; number < 12; ++number) {
        auto const horizontal = testing::short_wave(number);
        auto vertical = testing::short_wave(number + 40);
        for (double& a : vertical) {
            a *= 0.3;
        }
        for (double const level : {4.0, 6.0, 6.6, 7.0, 8.0, 10.0, 14.0}) {
            for (double const mu : {0.3, 0.5, 0.655, 0.68, 0.72, 0.8, 1.0, 1.2}) {
                for (bool const lifted : {false, true}) {
                    auto shaking = shaking_of(horizontal, 0.02, level);
                    if (lifted) {
                        shaking.vertical_mps2 = vertical;
                    }
                    auto const block = type_a(mu, 0.9 * mu);
                    auto const detected = simulate(block, shaking, Slip::detected);
                    auto const simulated = simulate(block, shaking, Slip::simulated);
                    EXPECT_EQ(detected.slip_onset, simulated.peak_slip_m > 0) << number << ' ' << level << ' ' << mu;
                    if (detected.slip_onset) {
                        ++slipping;
                        at_impacts += simulated.impacts > 0;
                        continue;
                    }
                    ++still;
                    expect_same_motion(detected, simulated);
                    expect_same_motion(detected, simulate(block, shaking, Slip::ignored));
                }
            }
        }
    }
    EXPECT_GT(still, 200);
    EXPECT_GT(slipping, 200);
    EXPECT_GT(at_impacts, 50);
}

// A block that returns fast enough to need more friction than there is, only in the impact itself.
TEST(SlipModes, SlipInTheImpactAloneIsCalled) {
    RockingBlock block{
        .alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.5, .friction_static = 0.6, .friction_kinetic = 0.6};
    double const demand = 0.5 / 1.5 / std::tan(block.alpha_rad);  // (1-e) h / [(1+e) b] = 1.31
    std::vector<double> const calm(500, 0.0);
    auto const run = [&](Slip slip) {
        return simulate_rocking(block, shaking_of(calm, 0.01), {}, {.rotation_rad = 0.1}, nullptr, slip);
    };
    EXPECT_TRUE(run(Slip::detected).slip_onset);
    EXPECT_GT(run(Slip::simulated).peak_slip_m, 0);
    EXPECT_NEAR(run(Slip::ignored).friction_demand, demand, 1e-12);
    block.restitution = 0.8;  // 0.44 < 0.6
    EXPECT_FALSE(run(Slip::detected).slip_onset);
    EXPECT_EQ(run(Slip::simulated).peak_slip_m, 0);
    expect_same_motion(run(Slip::detected), run(Slip::simulated));
    expect_same_motion(run(Slip::detected), run(Slip::ignored));
}

// A trial that calls for slip is not run again from its start: it goes on from where friction gave out.
TEST(SlipModes, InterruptedTrialsEndAsIfSlipHadBeenSimulatedFromTheStart) {
    std::vector<std::vector<double>> waves;
    for (int number = 0; number < 24; ++number) {
        waves.push_back(testing::short_wave(number));
    }
    std::vector<RockingTrial> trials;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        for (double const level : {4.0, 6.6, 7.0, 8.0, 10.0, 14.0, 25.0}) {
            for (double const mu : {0.3, 0.655, 0.68, 0.72, 0.8, 1.0}) {
                auto shaking = shaking_of(waves[i], 0.02, level);
                if (i % 2 == 1) {
                    shaking.vertical_mps2 = waves[i - 1];
                }
                trials.push_back({type_a(mu, 0.9 * mu), shaking});
            }
        }
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    std::vector<rocking::Checkpoint> checkpoints(trials.size());
    simulate_until_slip(trials, {}, outcomes, checkpoints);

    std::map<Verdict, int> went_on;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        EXPECT_TRUE(outcomes[i].slip_onset || !checkpoints[i].reached) << i;
        if (checkpoints[i].reached) {
            auto const rest = resume_sliding(trials[i], {}, checkpoints[i]);
            auto const whole = simulate(trials[i].block, trials[i].shaking, Slip::simulated);
            expect_same_motion(rest, whole);
            EXPECT_FALSE(rest.slip_onset);
            EXPECT_EQ(rest.energy.friction_work, whole.energy.friction_work);
            auto const& energy = rest.energy;
            EXPECT_NEAR(energy.input, energy.mechanical + energy.impact_loss + energy.friction_work,
                        1e-9 * std::abs(whole.energy.input));
            ++went_on[rest.verdict];
        }
    }
    for (auto const verdict : {Verdict::slid, Verdict::rocked, Verdict::overturned}) {
        EXPECT_GT(went_on[verdict], 20) << static_cast<int>(verdict);
    }
}

//
TEST(SlipModes, MirroredWaveGivesTheBitEqualMirroredTrial) {
    int slid = 0;
    for (int number = 0; number < 10; ++number) {
        auto const wave = testing::short_wave(number);
        auto const other = testing::mirrored(wave);
        for (double const level : {6.0, 8.0, 12.0}) {
            for (double const mu : {0.0, 0.3, 0.66, 0.75}) {
                auto const one = testing::simulate_slipping(type_a(mu, 0.9 * mu), shaking_of(wave, 0.02, level));
                auto two = testing::simulate_slipping(type_a(mu, 0.9 * mu), shaking_of(other, 0.02, level));
                two.residual_slip_m = 0.0 - two.residual_slip_m;  // a body that stays put is at +0 both times
                expect_same_motion(one, two);
                EXPECT_EQ(one.energy.input, two.energy.input);
                EXPECT_EQ(one.energy.friction_work, two.energy.friction_work);
                EXPECT_EQ(one.energy.impact_loss, two.energy.impact_loss);
                slid += one.peak_slip_m > 0;
            }
        }
    }
    EXPECT_GT(slid, 60);
}

TEST(SlipModes, WaveOfNoVerticalMotionChangesNoBit) {
    auto const wave = testing::short_wave(3);
    std::vector<double> const calm(wave.size(), 0.0);
    for (double const mu : {0.3, 0.66, 0.8}) {
        auto shaking = shaking_of(wave, 0.02, 9);
        auto const without = testing::simulate_slipping(type_a(mu, 0.9 * mu), shaking);
        shaking.vertical_mps2 = calm;
        expect_same_motion(without, testing::simulate_slipping(type_a(mu, 0.9 * mu), shaking));
    }
}

}  // namespace
}  // namespace overturn
