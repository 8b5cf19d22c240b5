// Requirement R-503: sliding is simulated only where it acts: `auto` gives the verdicts and numbers of sliding forced
// on.
#include <map>

#include <gtest/gtest.h>

#include "response/model_selector.hpp"
#include "rocking/rocking_models.hpp"
#include "support/bit_equal.hpp"
#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

using testing::type_a_tips;

TEST(AutomaticSliding, GivesTheVerdictsAndNumbersOfSlidingForcedOn) {
    double const half_width = 0.68;
    double const height = 1.045;
    RigidBody const body({.mass_kg = 1000,
                          .half_width_m = half_width,
                          .centre_height_m = height,
                          .inertia_kgm2 = 1000 * (half_width * half_width + height * height) / 3,
                          .restitution = 0.5538});
    ModelSelector const automatic({EffectMode::automatic, 0});
    ModelSelector const forced({EffectMode::forced, mask_of(Effect::sliding) | mask_of(Effect::vertical)});
    std::map<Verdict, int> verdicts;
    int slid = 0;
    for (int number = 0; number < 25; ++number) {
        GroundMotion motion{.time_step_s = 0.02,
                            .horizontal_mps2 = testing::short_wave(number),
                            .transverse_mps2 = {},
                            .vertical_mps2 = {}};
        if (number % 2 == 1) {
            motion.vertical_mps2 = testing::short_wave(number + 100);
            for (double& a : motion.vertical_mps2) {
                a *= 0.4;
            }
        }
        for (int level = 0; level < 10; ++level) {
            for (int friction = 0; friction < 20; ++friction) {
                double const mu = type_a_tips * (0.5 + 0.06 * friction);
                Friction const coulomb{mu, 0.9 * mu};
                double const scale = 2 + 1.4 * level;
                Scene const scene{.body = body, .friction = coulomb};
                auto const chosen = automatic.respond({scene, motion, scale});
                auto const full = forced.respond({scene, motion, scale});
                EXPECT_TRUE(testing::bit_equal<Outcome>(chosen, full));
                EXPECT_EQ(has(static_cast<EffectMask>(chosen.effects), Effect::sliding), full.peak_slip_m > 0);
                slid += chosen.model == sliding_traits().number ? 1 : 0;
                ++verdicts[chosen.verdict];
            }
        }
    }
    EXPECT_GT(verdicts[Verdict::at_rest], 100);
    EXPECT_GT(verdicts[Verdict::slid], 100);
    EXPECT_GT(verdicts[Verdict::rocked], 100);
    EXPECT_GT(verdicts[Verdict::overturned], 100);
    EXPECT_EQ(verdicts[Verdict::failed], 0);
    EXPECT_GT(slid, 500);
    for (auto const& [verdict, count] : verdicts) {
        RecordProperty("verdict_" + std::to_string(static_cast<int>(verdict)), count);
    }
}

}  // namespace
}  // namespace overturn
