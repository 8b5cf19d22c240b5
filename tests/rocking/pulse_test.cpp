// Requirement R-403: overturning by rectangular, half-sine and one-sine pulses follows the closed forms, survival gap
// included.
#include <cmath>
#include <functional>
#include <vector>

#include "rocking/closed_forms.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

constexpr double alpha = 0.25;

// The pulse sin(w p t) over `halves` half cycles, finely sampled: its chords miss the sine by (pi/samples)^2/8.
std::vector<double> sine(int halves) {
    constexpr int samples = 20000;
    std::vector<double> a(samples * halves + 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = std::sin(pi * static_cast<double>(i) / samples);
    }
    return a;
}

bool overturns(std::vector<double> const& pulse, double w, double n, Restoring restoring, double e = 0.9) {
    RockingBlock const block{.alpha_rad = alpha, .p_radps = 2.0, .restitution = e};
    double const threshold = restoring == Restoring::linear ? alpha : std::tan(alpha);
    double const dt = pi / (w * block.p_radps) / 20000;
    auto const out = simulate_rocking(
        block,
        {.horizontal_mps2 = pulse, .vertical_mps2 = {}, .time_step_s = dt, .scale = n * threshold * block.gravity_mps2},
        {.restoring = restoring});
    return out.verdict == Verdict::overturned;
}

struct Boundary {
    char const* name;
    int halves;
    double w, ratio;
    bool above;  // true: overturns just above the ratio; false: just below
    Restoring restoring;
};

class PulseBoundary : public ::testing::TestWithParam<Boundary> {};

TEST_P(PulseBoundary, VerdictChangesAtTheClosedForm) {
    auto const& b = GetParam();
    auto const pulse = sine(b.halves);
    constexpr double digits = 5e-6;  // the boundaries are known to six digits

    EXPECT_EQ(overturns(pulse, b.w, b.ratio * (1 + digits), b.restoring), b.above);
    EXPECT_EQ(overturns(pulse, b.w, b.ratio * (1 - digits), b.restoring), !b.above);
}

INSTANTIATE_TEST_SUITE_P(
    Linear, PulseBoundary,
    ::testing::Values(Boundary{"half_sine_w2", 1, 2, 1.800724, true, Restoring::linear},
                      Boundary{"half_sine_w4", 1, 4, 2.790798, true, Restoring::linear},
                      Boundary{"one_sine_no_impact_w2", 2, 2, 2.349903, true, Restoring::linear},
                      Boundary{"one_sine_no_impact_w4", 2, 4, 5.238964, true, Restoring::linear},
                      Boundary{"one_sine_one_impact_lower_w2", 2, 2, 1.22518, true, Restoring::linear},
                      Boundary{"one_sine_one_impact_upper_w2", 2, 2, 2.31440, false, Restoring::linear},
                      Boundary{"one_sine_one_impact_lower_w4", 2, 4, 1.79544, true, Restoring::linear},
                      Boundary{"one_sine_one_impact_upper_w4", 2, 4, 4.85011, false, Restoring::linear}),
    [](auto const& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(Nonlinear, PulseBoundary,
                         ::testing::Values(Boundary{"one_sine_lower_w4", 2, 4, 1.80572, true, Restoring::nonlinear},
                                           Boundary{"one_sine_upper_w4", 2, 4, 4.97310, false, Restoring::nonlinear},
                                           Boundary{"one_sine_no_impact_w4", 2, 4, 5.32302, true,
                                                    Restoring::nonlinear}),
                         [](auto const& info) { return info.param.name; });

// The linear closed forms themselves, so that the six digits above are traced to their equations.
TEST(PulseClosedForm, HalfSineRootSolvesItsEquation) {
    for (auto const& [w, n] : {std::pair{2.0, 1.800724}, std::pair{4.0, 2.790798}}) {
        double const psi = std::asin(1 / n);
        EXPECT_NEAR(std::cos(psi) + std::exp(-(pi - psi) / w) - w * std::sin(psi), 0, 2e-6);
    }
}

TEST(PulseClosedForm, OneSineNoImpactRootSolvesItsEquation) {
    for (auto const& [w, n] : {std::pair{2.0, 2.349903}, std::pair{4.0, 5.238964}}) {
        double const psi = std::asin(1 / n);
        EXPECT_NEAR(std::cos(psi) - std::exp(-(2 * pi - psi) / w) - w * std::sin(psi), 0, 2e-6);
    }
}

// Between the two overturning ranges lies a gap in which a stronger pulse leaves the block standing.
TEST(SurvivalGap, StrongerPulseMaySpareTheBlock) {
    auto const pulse = sine(2);
    EXPECT_TRUE(overturns(pulse, 4, 4.8, Restoring::linear));
    EXPECT_FALSE(overturns(pulse, 4, 5.0, Restoring::linear));
    EXPECT_TRUE(overturns(pulse, 4, 5.3, Restoring::linear));
}

class RectangularPulse : public ::testing::TestWithParam<double> {};

// Two samples make an exact rectangle: the wave starts and ends at its peak.
TEST_P(RectangularPulse, OverturnsAtHousnersDuration) {
    RockingBlock const block{.alpha_rad = alpha, .p_radps = 2.0, .restitution = 0.9};
    std::vector<double> const level{1.0, 1.0};
    double const limit_s = rectangular_pulse_limit(GetParam()) / block.p_radps;
    auto const verdict = [&](double duration_s) {
        return simulate_rocking(block,
                                {.horizontal_mps2 = level,
                                 .vertical_mps2 = {},
                                 .time_step_s = duration_s,
                                 .scale = GetParam() * alpha * block.gravity_mps2},
                                {.restoring = Restoring::linear})
            .verdict;
    };
    EXPECT_EQ(verdict(limit_s * (1 + 1e-9)), Verdict::overturned);
    EXPECT_EQ(verdict(limit_s * (1 - 1e-9)), Verdict::rocked);
}

INSTANTIATE_TEST_SUITE_P(Amplitudes, RectangularPulse, ::testing::Values(1.2, 2.0, 5.0, 20.0));

}  // namespace
}  // namespace overturn
