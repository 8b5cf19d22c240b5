// Requirement R-504: auto takes to contact what a rigid base has no answer for, and what stands on a bed of its own;
// the row says why. Nothing else changes.
#include <gtest/gtest.h>

#include "contact/contact_model.hpp"
#include "response/model_selector.hpp"
#include "support/bit_equal.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

RigidBody const body({.mass_kg = 12.6e3,
                      .half_width_m = 0.68,
                      .centre_height_m = 1.045,
                      .inertia_kgm2 = 12.6e3 * (0.68 * 0.68 + 1.045 * 1.045) / 3,
                      .restitution = 0.7});
constexpr auto contact = mask_of(Effect::contact);
constexpr auto sliding = mask_of(Effect::sliding);

GroundMotion motion(int number) {
    return {.time_step_s = 0.02,
            .horizontal_mps2 = testing::short_wave(number),
            .transverse_mps2 = {},
            .vertical_mps2 = {}};
}

std::string_view name_of_reason(Response const& response) {
    return std::ranges::find(reasons(), response.reason, &ReasonEntry::number)->name;
}

TEST(ContactCalled, ALostContactGetsAnAnswer) {
    Scene const scene{body, std::nullopt};
    int lost = 0;
    for (int number = 0; number < 6; ++number) {
        auto const wave = motion(number);
        for (double const scale : {2.0, 6.0, 12.0, 18.0, 26.0}) {
            auto const rigid = ModelSelector({EffectMode::none, 0}).respond({scene, wave, scale});
            auto const chosen = ModelSelector(EffectRequest{}).respond({scene, wave, scale});
            if (rigid.verdict == Verdict::contact_lost) {
                ++lost;
                EXPECT_EQ(name_of_reason(chosen), "contact-lost");
                EXPECT_EQ(chosen.model, contact_traits().number);
                EXPECT_TRUE(entry_of(chosen.verdict).decided);
                auto const forced = ModelSelector({EffectMode::forced, contact}).respond({scene, wave, scale});
                EXPECT_TRUE(testing::bit_equal<Outcome>(chosen, forced));
                EXPECT_EQ(name_of_reason(forced), "stated");
            } else {
                EXPECT_EQ(name_of_reason(chosen), "none");
                EXPECT_TRUE(testing::bit_equal<Outcome>(chosen, rigid));
            }
        }
    }
    EXPECT_GT(lost, 3);
}

// Friction below tan(alpha) holds on a bed too: what slips does not rock.
TEST(ContactCalled, ABedOfItsOwnIsAlwaysContactAndSlips) {
    Footing footing;
    footing.base.corner_share.reset();
    footing.pad.match_restitution = false;
    footing.stated = true;
    Scene const firm{body, std::nullopt, footing};
    Scene const slippery{body, Friction{0.3, 0.3}, footing};
    auto const wave = motion(1);
    auto const rocks = ModelSelector(EffectRequest{}).respond({firm, wave, 9});
    auto const slides = ModelSelector(EffectRequest{}).respond({slippery, wave, 9});
    EXPECT_EQ(name_of_reason(rocks), "bedding");
    EXPECT_EQ(rocks.effects, contact);
    EXPECT_EQ(slides.effects, contact | sliding);
    EXPECT_GT(slides.peak_slip_m, 0.01);
    EXPECT_LT(slides.peak_rotation_ratio, 0.5 * rocks.peak_rotation_ratio);
    EXPECT_EQ(ModelSelector(EffectRequest{}).respond({Scene{body, std::nullopt}, wave, 0.5}).model, 0);
}

}  // namespace
}  // namespace overturn
