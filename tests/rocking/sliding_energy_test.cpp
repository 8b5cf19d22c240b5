// Requirement: with sliding, energy balances in every mode: input = mechanical + impact loss + friction
// work.
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

using testing::simulate_slipping;
using testing::type_a;
using testing::type_a_tips;

struct Tally {
    double worst = 0;
    std::map<Verdict, int> verdicts;
    int slip_and_rotation = 0;
    int impacts_with_slip = 0;
};

void balance(RockingBlock const& block, Excitation const& shaking, Tally& tally) {
    auto const out = simulate_slipping(block, shaking);
    auto const& e = out.energy;
    double const off = std::abs(e.input - e.mechanical - e.impact_loss - e.friction_work);
    // The shaking gives and takes; what it gave in all is at least what was lost.
    double const turned_over = std::max({std::abs(e.input), e.impact_loss + e.friction_work, 1e-12});
    tally.worst = std::max(tally.worst, off / turned_over);
    ++tally.verdicts[out.verdict];
    tally.slip_and_rotation += out.peak_slip_m > 1e-6 && out.peak_rotation_rad > 1e-6;
    tally.impacts_with_slip += out.impacts > 0 && out.peak_slip_m > 0;
    EXPECT_NE(out.verdict, Verdict::failed);
    EXPECT_GE(e.impact_loss, 0);
    EXPECT_GE(e.friction_work, 0);
    EXPECT_LE(off, 1e-9 * turned_over) << "mu " << block.friction_static << " level " << shaking.scale << " verdict "
                                       << static_cast<int>(out.verdict);
}

TEST(SlidingEnergy, BalancesInEveryMode) {
    auto const horizontal = testing::filtered_wave(testing::set_a);
    auto const vertical = testing::filtered_wave(testing::set_b);
    std::vector<double> lighter = vertical;
    for (double& a : lighter) {
        a *= 0.4;
    }
    Tally tally;
    for (double const share : {0.0, 0.3, 0.9, 1.01, 1.05, 1.2, 1.5}) {
        for (double const kinetic : {1.0, 0.9}) {
            for (double const level : {1.5, 4.0, 6.6, 7.5, 9.0, 14.0}) {
                auto const block = type_a(share * type_a_tips, kinetic * share * type_a_tips);
                auto shaking = testing::shaking_of(horizontal, 0.01, level);
                balance(block, shaking, tally);
                shaking.vertical_mps2 = lighter;
                balance(block, shaking, tally);
            }
        }
    }
    EXPECT_GT(tally.verdicts[Verdict::at_rest], 0);
    EXPECT_GT(tally.verdicts[Verdict::slid], 0);
    EXPECT_GT(tally.verdicts[Verdict::rocked], 0);
    EXPECT_GT(tally.verdicts[Verdict::overturned], 0);
    EXPECT_GT(tally.slip_and_rotation, 10);
    EXPECT_GT(tally.impacts_with_slip, 10);
    RecordProperty("worst", fmt::format("{:.2g}", tally.worst));
}

TEST(SlidingEnergy, BalancesInDenseRockingWithImpactsThatSlip) {
    auto const wave = testing::filtered_wave(testing::set_b);
    Tally tally;
    for (double const e : {0.0, 0.3, 0.9}) {
        for (double const mu : {0.26, 0.3, 0.4}) {
            for (double const level : {3.0, 4.0, 6.0}) {
                RockingBlock const block{.alpha_rad = 0.25,
                                         .p_radps = 1.5,
                                         .restitution = e,
                                         .friction_static = mu,
                                         .friction_kinetic = 0.95 * mu};
                balance(block, testing::shaking_of(wave, 0.01, level), tally);
            }
        }
    }
    EXPECT_GT(tally.impacts_with_slip, 10);
}

TEST(SlidingEnergy, CountsWhatTheBlockWasGivenAtTheStart) {
    std::vector<double> const calm(500, 0.0);
    auto const block = type_a(0.3);
    auto const out = simulate_slipping(block, testing::shaking_of(calm, 0.01), nullptr, {.rotation_rad = 0.4});
    double const given = g0 * block.radius_m() * (std::cos(block.alpha_rad - 0.4) - std::cos(block.alpha_rad));
    EXPECT_NEAR(out.energy.input, given, 1e-14);
    EXPECT_NEAR(out.energy.impact_loss + out.energy.friction_work + out.energy.mechanical, given, 1e-10 * given);
    EXPECT_GT(out.peak_slip_m, 0);
}

// Property: while a block bounces ever lower and slips, the ground's steady pull and kinetic friction under its weight
// alone change its momentum. So it matters not at all how soon the bouncing is summed up, even where two thirds of the
// first impact's speed are left: any other friction than the kinetic one would leave another slip.
TEST(SlidingEnergy, SummedBouncingSlowsTheSlipByKineticFriction) {
    std::vector<double> pushed(1000, 0.0);
    std::fill_n(pushed.begin(), 100, 0.8 * g0);
    RockingBlock const block{
        .alpha_rad = 0.8, .p_radps = 2.4, .restitution = 0.9, .friction_static = 0.4, .friction_kinetic = 0.2};
    auto const slip_of = [&](double settle) {
        RockingAccuracy accuracy;
        accuracy.settle = settle;
        return simulate_rocking(block, testing::shaking_of(pushed, 0.01), accuracy, {.rotation_rad = 0.02}, nullptr,
                                Slip::simulated)
            .residual_slip_m;
    };
    double const stepped = slip_of(1e-5);
    EXPECT_LT(stepped, -10);
    for (double const settle : {1e-2, 1.0, 30.0, 100.0}) {
        EXPECT_NEAR(slip_of(settle), stepped, 1e-9) << settle;
    }
}

TEST(SlidingEnergy, NoImpactAddsEnergyHoweverLargeItsRestitution) {
    auto const wave = testing::filtered_wave(testing::set_a);
    for (double const mu : {0.66, 0.7}) {
        auto block = type_a(mu);
        block.restitution = 1;
        auto const out = simulate_slipping(block, testing::shaking_of(wave, 0.01, 8.0));
        auto const& e = out.energy;
        double const turned_over = std::max(std::abs(e.input), e.friction_work);
        EXPECT_GE(e.impact_loss, -1e-12 * turned_over);
        EXPECT_NEAR(e.input, e.mechanical + e.impact_loss + e.friction_work, 1e-9 * turned_over);
    }
}

}  // namespace
}  // namespace overturn
