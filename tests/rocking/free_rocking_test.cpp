// Requirement R-402: free rocking follows Housner (1963): period, amplitude decay, energy; and the nonlinear pendulum.
#include <cmath>
#include <vector>

#include "rocking/closed_forms.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};

/// Records the instants at which the block hits the ground, and the peaks between.
class Impacts : public RockingObserver {
  public:
    void at(RockingInstant const& instant) override {
        if (instant.rotation_rad == 0 && (times.empty() || instant.time_s > times.back())) {
            times.push_back(instant.time_s);
            speeds.push_back(std::abs(instant.velocity_radps));
        }
    }
    std::vector<double> times, speeds;
};

/// The first instant at rest after the start.
struct Settling : RockingObserver {
    void at(RockingInstant const& instant) override {
        if (time_s < 0 && instant.time_s > 0 && instant.rotation_rad == 0 && instant.velocity_radps == 0) {
            time_s = instant.time_s;
        }
    }
    double time_s = -1;
};

struct ImpactTimes {
    std::vector<double> times, speeds;
};

ImpactTimes release(double ratio, RockingAccuracy const& accuracy, double restitution = 0.9) {
    std::vector<double> const calm(3000, 0.0);
    auto b = block;
    b.restitution = restitution;
    Impacts impacts;
    (void)simulate_rocking(b, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = 0.01}, accuracy,
                           {.rotation_rad = ratio * b.alpha_rad}, &impacts);
    return {impacts.times, impacts.speeds};
}

class FreeRocking : public ::testing::TestWithParam<double> {};

TEST_P(FreeRocking, LinearPeriodIsHousners) {
    auto const impacts = release(GetParam(), {.restoring = Restoring::linear});

    EXPECT_TRUE(near(impacts.times.at(0) * block.p_radps, free_rocking_period(GetParam()) / 4, testing::integrated));
}

TEST_P(FreeRocking, LinearAmplitudeDecaysAsHousners) {
    auto const impacts = release(GetParam(), {.restoring = Restoring::linear});

    // The time from one impact to the next is half the period that belongs to the amplitude between them.
    ASSERT_GE(impacts.times.size(), 6U);
    for (int n = 1; n <= 5; ++n) {
        double const amplitude = free_rocking_amplitude(GetParam(), block.restitution, n);
        double const half = (impacts.times[n] - impacts.times[n - 1]) * block.p_radps;
        EXPECT_TRUE(near(half, free_rocking_period(amplitude) / 2, testing::integrated)) << n;
    }
}

INSTANTIATE_TEST_SUITE_P(StartRatios, FreeRocking, ::testing::Values(0.1, 0.5, 0.9, 0.99));

// p T of a frictionless nonlinear block, alpha 0.25, by elliptic quadrature.
TEST(FreeRockingNonlinear, PeriodIsThePendulums) {
    EXPECT_TRUE(near(4 * block.p_radps * release(0.5, {}).times.at(0), 5.277503, testing::printed_digits));
    EXPECT_TRUE(near(4 * block.p_radps * release(0.9, {}).times.at(0), 11.978545, testing::printed_digits));
}

//
TEST(FreeRockingNonlinear, ImpactsLoseExactlyTheirShareOfEnergy) {
    auto const impacts = release(0.5, {});

    for (std::size_t i = 1; i < 10; ++i) {
        EXPECT_TRUE(near(impacts.speeds[i], 0.9 * impacts.speeds[i - 1], testing::integrated)) << i;
    }
}

/// Released at rest, the block lands first and fastest with omega^2 / 2 p^2 = cos(alpha - theta0) - cos(alpha).
TEST(FreeRockingNonlinear, FastestImpactIsTheFirst) {
    std::vector<double> const calm(3000, 0.0);
    for (double const ratio : {0.1, 0.5, 0.9}) {
        double const angle = ratio * block.alpha_rad;
        auto const out = simulate_rocking(block, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = 0.01},
                                          {}, {.rotation_rad = angle});
        double const energy = std::cos(block.alpha_rad - angle) - std::cos(block.alpha_rad);

        EXPECT_TRUE(near(out.impact_spin_radps, block.p_radps * std::sqrt(2 * energy), testing::integrated)) << ratio;
    }
}

TEST(FreeRockingNonlinear, ElasticBlockKeepsItsEnergy) {
    auto const impacts = release(0.5, {}, 1.0);

    ASSERT_GE(impacts.speeds.size(), 15U);
    EXPECT_TRUE(near(impacts.speeds.back(), impacts.speeds.front(), testing::Tolerance{1e-11, "conserved"}));
}

// Housner's linear block at rest from phi0: a quarter of its first period, then half of the period of every
// amplitude that its impacts leave, without end; their sum is when it settles.
TEST(FreeRocking, SettlesAtTheSumOfItsBounces) {
    for (double const e : {0.5, 0.7}) {
        auto b = block;
        b.restitution = e;
        std::vector<double> const calm(3000, 0.0);
        Settling seen;
        auto const out = simulate_rocking(b, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = 0.01},
                                          {.restoring = Restoring::linear}, {.rotation_rad = 0.1 * b.alpha_rad}, &seen);

        double sum = free_rocking_period(0.1) / 4;
        double bounce = 0;
        for (int n = 1; std::pow(e, n) > 1e-4; ++n) {  // below, 1 - phi has no digits left for phi
            bounce = free_rocking_period(free_rocking_amplitude(0.1, e, n)) / 2;
            sum += bounce;
        }
        sum += bounce * e / (1 - e);  // bounces as low as that are e times shorter each
        EXPECT_EQ(out.verdict, Verdict::rocked);
        EXPECT_TRUE(near(seen.time_s * b.p_radps, sum, testing::integrated)) << e;
        EXPECT_LT(out.impacts, 40) << "without the bouncing that settles";
    }
}

// Released, the corner carries least just before the first impact: omega^2 from energy, the torque from gravity.
TEST(FreeRocking, CornerCarriesLeastBeforeTheFirstImpact) {
    double const alpha = block.alpha_rad;
    double const k = block.inertia_ratio;
    for (double const ratio : {0.3, 0.8, 0.95}) {
        double const spin = 2 * k * (std::cos(alpha * (1 - ratio)) - std::cos(alpha));
        double const least = 1 - k * std::sin(alpha) * std::sin(alpha) - std::cos(alpha) * spin;
        std::vector<double> const calm(600, 0.0);
        for (int const order : taylor_orders) {
            auto const out =
                simulate_rocking(block, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = 0.01},
                                 {.taylor_order = order}, {.rotation_rad = ratio * alpha});
            EXPECT_NEAR(out.min_contact_force_ratio, least, order < 6 ? 1e-5 : 1e-9) << ratio << ", order " << order;
        }
    }
}

}  // namespace
}  // namespace overturn
