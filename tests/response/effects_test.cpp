// Requirement R-901: effects are asked for by name, and what can be asked for is listed.
#include "response/effects.hpp"

#include "response/registry.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

TEST(Effects, ModesAndListsAreRead) {
    EXPECT_EQ(parse_effects("auto").mode, EffectMode::automatic);
    EXPECT_EQ(parse_effects("none").mode, EffectMode::none);
    auto const forced = parse_effects(" vertical ");

    EXPECT_EQ(forced.mode, EffectMode::forced);
    EXPECT_EQ(forced.include, mask_of(Effect::vertical));
}

TEST(Effects, UnknownNamesAreRefusedWithTheKnownOnes) {
    expect_input_error([] { (void)parse_effects("vertikal"); }, "vertikal", "vertical");
    expect_input_error([] { (void)parse_effects("vertical,"); }, "effect");
    expect_input_error([] { (void)parse_effects(""); }, "effect");
}

//
TEST(Effects, EveryListedEffectCanBeAskedFor) {
    for (auto const& entry : effects()) {
        EXPECT_EQ(parse_effects(std::string(entry.name)).include, mask_of(entry.value));
        EXPECT_EQ(names_of_effects(mask_of(entry.value)), entry.name);
    }
}

TEST(Effects, SetsHaveNames) {
    EXPECT_EQ(names_of_effects(0), "none");
    EXPECT_EQ(names_of_effects(mask_of(Effect::sliding) | mask_of(Effect::vertical)), "vertical, sliding");
}

}  // namespace
}  // namespace overturn
