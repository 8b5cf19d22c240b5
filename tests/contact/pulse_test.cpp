// Requirement R-602: under pulses a body on a compliant base has the peaks, slips and verdicts of references made with
// steps fifty times finer, and nears the rigid body's thresholds.
#include <cmath>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::flat_bed;
using testing::on_corners;
using testing::shaken;
using testing::steps_of;

// One sine of so many times the uplift acceleration.
ContactOutcome after_sine(RigidBody const& body, BasePlan const& base, double friction, double frequency_hz,
                          double level, double step_s) {
    auto const block = contact_block(body, base, {}, Friction{friction, friction});
    auto const wave = testing::sine(level * body.uplift_acceleration_mps2(), frequency_hz, 1, 4);
    return shaken(block, wave, 1e-3, steps_of(step_s, block));
}

TEST(ContactPulse, OneSineOnCornersA) {
    auto const out = after_sine(body_a(), {}, 0.8, 1, 1.5, 5e-4);
    EXPECT_NEAR(out.peak_rotation_rad, 0.40893, 3e-3);
    EXPECT_NEAR(out.peak_rotation_rad, 0.40989, 1e-5);  // what this step gives
    auto const fine = after_sine(body_a(), {}, 0.8, 1, 1.5, 2e-5);
    EXPECT_NEAR(fine.peak_rotation_rad, 0.40893, 1e-5);
    EXPECT_NEAR(fine.time_of_peak_s, 1.5837, 1e-4);
    EXPECT_NEAR(fine.residual_slip_m, 0.02199, 1e-5);
    EXPECT_NEAR(fine.extra.peak_contact_force_ratio, 78.17, 1e-2);
    EXPECT_EQ(fine.verdict, Verdict::rocked);
}

TEST(ContactPulse, OneSineOnAFlatBedA) {
    auto const out = after_sine(body_a(), flat_bed(), 0.8, 1, 1.3, 5e-4);
    EXPECT_NEAR(out.peak_rotation_rad, 0.44560, 2e-3);
    EXPECT_NEAR(after_sine(body_a(), flat_bed(), 0.8, 1, 1.3, 2e-5).time_of_peak_s, 1.6487, 1e-4);
}

TEST(ContactPulse, OneSineOnAFlatBedB) {
    auto const out = after_sine(body_b(), flat_bed(), 0.8, 1, 1.2, 5e-4);
    EXPECT_NEAR(out.peak_rotation_rad, 0.26965, 1e-3);
    EXPECT_NEAR(out.time_of_peak_s, 1.4332, 1e-3);
}

TEST(ContactPulse, OneSineOnCornersB) {
    auto const out = after_sine(body_b(), {}, 0.8, 1.5, 1.8, 5e-4);
    EXPECT_NEAR(out.peak_rotation_rad, 0.26995, 3e-3);
    EXPECT_NEAR(after_sine(body_b(), {}, 0.8, 1.5, 1.8, 2e-5).residual_slip_m, 0.00581, 1e-5);
}

// The verdict is robust, its time is not.
TEST(ContactPulse, OneSineOverturns) {
    for (double const step_s : {1e-3, 5e-4, 1e-4}) {
        EXPECT_EQ(after_sine(body_a(), {}, 0.67, 1, 2, step_s).verdict, Verdict::overturned) << step_s;
    }
    EXPECT_NEAR(after_sine(body_a(), {}, 0.67, 1, 2, 1e-5).overturn_time_s, 3.574, 5e-3);
}

// A half sine that begins at uplift, after a slow rise to 0.999 of that; N its peak over uplift.
constexpr double half_sine_step_s = 1e-4;
std::vector<double> half_sine(RigidBody const& body, double frequency_ratio, double level) {
    double const uplift = body.uplift_acceleration_mps2();
    double const w = frequency_ratio * body.p_radps();
    double const phase = std::asin(1 / level);
    constexpr std::size_t rise = 10000;
    auto const pulse = static_cast<std::size_t>(std::ceil((pi - phase) / w / half_sine_step_s));
    std::vector<double> wave(rise + pulse + 2, 0.0);
    for (std::size_t i = 0; i < rise; ++i) {
        double const share = static_cast<double>(i) / rise;
        wave[i] = 0.999 * uplift * share * share * (3 - 2 * share);
    }
    for (std::size_t i = 0; i < pulse; ++i) {
        wave[rise + i] = level * uplift * std::sin(phase + w * half_sine_step_s * static_cast<double>(i));
    }
    return wave;
}

template <class Simulate>
double half_sine_limit(RigidBody const& body, double frequency_ratio, double about, Simulate simulate) {
    double low = 0.98 * about;
    double high = 1.02 * about;
    while (high - low > 1e-5) {
        double const level = (low + high) / 2;
        auto const wave = half_sine(body, frequency_ratio, level);
        Outcome const out =
            simulate(Excitation{.horizontal_mps2 = wave, .vertical_mps2 = {}, .time_step_s = half_sine_step_s});
        (out.verdict == Verdict::overturned && out.impacts == 0 ? high : low) = level;
    }
    return high;
}

// Under the same wave the rigid body, whose limits are held to closed forms, falls at the same N.
TEST(ContactPulse, HalfSineLimitsNearTheRigidOnes) {
    struct Case {
        RigidBody body;
        double frequency_ratio, level;
    };
    for (auto const& [body, ratio, level] :
         {Case{body_a(), 2, 1.8036}, Case{body_a(), 4, 2.8259}, Case{body_b(), 2, 1.8036}, Case{body_b(), 4, 2.8103}}) {
        auto const block = on_corners(body, firm_grip, {.vertical_frequency_hz = 392});
        RockingBlock const rigid{.alpha_rad = body.alpha_rad(),
                                 .p_radps = body.p_radps(),
                                 .restitution = body.restitution(),
                                 .inertia_ratio = body.inertia_ratio()};
        double const limit =
            half_sine_limit(body, ratio, level, [&](auto const& wave) { return simulate_contact(block, wave); });
        double const rigid_limit =
            half_sine_limit(body, ratio, level, [&](auto const& wave) { return simulate_rocking(rigid, wave); });
        EXPECT_NEAR(limit, rigid_limit, 1e-4) << ratio;
    }
}

}  // namespace
}  // namespace overturn
