// Requirement R-412: `cost` shows what the step does to every quantity of limits, beside what a last bit of the motion
// does: rounding alone of rigid bodies, a thousand times as much and more on points, and more with a coarser step.
#include "cost/step_error.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "cost/knob.hpp"
#include "support/campaigns.hpp"

namespace overturn::cost {
namespace {

constexpr char const* on_points = "friction=0.5\nbase={bedding='corners'}\npad={vertical_frequency='60 Hz'}\n";

StepError error_of(std::string const& body_more, std::string const& effects, std::string const& step = "0.3") {
    auto const input = testing::input_from(testing::quick_waves + testing::type_b + body_more
                                           + testing::levels("values=[5,6,7,8,9,10]\n") + effects
                                           + "[accuracy]\ncontact_step=" + step + "\n");
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    std::vector<PreparedWave> waves;
    PhaseSeconds ignored;
    for (std::int64_t wave = 0; wave < plan.waves(); ++wave) {
        waves.push_back(prepare_wave(spec, plan, wave, ignored));
    }
    return study_step_error(input, spec, plan, waves);
}

QuantityError const& quantity(StepError const& error, std::string const& name) {
    auto const found = std::ranges::find(error.quantities, name, &QuantityError::name);
    EXPECT_NE(found, error.quantities.end()) << name;
    return *found;
}

TEST(StepError, IsRoundingOfRigidBodies) {
    auto const error = error_of("", "");

    EXPECT_EQ(error.trials, 18);
    EXPECT_EQ(error.step_flips, 0);
    EXPECT_EQ(error.rounding_flips, 0);
    auto const& peak = quantity(error, "peak_rotation");
    ASSERT_GE(peak.step.count, 10);
    EXPECT_LT(peak.step.median, 1e-12);
    EXPECT_GT(peak.rounding.median, 0) << "motions differ by a last bit";
    EXPECT_LT(peak.rounding.median, 1e-12);
    EXPECT_TRUE(std::ranges::none_of(error.quantities, [](auto const& q) { return q.name == "peak_crush"; }));
}

TEST(StepError, IsFarMoreOnPointsAndFallsWithTheStep) {
    std::string const effects = "[effects]\ninclude=['sliding', 'contact']\n";
    auto const usual = error_of(on_points, effects);
    auto const fine = error_of(on_points, effects, "0.075");

    for (auto const* name : {"peak_rotation", "peak_slip", "peak_contact_force_ratio", "peak_rise"}) {
        auto const& at = quantity(usual, name);
        ASSERT_GE(at.step.count, 10) << name;
        EXPECT_GT(at.step.median, 1000 * at.rounding.median) << name;
        EXPECT_LT(quantity(fine, name).step.median, 0.5 * at.step.median) << name;
    }
}

TEST(StepError, CountsFlipsByTheThousand) {
    StepError error;
    EXPECT_EQ(error.step_flips_per_thousand(), 0);
    error.trials = 400;
    error.step_flips = 1;
    EXPECT_DOUBLE_EQ(error.step_flips_per_thousand(), 2.5);
    EXPECT_EQ(error.rounding_flips_per_thousand(), 0);
}

}  // namespace
}  // namespace overturn::cost
