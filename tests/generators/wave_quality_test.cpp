// Requirement R-106: strong-motion durations, residuals and correlations are those of their definitions.
#include "generators/wave_quality.hpp"

#include <cmath>
#include <vector>

#include "core/units.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

TEST(WaveQuality, ConstantShakingGathersEnergyEvenly) {
    GroundMotion const motion{.time_step_s = 0.01,
                              .horizontal_mps2 = std::vector<double>(2001, 3.0),
                              .transverse_mps2 = {},
                              .vertical_mps2 = {}};

    auto const quality = wave_quality(motion);

    EXPECT_NEAR(quality.duration_5_75_s, 0.70 * 20, 1e-9);
    EXPECT_NEAR(quality.duration_5_95_s, 0.90 * 20, 1e-9);
    EXPECT_TRUE(testing::near(quality.residual_velocity_mps, 60, testing::integrated));
    EXPECT_TRUE(testing::near(quality.residual_displacement_m, 600, testing::integrated));
    EXPECT_NEAR(quality.end_velocity_ratio, 1, 1e-12);
    EXPECT_EQ(quality.correlation, 0);
}

// a = exp(-t): the integral of a^2 reaches the share s of its whole at t = -ln(1 - s (1 - exp(-2 T)))/2.
TEST(WaveQuality, DecayHasItsClosedFormDurations) {
    std::vector<double> decay(10001);
    for (std::size_t i = 0; i < decay.size(); ++i) {
        decay[i] = std::exp(-0.001 * static_cast<double>(i));
    }
    auto const quality =
        wave_quality({.time_step_s = 0.001, .horizontal_mps2 = decay, .transverse_mps2 = {}, .vertical_mps2 = {}});
    auto const time = [](double share) { return -0.5 * std::log(1 - share * (1 - std::exp(-20.0))); };

    EXPECT_NEAR(quality.duration_5_75_s, time(0.75) - time(0.05), 1e-6);
    EXPECT_NEAR(quality.duration_5_95_s, time(0.95) - time(0.05), 1e-6);
}

TEST(WaveQuality, CorrelationIsThatOfThePairThatHasMost) {
    std::vector<double> sine, cosine, mixed;
    for (int i = 0; i < 1000; ++i) {
        double const phase = 2 * pi * i / 100;
        sine.push_back(std::sin(phase) + 5);  // means do not count
        cosine.push_back(std::cos(phase));
        mixed.push_back(-0.6 * std::sin(phase) + 0.8 * std::cos(phase));
    }
    EXPECT_NEAR(correlation_of(sine, cosine), 0, 1e-12);
    EXPECT_NEAR(correlation_of(sine, mixed), -0.6, 1e-12);
    EXPECT_EQ(correlation_of(sine, std::vector<double>(1000, 2.0)), 0);
    GroundMotion const motion{
        .time_step_s = 0.01, .horizontal_mps2 = sine, .transverse_mps2 = cosine, .vertical_mps2 = mixed};
    EXPECT_NEAR(wave_quality(motion).correlation, 0.8, 1e-12);
}

}  // namespace
}  // namespace overturn
