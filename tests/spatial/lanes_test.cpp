// Requirement R-1002: trials in space run side by side in vector lanes give, bit for bit, what each gives alone,
// whatever stands in the other lanes and whatever instructions the machine offers; down to plain doubles with std::fma.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"
#include "spatial/cases.hpp"
#include "support/bit_equal.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::round_base;
using testing::square_base;

void expect_same_bits(SpatialOutcome const& one, SpatialOutcome const& other, std::size_t trial) {
    EXPECT_TRUE(testing::bit_equal<Outcome>(one, other)) << trial;
    EXPECT_TRUE(testing::bit_equal(one.extra, other.extra)) << trial;
    EXPECT_TRUE(one.residual_m == other.residual_m && one.end_velocity_mps == other.end_velocity_mps) << trial;
}

// Bases of many kinds and numbers of points, pads that yield, bodies that rest, slide, rock, roll and fall; one, two
// and three components of two lengths.
class Mixture {
  public:
    Mixture() {
        Footing weak = square_base(0.3, 5);
        weak.pad.strength_pa = 1e6;
        Footing crushed = round_base(16);
        crushed.pad.strength_pa = 3e6;
        auto const triangle = testing::polygon_base({{0.6, 0}, {-0.4, 0.6}, {-0.4, -0.6}});
        auto const four = testing::polygon_base({{0.7, 0.6}, {-0.7, 0.5}, {-0.6, -0.6}, {0.7, -0.5}});
        // Opposite points as a square's, of another law.
        auto const rectangle = testing::polygon_base({{0.6, 0.5}, {-0.6, 0.5}, {-0.6, -0.5}, {0.6, -0.5}});
        for (auto const& body : {body_a(), body_b()}) {
            for (auto const& footing :
                 {square_base(), round_base(), round_base(17), weak, crushed, triangle, four, rectangle}) {
                for (double const friction : {0.3, 0.8}) {
                    blocks_.push_back(testing::standing(body, footing, friction));
                }
            }
        }
        for (auto const& block : blocks_) {
            for (double const level : {1.5, 5.0, 9.0, -14.0}) {
                add(block, level, 0, false);
                add(block, level, 1, true);
                add(block, level, 2, level > 5);
            }
        }
    }
    [[nodiscard]] std::vector<SpatialTrial> const& trials() const { return trials_; }
    [[nodiscard]] SpatialOutcome alone(std::size_t i) const {
        return simulate_spatial(*trials_[i].block, trials_[i].shaking);
    }

  private:
    void add(SpatialBlock const& block, double level, std::size_t first, bool lifted) {
        std::span<double const> const x = waves_.at(first);
        auto const y = std::span<double const>(waves_.at(first + 3)).first(x.size());
        std::span<double const> const none;
        trials_.push_back({&block,
                           {.horizontal_mps2 = x,
                            .transverse_mps2 = first == 0 ? none : y,
                            .vertical_mps2 = lifted ? y : none,
                            .time_step_s = 0.01,
                            .scale = level}});
    }

    std::array<std::vector<double>, 6> waves_{testing::sine(1, 1, 1, 1, 0.01),      testing::sine(1, 1.5, 3, 0, 0.01),
                                              testing::sine(1, 0.8, 1, 0.75, 0.01), testing::sine(0.5, 2, 3, 0.5, 0.01),
                                              testing::sine(0.6, 4, 8, 0, 0.01),    testing::sine(0.9, 1, 2, 0, 0.01)};
    std::deque<SpatialBlock> blocks_;
    std::vector<SpatialTrial> trials_;
};

std::vector<SpatialOutcome> side_by_side(std::vector<SpatialTrial> const& trials) {
    std::vector<SpatialOutcome> outcomes(trials.size());
    simulate_spatial(trials, {}, outcomes);
    return outcomes;
}

TEST(SpatialLanes, GiveWhatEachTrialGivesAlone) {
    Mixture const mixture;
    auto const together = side_by_side(mixture.trials());
    std::array<int, 6> verdicts{};
    int crushed = 0;
    int turned = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
        expect_same_bits(mixture.alone(i), together[i], i);
        ++verdicts.at(static_cast<std::size_t>(together[i].verdict));
        crushed += together[i].extra.peak_crush_m > 0 ? 1 : 0;
        turned += together[i].extra.peak_yaw_rad > 0.01 ? 1 : 0;
    }
    for (Verdict const verdict : {Verdict::at_rest, Verdict::slid, Verdict::rocked, Verdict::overturned}) {
        EXPECT_GT(verdicts.at(static_cast<std::size_t>(verdict)), 3) << static_cast<int>(verdict);
    }
    EXPECT_EQ(verdicts.at(static_cast<std::size_t>(Verdict::failed)), 0);
    EXPECT_GT(crushed, 3);
    EXPECT_GT(turned, 3);
}

TEST(SpatialLanes, NeighboursAndOrderDoNotMatter) {
    Mixture const mixture;
    auto const forwards = side_by_side(mixture.trials());
    auto const backwards = side_by_side({mixture.trials().rbegin(), mixture.trials().rend()});
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        expect_same_bits(forwards[i], backwards[forwards.size() - 1 - i], i);
    }
    for (std::size_t count = 0; count < 20; count += 3) {  // fewer trials than lanes, and a last one alone
        auto const first = mixture.trials().begin() + 24;  // a rim
        auto const few = side_by_side({first, first + static_cast<int>(count)});
        for (std::size_t i = 0; i < count; ++i) {
            expect_same_bits(few[i], forwards[24 + i], i);
        }
    }
}

// Every instruction set that was compiled in and that this machine has; the last is plain doubles.
TEST(SpatialLanes, InstructionSetsAgreeToTheLastBit) {
    Mixture const mixture;
    auto const native = side_by_side(mixture.trials());
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        auto const outcomes = side_by_side(mixture.trials());
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            expect_same_bits(outcomes[i], native[i], i);
        }
        expect_same_bits(mixture.alone(31), native[31], 31);
    }
}

// Long noise on a rim that scarcely parts: touches that begin and end within a step, in company and alone.
TEST(SpatialLanes, ShortTouchesAreRemembered) {
    testing::TwoWaves const waves;
    auto const block = testing::standing(body_a(), round_base(), 0.8);
    std::vector<SpatialTrial> trials;
    for (int i = 0; i < 17; ++i) {
        trials.push_back(
            {&block,
             {.horizontal_mps2 = waves.x, .transverse_mps2 = waves.y, .time_step_s = 0.01, .scale = 5.0 + i / 6.0}});
    }
    auto const together = side_by_side(trials);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        expect_same_bits(simulate_spatial(block, trials[i].shaking), together[i], i);
    }
}

// Of the edge that the body leans on: from it, the base's centre is one edge's distance times the cosine away.
double slip_at(SpatialInstant const& at, double edge_m) {
    double const away = edge_m * (1 - std::cos(at.tilt_rad()));
    return std::hypot(at.x_m - away * std::cos(at.azimuth_rad()), at.y_m - away * std::sin(at.azimuth_rad()));
}

// A history is made step by step in one lane: it may not change the trial.
TEST(SpatialLanes, AnObserverChangesNothing) {
    Mixture const mixture;
    for (std::size_t i = 0; i < mixture.trials().size(); i += 11) {
        testing::SpatialHistory history;
        auto const& [block, shaking] = mixture.trials()[i];
        auto const out = simulate_spatial(*block, shaking, {}, {}, &history);
        expect_same_bits(out, mixture.alone(i), i);
        ASSERT_FALSE(history.instants.empty());
        double tilt = 0;
        double slip = 0;
        double yaw = 0;
        double force = 1;
        for (auto const& instant : history.instants) {
            tilt = std::max(tilt, instant.tilt_rad());
            slip = std::max(slip, slip_at(instant, block->edge_m));
            yaw = std::max(yaw, std::abs(instant.yaw_rad));
            force = std::max(force, instant.contact_force_ratio);
        }
        if (out.verdict != Verdict::overturned) {
            EXPECT_NEAR(tilt, out.peak_rotation_rad, 1e-12 + 1e-3 * tilt) << i;
            EXPECT_NEAR(slip, out.peak_slip_m, 1e-12 + 1e-3 * slip) << i;
            EXPECT_NEAR(yaw, out.extra.peak_yaw_rad, 1e-12 + 1e-3 * yaw) << i;
            EXPECT_NEAR(force, out.extra.peak_contact_force_ratio, 1e-12) << i;
        }
    }
}

}  // namespace
}  // namespace overturn
