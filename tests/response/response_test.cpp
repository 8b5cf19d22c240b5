// Requirement R-504: a trial runs the effects that were asked for, and says which ones its scene would have called for.
#include <gtest/gtest.h>

#include "body/response_velocity.hpp"
#include "response/model_selector.hpp"
#include "rocking/rocking_models.hpp"
#include "support/bit_equal.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

/// A block whose uplift starts at 0.25 g.
RigidBody slender(std::optional<double> restitution = 0.9) {
    double const b = 0.5;
    double const h = 2.0;
    return RigidBody({.mass_kg = 1000,
                      .half_width_m = b,
                      .centre_height_m = h,
                      .inertia_kgm2 = 1000 * (b * b + h * h) / 3,
                      .restitution = restitution});
}

GroundMotion wave(bool with_vertical) {
    constexpr std::size_t samples = 2000;
    constexpr double time_step_s = 0.01;
    GroundMotion motion{.time_step_s = time_step_s,
                        .horizontal_mps2 = testing::broad_wave(samples, time_step_s),
                        .transverse_mps2 = {},
                        .vertical_mps2 = {}};
    if (with_vertical) {
        motion.vertical_mps2 = motion.horizontal_mps2;
        for (double& value : motion.vertical_mps2) {
            value *= -0.6;
        }
    }
    return motion;
}

struct Asked {
    std::optional<Friction> friction = {};
    EffectRequest effects = {};
};

Response trial(GroundMotion const& motion, Asked const& asked, double scale) {
    auto const body = slender();
    Scene const scene{.body = body, .friction = asked.friction};
    return ModelSelector(asked.effects).respond({scene, motion, scale});
}

double peak_scaled_to(double peak_mps2) { return peak_mps2 / peak_of(wave(false).horizontal_mps2); }

EffectRequest const none{EffectMode::none, 0};
EffectRequest const automatic{EffectMode::automatic, 0};
EffectRequest const forced_vertical{EffectMode::forced, mask_of(Effect::vertical)};
EffectRequest const forced_nothing{EffectMode::forced, 0};

// What the body did; which effects would have acted is looked at by name.
void expect_same_bits(Response one, Response const& other) {
    one.required = other.required;
    EXPECT_TRUE(testing::bit_equal<Outcome>(one, other));
}

double const rocking_scale = peak_scaled_to(3.2);

TEST(Response, NoneIgnoresTheVerticalButReportsThatItWasRequired) {
    auto const plain = trial(wave(false), {.effects = none}, rocking_scale);
    auto const ignoring = trial(wave(true), {.effects = none}, rocking_scale);

    ASSERT_EQ(plain.verdict, Verdict::rocked);
    expect_same_bits(plain, ignoring);
    EXPECT_EQ(plain.required, 0);
    EXPECT_EQ(ignoring.effects, 0);
    EXPECT_EQ(ignoring.required, mask_of(Effect::vertical));
}

//
TEST(Response, AutoUsesTheVerticalExactlyAsIfForced) {
    auto const ignoring = trial(wave(true), {.effects = none}, rocking_scale);
    auto const chosen = trial(wave(true), {.effects = automatic}, rocking_scale);
    auto const forced = trial(wave(true), {.effects = forced_vertical}, rocking_scale);

    expect_same_bits(chosen, forced);
    EXPECT_NE(chosen.peak_rotation_rad, ignoring.peak_rotation_rad);
    EXPECT_EQ(chosen.effects, mask_of(Effect::vertical));
    EXPECT_EQ(forced.effects, mask_of(Effect::vertical));
}

TEST(Response, WaveWithoutVerticalCallsForNothing) {
    auto const plain = trial(wave(false), {.effects = none}, rocking_scale);
    for (auto const& request : {automatic, forced_vertical}) {
        auto const asked = trial(wave(false), {.effects = request}, rocking_scale);

        expect_same_bits(asked, plain);
        EXPECT_EQ(asked.effects, 0);
        EXPECT_EQ(asked.required, 0);
    }
}

TEST(Response, ForcedListWithoutVerticalLeavesItOut) {
    expect_same_bits(trial(wave(true), {.effects = forced_nothing}, rocking_scale),
                     trial(wave(true), {.effects = none}, rocking_scale));
}

TEST(Response, SlidingIsCalledForWhereTheDemandExceedsStaticFriction) {
    auto const free = trial(wave(false), {.effects = automatic}, rocking_scale);
    double const demand = free.friction_demand;
    ASSERT_GT(demand, 0.25);
    EXPECT_EQ(free.required, 0) << "without a stated friction nothing slips";

    auto const called_with = [&](double friction) {
        return trial(wave(false), {.friction = Friction{friction, friction}, .effects = automatic}, rocking_scale)
            .required;
    };
    EXPECT_EQ(called_with(demand), 0) << "exactly what is needed is enough";
    EXPECT_EQ(called_with(1.001 * demand), 0);
    EXPECT_EQ(called_with(0.999 * demand), mask_of(Effect::sliding));
}

TEST(Response, StaticFrictionDecidesNotKinetic) {
    auto const free = trial(wave(false), {.effects = automatic}, rocking_scale);
    double const demand = free.friction_demand;

    EXPECT_EQ(
        trial(wave(false), {.friction = Friction{1.1 * demand, 0.1 * demand}, .effects = automatic}, rocking_scale)
            .required,
        0);
}

/// A block at rest needs |a| / g of friction; below tan alpha it stands, yet a slippery floor lets it go.
TEST(Response, BodyAtRestSlidesOnASlipperyFloor) {
    Friction const slippery{0.1, 0.1};
    auto const asked = trial(wave(false), {.friction = slippery, .effects = automatic}, peak_scaled_to(0.2 * g0));
    auto const plain = trial(wave(false), {.friction = slippery, .effects = none}, peak_scaled_to(0.2 * g0));

    EXPECT_EQ(asked.verdict, Verdict::slid);
    EXPECT_EQ(asked.model, sliding_traits().number);
    EXPECT_EQ(asked.effects, mask_of(Effect::sliding));
    EXPECT_GT(asked.peak_slip_m, 0);
    EXPECT_EQ(plain.verdict, Verdict::at_rest);
    EXPECT_EQ(plain.required, mask_of(Effect::sliding)) << "left out, but said";
    EXPECT_TRUE(testing::near(plain.friction_demand, 0.2, testing::exact_formula));
}

// R-1104: What cannot be computed is a failed trial with its reason, never a body that stands.
TEST(Response, AbsurdShakingHasNoVerdict) {
    for (double const scale :
         {1e12, 1e150, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        for (auto const& response :
             {trial(wave(true), {.effects = automatic}, scale), trial(wave(false), {.effects = none}, scale)}) {
            EXPECT_EQ(response.verdict, Verdict::failed) << scale;
            EXPECT_EQ(response.failure, FailureReason::out_of_range) << scale;
            EXPECT_TRUE(std::isnan(response.peak_rotation_rad)) << "nobody knows";
        }
    }
}

//
TEST(Response, VelocityIsThatOfThePeakRotation) {
    auto const body = slender();
    auto const rocked = trial(wave(false), {.effects = automatic}, rocking_scale);
    auto const resting = trial(wave(false), {.effects = automatic}, peak_scaled_to(2.0));
    auto const fallen = trial(wave(false), {.effects = automatic}, peak_scaled_to(30));

    EXPECT_EQ(rocked.response_velocity_mps, response_velocity(body, rocked.peak_rotation_rad));
    EXPECT_GT(rocked.response_velocity_mps, 0);
    EXPECT_LT(rocked.response_velocity_mps, body.limit_velocity_mps());
    EXPECT_EQ(resting.response_velocity_mps, 0);
    ASSERT_EQ(fallen.verdict, Verdict::overturned);
    EXPECT_TRUE(testing::near(fallen.response_velocity_mps, body.limit_velocity_mps(), testing::exact_formula));
}

/// The far edge lands at 2 b |omega|, and omega^2 / 2 p^2 is no more than the peak energy over m g R; no impact, no
/// velocity; unknown where nobody knows.
TEST(Response, ImpactVelocityIsWithinWhatTheEnergyAllows) {
    auto const body = slender();
    auto const rocked = trial(wave(false), {.effects = automatic}, rocking_scale);
    double const energy = rocked.peak_energy_ratio * (1 - std::cos(body.alpha_rad()));
    double const fastest = 2 * body.half_width_m() * body.p_radps() * std::sqrt(2 * energy);

    ASSERT_GT(rocked.impacts, 0);
    EXPECT_GT(rocked.peak_impact_velocity_mps, 0.5 * fastest);
    EXPECT_LE(rocked.peak_impact_velocity_mps, fastest * (1 + 1e-12));
    EXPECT_EQ(trial(wave(false), {.effects = automatic}, peak_scaled_to(2.0)).peak_impact_velocity_mps, 0);
    EXPECT_TRUE(std::isnan(trial(wave(false), {.effects = none}, 1e300).peak_impact_velocity_mps));
}

TEST(Response, ScaleIsTheSameAsAStrongerWave) {
    auto stronger = wave(true);
    for (auto* component : {&stronger.horizontal_mps2, &stronger.vertical_mps2}) {
        for (double& value : *component) {
            value *= 2;
        }
    }

    expect_same_bits(trial(wave(true), {.effects = automatic}, rocking_scale),
                     trial(stronger, {.effects = automatic}, rocking_scale / 2));
}

TEST(Response, BlockKeepsTheBodysNumbers) {
    auto const body = slender(std::nullopt);
    auto const block = block_of(body);

    EXPECT_EQ(block.alpha_rad, body.alpha_rad());
    EXPECT_EQ(block.p_radps, body.p_radps());
    EXPECT_EQ(block.restitution, body.housner_restitution());
    EXPECT_EQ(block.inertia_ratio, body.inertia_ratio());
    EXPECT_EQ(block.gravity_mps2, g0);
}

}  // namespace
}  // namespace overturn
