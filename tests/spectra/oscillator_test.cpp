// Requirement R-201: the oscillator is exact between samples for any damping and any ratio of step to period.
#include "spectra/oscillator.hpp"

#include <cmath>
#include <ostream>

#include "core/units.hpp"
#include "support/expect_input_error.hpp"
#include "support/oscillator_history.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

struct Case {
    char const* name;
    double period_s, damping;

    friend void PrintTo(Case const& one, std::ostream* out) { *out << one.name; }
};
class Ramp : public ::testing::TestWithParam<Case> {};

// Displacement under a = t from rest, y'' + 2 z w y' + w^2 y = -t, in long double from the roots of the equation.
double ramp_response(double w_, double z_, double t_) {
    long double const w = w_;
    long double const z = z_;
    long double const t = t_;
    long double const c = 2 * z / (w * w * w);  // particular: -t/w^2 + c
    auto const decay = std::exp(-z * w * t);
    long double const rate0 = 1 / (w * w);
    long double free = 0;
    if (z < 1) {
        auto const d = w * std::sqrt(1 - z * z);
        free = decay * (-c * std::cos(d * t) + (rate0 - z * w * c) / d * std::sin(d * t));
    } else if (z == 1) {
        free = decay * (-c + (rate0 - w * c) * t);
    } else {
        auto const d = w * std::sqrt(z * z - 1);
        auto const side = (rate0 - z * w * c) / d;
        free = 0.5L * ((side - c) * std::exp((d - z * w) * t) - (side + c) * std::exp(-(d + z * w) * t));
    }
    return static_cast<double>(-t / (w * w) + c + free);
}

TEST_P(Ramp, EqualsTheClosedForm) {
    auto const [name, period, damping] = GetParam();
    constexpr double dt = 0.01;
    std::vector<double> ramp(401);
    for (std::size_t n = 0; n < ramp.size(); ++n) {
        ramp[n] = dt * static_cast<double>(n);
    }

    auto const history = testing::oscillator_history(ramp, dt, period, damping);

    double const scale = std::abs(ramp_response(2 * pi / period, damping, 4.0));
    for (std::size_t const n : {1U, 10U, 100U, 400U}) {
        double const exact = ramp_response(2 * pi / period, damping, dt * static_cast<double>(n));
        EXPECT_TRUE(near(history.displacement_m[n], exact, exact_formula, scale)) << n;
    }
}
INSTANTIATE_TEST_SUITE_P(DampingAndPeriod, Ramp,
                         ::testing::Values(Case{"undamped", 1, 0}, Case{"light", 1, 0.05}, Case{"long", 30, 0.1},
                                           Case{"near_critical_below", 0.05, 0.9999999}, Case{"critical", 1, 1},
                                           Case{"critical_short", 0.02, 1},
                                           Case{"near_critical_above", 0.05, 1.0000001}, Case{"above", 1, 3},
                                           Case{"far_above", 1, 50}, Case{"as_short_as_the_step", 0.01, 0.05},
                                           Case{"far_shorter", 0.0007, 0.3}, Case{"far_shorter_above", 0.0007, 40}),
                         [](auto const& one) { return one.param.name; });

TEST(Oscillator, VeryLongPeriodMeasuresGroundMotion) {
    std::vector<double> const step(1001, 2.0);

    auto const history = testing::oscillator_history(step, 0.01, 1e7, 0.05);

    EXPECT_TRUE(near(history.displacement_m.back(), -0.5 * 2.0 * 100, testing::Tolerance{1e-6, "w t"}));
    EXPECT_TRUE(near(history.velocity_mps.back(), -2.0 * 10, testing::Tolerance{1e-5, "w t"}));
}

TEST(Oscillator, StepLoadOvershootsToTwiceTheStaticDisplacement) {
    std::vector<double> const step(101, 3.0);  // half a period of 2 s at 0.01 s is sample 100

    auto const history = testing::oscillator_history(step, 0.01, 2.0, 0.0);

    EXPECT_TRUE(near(history.displacement_m[100], -2 * 3.0 / (pi * pi), exact_formula));
    EXPECT_TRUE(near(history.acceleration_mps2[100], 6.0, exact_formula));
}

TEST(Oscillator, LongAndShortStepsMeet) {
    for (double const damping : {0.0, 0.3, 1.0, 2.0}) {
        for (double const x : {0.999999, 1.000001}) {  // either side of where the formula changes
            OscillatorStep const whole(x / 0.02, damping, 0.02);
            OscillatorStep const half(x / 0.02, damping, 0.01);
            EXPECT_NEAR(whole.yy, half.yy * half.yy + half.yv * half.vy, 1e-15);
            EXPECT_NEAR(whole.yv, half.yy * half.yv + half.yv * half.vv, 1e-17);
            EXPECT_NEAR(whole.my, 0.5 * (half.my + half.my * half.yy + half.mv * half.vy), 1e-15);
        }
    }
}

TEST(Oscillator, RefusesNonsense) {
    testing::expect_input_error([] { OscillatorStep(1, -0.1, 0.01); }, "damping ratio -0.1");
    testing::expect_input_error([] { OscillatorStep(1, 0.1, 0); }, "time step 0 s");
}

}  // namespace
}  // namespace overturn
