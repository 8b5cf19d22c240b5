// Requirement R-1002: trials run side by side in vector lanes give, bit for bit, what each gives alone, whatever stands
// in the other lanes and whatever instructions the machine offers; down to plain doubles with std::fma.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "model/chunk_extremes.hpp"
#include "rocking/detail/lane_step.hpp"
#include "rocking/detail/rocking_run.hpp"
#include "rocking/planar_rocking.hpp"
#include "simd/instruction_sets.hpp"
#include "support/bit_equal.hpp"
#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

void expect_same_bits(RockingOutcome const& one, RockingOutcome const& other, std::size_t trial) {
    EXPECT_TRUE(testing::bit_equal<Outcome>(one, other)) << trial;
    EXPECT_EQ(one.slip_onset, other.slip_onset) << trial;
}

// Waves of several lengths and steps, with and without a vertical component; slender and squat blocks; every verdict.
class Mixture {
  public:
    Mixture() {
        for (int i = 0; i < 6; ++i) {
            short_.push_back(testing::short_wave(i));
        }
        auto const blocks = {RockingBlock{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9},
                             RockingBlock{.alpha_rad = 0.1, .p_radps = 3, .restitution = 0.3},
                             RockingBlock{.alpha_rad = 0.9, .p_radps = 2, .restitution = 1}, testing::type_a(0.7)};
        for (double const level : testing::levels_a()) {
            add({.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9}, long_, {}, 0.01, level);
        }
        for (std::size_t i = 0; i < short_.size(); ++i) {
            for (auto const& block : blocks) {
                for (double const level : {0.5, 3.0, 5.0, 9.0, -9.0, 30.0}) {
                    add(block, short_[i], {}, 0.02, level);
                    add(block, short_[i], short_[(i + 1) % short_.size()], 0.02, 0.7 * level);
                }
            }
        }
        for (auto const& block : {testing::lopsided_a(0.05, 0.01, 0.7), testing::lopsided_a(-0.2, 0, 1.1)}) {
            for (double const level : {4.0, -5.0, 7.0, 9.0, -12.0}) {
                add(block, short_[2], {}, 0.02, level);
                add(block, short_[3], short_[4], 0.02, level);
                trials_.back().start.rotation_rad = -0.02 * level;
            }
        }
    }
    [[nodiscard]] std::vector<RockingTrial> const& trials() const { return trials_; }

  private:
    void add(RockingBlock const& block, std::vector<double> const& horizontal, std::vector<double> const& vertical,
             double step, double level) {
        trials_.push_back(
            {block, {.horizontal_mps2 = horizontal, .vertical_mps2 = vertical, .time_step_s = step, .scale = level}});
    }

    std::vector<double> long_ = testing::filtered_wave(testing::set_a);
    std::vector<std::vector<double>> short_;
    std::vector<RockingTrial> trials_;
};

std::vector<RockingOutcome> side_by_side(std::vector<RockingTrial> const& trials, Slip slip) {
    std::vector<RockingOutcome> outcomes(trials.size());
    simulate_rocking(trials, {}, slip, outcomes);
    return outcomes;
}

TEST(Lanes, GiveWhatEachTrialGivesAlone) {
    Mixture const mixture;
    for (Slip const slip : {Slip::ignored, Slip::detected}) {
        auto const together = side_by_side(mixture.trials(), slip);
        std::array<int, 6> verdicts{};
        for (std::size_t i = 0; i < together.size(); ++i) {
            auto const& [block, shaking, start] = mixture.trials()[i];
            expect_same_bits(simulate_rocking(block, shaking, {}, start, nullptr, slip), together[i], i);
            ++verdicts.at(static_cast<std::size_t>(together[i].verdict));
        }
        for (Verdict const verdict : {Verdict::at_rest, Verdict::rocked, Verdict::overturned, Verdict::contact_lost}) {
            EXPECT_GT(verdicts.at(static_cast<std::size_t>(verdict)), 3) << static_cast<int>(verdict);
        }
    }
}

// A history is made step by step in one lane: it may not change the trial.
TEST(Lanes, AnObserverChangesNothing) {
    Mixture const mixture;
    auto const together = side_by_side(mixture.trials(), Slip::ignored);
    for (std::size_t i = 0; i < together.size(); i += 5) {
        testing::History history;
        auto const& [block, shaking, start] = mixture.trials()[i];
        expect_same_bits(simulate_rocking(block, shaking, {}, start, &history), together[i], i);
        EXPECT_GT(history.instants.size(), 10U);
    }
}

TEST(Lanes, NeighboursAndOrderDoNotMatter) {
    Mixture const mixture;
    auto const forwards = side_by_side(mixture.trials(), Slip::ignored);
    std::vector<RockingTrial> const reversed(mixture.trials().rbegin(), mixture.trials().rend());
    auto const backwards = side_by_side(reversed, Slip::ignored);
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        expect_same_bits(forwards[i], backwards[forwards.size() - 1 - i], i);
    }
    for (std::size_t count = 0; count < 20; ++count) {  // fewer trials than lanes, and a last one alone
        std::vector<RockingTrial> const few(mixture.trials().begin() + 10,
                                            mixture.trials().begin() + 10 + static_cast<std::ptrdiff_t>(count));
        auto const outcomes = side_by_side(few, Slip::ignored);
        for (std::size_t i = 0; i < count; ++i) {
            expect_same_bits(outcomes[i], forwards[10 + i], i);
        }
    }
}

// Every instruction set that was compiled in and that this machine has; the last is plain doubles.
TEST(Lanes, InstructionSetsAgreeToTheLastBit) {
    Mixture const mixture;
    auto const native = side_by_side(mixture.trials(), Slip::ignored);
    int const native_width = rocking::lane_width();
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        auto const outcomes = side_by_side(mixture.trials(), Slip::ignored);
        RecordProperty("lanes_" + std::string(simd::name_of(set)), rocking::lane_width());
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            expect_same_bits(outcomes[i], native[i], i);
        }
    }
    EXPECT_EQ(rocking::lane_width(), native_width);
}

// Waves too short for anything to happen, and none at all.
TEST(Lanes, ShortestWaves) {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};
    std::vector<double> const push(9, 6.0);
    std::vector<RockingTrial> trials;
    for (std::size_t samples = 0; samples <= push.size(); ++samples) {
        trials.push_back(
            {block, {.horizontal_mps2 = std::span(push).first(samples), .vertical_mps2 = {}, .time_step_s = 0.5}});
    }
    auto const together = side_by_side(trials, Slip::ignored);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        expect_same_bits(simulate_rocking(block, trials[i].shaking), together[i], i);
        auto const finer = simulate_rocking(block, trials[i].shaking, {.taylor_order = 12, .substeps = 64});
        EXPECT_EQ(together[i].verdict, finer.verdict) << i << " samples";
        EXPECT_EQ(together[i].verdict == Verdict::at_rest, i < 2) << "a wave lasts from its second sample on";
    }
    EXPECT_EQ(together.back().verdict, Verdict::overturned);
}

bool uses_lanes(RockingBlock const& block) { return rocking::RockingSetup(block, {}, {}, Slip::detected).uses_lanes; }

// The bound by which lanes tell that friction and contact hold ends at an inertia ratio of 0.98: blocks with less
// inertia about their own centre take scalar steps, and answer as a converged reference does.
TEST(Lanes, LeaveBlocksWithoutOwnInertiaToScalarSteps) {
    auto const block_of_ratio = [](double ratio) {
        return RockingBlock{.alpha_rad = 0.25,
                            .p_radps = 1.5,
                            .restitution = 0.9,
                            .inertia_ratio = ratio,
                            .friction_static = 0.6,
                            .friction_kinetic = 0.6};
    };
    EXPECT_TRUE(uses_lanes(block_of_ratio(0.75)));
    EXPECT_TRUE(uses_lanes(block_of_ratio(rocking::most_lane_inertia_ratio)));
    EXPECT_FALSE(uses_lanes(block_of_ratio(std::nextafter(rocking::most_lane_inertia_ratio, 1))));
    auto lopsided = testing::lopsided_a(0.05, 0, 0.7);
    EXPECT_TRUE(uses_lanes(lopsided));
    lopsided.lopsided->corners[1].inertia_ratio = 0.996;
    EXPECT_FALSE(uses_lanes(lopsided)) << "one corner is enough";

    auto const wave = testing::filtered_wave(testing::set_a);
    auto const block = block_of_ratio(0.996);  // radius of gyration 0.063 R
    std::vector<RockingTrial> trials;
    for (double const level : testing::levels_a()) {
        trials.push_back({block, testing::shaking_of(wave, 0.01, level)});
    }
    int rocked = 0;
    for (Slip const slip : {Slip::ignored, Slip::detected}) {
        auto const together = side_by_side(trials, slip);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            auto const& shaking = trials[i].shaking;
            expect_same_bits(simulate_rocking(block, shaking, {}, {}, nullptr, slip), together[i], i);
            auto const reference =
                simulate_rocking(block, shaking, {.taylor_order = 12, .substeps = 4}, {}, nullptr, slip);
            EXPECT_EQ(together[i].slip_onset, reference.slip_onset) << i;
            if (together[i].slip_onset) {
                continue;
            }
            rocked += together[i].verdict == Verdict::rocked ? 1 : 0;
            EXPECT_EQ(together[i].verdict, reference.verdict) << i;
            EXPECT_NEAR(together[i].peak_rotation_rad, reference.peak_rotation_rad, 1e-9 * reference.peak_rotation_rad)
                << i;
        }
    }
    EXPECT_GT(rocked, 3);
}

// Rest is skipped by chunks of samples; a chunk may hide nothing.
TEST(Lanes, SkippingChunksChangesNothing) {
    auto wave = testing::filtered_wave(testing::set_b);
    std::vector<double> const vertical = testing::filtered_wave(testing::set_a);
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};
    for (double const level : {2.0, 2.5, 3.3, 4.0}) {
        for (bool const lifted : {false, true}) {
            Excitation shaking{.horizontal_mps2 = wave, .vertical_mps2 = {}, .time_step_s = 0.01, .scale = level};
            if (lifted) {
                shaking.vertical_mps2 = vertical;
            }
            ChunkExtremes const chunks(shaking.horizontal_mps2, shaking.vertical_mps2);
            auto const slow = simulate_rocking(block, shaking);
            shaking.chunks = &chunks;
            expect_same_bits(simulate_rocking(block, shaking), slow, lifted ? 1 : 0);
        }
    }
}

}  // namespace
}  // namespace overturn
