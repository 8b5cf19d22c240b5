// Requirement R-1002: trials of contact run side by side in vector lanes give, bit for bit, what each gives alone,
// whatever stands in the other lanes and whatever instructions the machine offers; down to plain doubles with std::fma.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "simd/instruction_sets.hpp"
#include "support/bit_equal.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::flat_bed;

void expect_same_bits(ContactOutcome const& one, ContactOutcome const& other, std::size_t trial) {
    EXPECT_TRUE(testing::bit_equal<Outcome>(one, other)) << trial;
    EXPECT_TRUE(testing::bit_equal(one.extra, other.extra)) << trial;
    EXPECT_TRUE(one.crest_rad == other.crest_rad && one.trough_rad == other.trough_rad
                && one.end_sway_mps == other.end_sway_mps)
        << trial;
}

// Bases of several kinds, pads that yield, bodies that rest, slide, rock and fall; with and without vertical motion.
class Mixture {
  public:
    Mixture() {
        for (auto const& body : {body_a(), body_b()}) {
            for (double const friction : {0.3, 0.67, 0.8}) {
                add_block(body, {}, {}, friction);
                add_block(body, flat_bed(), {}, friction);
            }
            add_block(body, {}, {.vertical_frequency_hz = 67, .normal_restitution = 0.1}, 0.8);
            add_block(body, testing::bed(0.3), {.strength_pa = 3e6}, 0.8);
            add_block(body, flat_bed(5), {.strength_pa = 1e6}, 0.8);
            add_block(body, flat_bed(9), {}, 0.8);
            add_block(body, {.shape = BaseShape::round, .points = 16}, {}, 0.8);  // 9 points too, of another law
        }
        for (auto const& block : blocks_) {
            for (double const level : {2.0, 5.0, 8.0, 12.0, -9.0}) {
                add(block, waves_[0], {}, level);
                add(block, waves_[1], waves_[2], level);
            }
        }
    }
    [[nodiscard]] std::vector<ContactTrial> const& trials() const { return trials_; }
    [[nodiscard]] ContactOutcome alone(std::size_t i) const {
        return simulate_contact(*trials_[i].block, trials_[i].shaking);
    }

  private:
    void add_block(RigidBody const& body, BasePlan const& base, Pad const& pad, double friction) {
        blocks_.push_back(contact_block(body, base, pad, Friction{friction, friction}));
    }
    void add(ContactBlock const& block, std::vector<double> const& horizontal, std::vector<double> const& vertical,
             double level) {
        trials_.push_back(
            {&block, {.horizontal_mps2 = horizontal, .vertical_mps2 = vertical, .time_step_s = 0.01, .scale = level}});
    }

    std::array<std::vector<double>, 3> waves_{testing::sine(1, 1, 1, 1, 0.01), testing::sine(1, 1.5, 3, 0, 0.01),
                                              testing::sine(0.6, 4, 8, 0, 0.01)};
    std::vector<ContactBlock> blocks_;
    std::vector<ContactTrial> trials_;
};

std::vector<ContactOutcome> side_by_side(std::vector<ContactTrial> const& trials) {
    std::vector<ContactOutcome> outcomes(trials.size());
    simulate_contact(trials, {}, outcomes);
    return outcomes;
}

TEST(ContactLanes, GiveWhatEachTrialGivesAlone) {
    Mixture const mixture;
    auto const together = side_by_side(mixture.trials());
    std::array<int, 6> verdicts{};
    int crushed = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
        expect_same_bits(mixture.alone(i), together[i], i);
        ++verdicts.at(static_cast<std::size_t>(together[i].verdict));
        crushed += together[i].extra.peak_crush_m > 0 ? 1 : 0;
    }
    for (Verdict const verdict : {Verdict::at_rest, Verdict::slid, Verdict::rocked, Verdict::overturned}) {
        EXPECT_GT(verdicts.at(static_cast<std::size_t>(verdict)), 3) << static_cast<int>(verdict);
    }
    EXPECT_GT(crushed, 3);
}

TEST(ContactLanes, NeighboursAndOrderDoNotMatter) {
    Mixture const mixture;
    auto const forwards = side_by_side(mixture.trials());
    auto const backwards = side_by_side({mixture.trials().rbegin(), mixture.trials().rend()});
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        expect_same_bits(forwards[i], backwards[forwards.size() - 1 - i], i);
    }
    for (std::size_t count = 0; count < 20; ++count) {  // fewer trials than lanes, and a last one alone
        auto const few = side_by_side({mixture.trials().begin(), mixture.trials().begin() + static_cast<int>(count)});
        for (std::size_t i = 0; i < count; ++i) {
            expect_same_bits(few[i], forwards[i], i);
        }
    }
}

// Every instruction set that was compiled in and that this machine has; the last is plain doubles.
TEST(ContactLanes, InstructionSetsAgreeToTheLastBit) {
    Mixture const mixture;
    auto const native = side_by_side(mixture.trials());
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        auto const outcomes = side_by_side(mixture.trials());
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            expect_same_bits(outcomes[i], native[i], i);
        }
        expect_same_bits(mixture.alone(7), native[7], 7);
    }
}

// A history is made step by step in one lane: it may not change the trial.
TEST(ContactLanes, AnObserverChangesNothing) {
    Mixture const mixture;
    for (std::size_t i = 0; i < mixture.trials().size(); i += 7) {
        testing::ContactHistory history;
        auto const& [block, shaking] = mixture.trials()[i];
        expect_same_bits(simulate_contact(*block, shaking, {}, {}, &history), mixture.alone(i), i);
        EXPECT_FALSE(history.instants.empty());
    }
}

// On corners, mirrored shaking gives the mirrored motion to the last bit.
TEST(ContactLanes, MirroredTrialsMirrorEachOther) {
    auto const block = testing::on_corners(body_a(), 0.67);
    auto const wave = testing::sine(1, 1, 1, 1, 0.01);
    for (double const level : {7.0, 8.0, 12.0}) {
        auto const run = [&](double scale) {
            return simulate_contact(
                block, {.horizontal_mps2 = wave, .vertical_mps2 = {}, .time_step_s = 0.01, .scale = scale});
        };
        auto const one = run(level);
        auto const other = run(-level);
        EXPECT_EQ(one.crest_rad, -other.trough_rad);
        EXPECT_EQ(one.peak_rotation_rad, other.peak_rotation_rad);
        EXPECT_EQ(one.residual_slip_m, -other.residual_slip_m);
        EXPECT_EQ(one.steps, other.steps);
    }
}

}  // namespace
}  // namespace overturn
