// Requirement: a base slides by Coulomb's law: Shenton's boundaries of initiation, and closed forms of
// sliding blocks.
#include <array>
#include <functional>
#include <string>

#include "support/sliding_blocks.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::History;
using testing::near;
using testing::shaking_of;
using testing::simulate_slipping;

// --- initiation ------------------------------------------------------------------------------------------------------

enum class Motion { rest, slide, rock, slide_rock };

/// What a rectangle of slenderness gamma = h/b does first under a constant acceleration of A g.
Motion initiation(double gamma, double acceleration_g, double friction) {
    RockingBlock const block{.alpha_rad = std::atan(1 / gamma),
                             .p_radps = 2,
                             .restitution = 0.5,
                             .gravity_mps2 = 1,
                             .friction_static = friction,
                             .friction_kinetic = friction};
    std::vector<double> const constant(3, acceleration_g);
    constexpr double moment_s = 1e-6;  // the rotation has turned the weight by 1e-12 at most
    History history;
    (void)simulate_slipping(block, shaking_of(constant, moment_s), &history);
    RockingInstant last = history.instants.front();
    for (auto const& instant : history.instants) {
        last = instant.time_s <= moment_s * (1 + 1e-12) ? instant : last;
    }
    bool const slips = last.slip_velocity_mps != 0;
    bool const rocks = last.velocity_radps != 0;
    return slips ? (rocks ? Motion::slide_rock : Motion::slide) : rocks ? Motion::rock : Motion::rest;
}

/// Where a motion turns into another one between lo and hi.
double boundary(double lo, double hi, std::function<Motion(double)> const& motion) {
    Motion const below = motion(lo);
    for (int i = 0; i < 60; ++i) {
        double const middle = 0.5 * (lo + hi);
        (motion(middle) == below ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

/// Friction from which on a rectangle rocks without slip (Shenton 1996).
double rocking_friction(double gamma, double a) {
    return (a * (4 + gamma * gamma) + 3 * gamma) / (1 + 4 * gamma * gamma + 3 * a * gamma);
}

constexpr testing::Tolerance initiation_limit{1e-9, "initiation_limit"};

class Initiation : public ::testing::TestWithParam<double> {};

TEST_P(Initiation, EveryRegionIsShentons) {
    double const gamma = GetParam();
    for (double a = 0.0313; a < 3; a += 0.0771) {
        for (double mu = 0.0157; mu < 0.95; mu += 0.0219) {
            Motion const expected = a < std::min(mu, 1 / gamma)       ? Motion::rest
                                    : mu < 1 / gamma                  ? Motion::slide
                                    : mu < rocking_friction(gamma, a) ? Motion::slide_rock
                                                                      : Motion::rock;
            EXPECT_EQ(initiation(gamma, a, mu), expected) << "A " << a << " mu " << mu;
            EXPECT_EQ(initiation(gamma, -a, mu), expected) << "A " << -a << " mu " << mu;
        }
    }
}

TEST_P(Initiation, RestEndsAtFrictionOrAtTheEdge) {
    double const gamma = GetParam();
    for (double const share : {0.1, 0.5, 0.99}) {
        double const mu = share / gamma;
        double const slides = boundary(0.5 * mu, 2 * mu, [&](double a) { return initiation(gamma, a, mu); });
        EXPECT_TRUE(near(slides, mu, initiation_limit));
    }
    double const mu = std::min(0.99, 1.5 / gamma);
    double const tips = boundary(0.5 / gamma, 2 / gamma, [&](double a) { return initiation(gamma, a, mu); });
    EXPECT_TRUE(near(tips, 1 / gamma, initiation_limit));
}

TEST_P(Initiation, SlideRockLiesBetweenTheEdgeAndShentonsFriction) {
    double const gamma = GetParam();
    for (double const share : {1.05, 1.5, 2.0}) {
        double const a = share / gamma;
        double const rocks = rocking_friction(gamma, a);
        double const between = 0.5 * (1 / gamma + rocks);
        auto const at = [&](double mu) { return initiation(gamma, a, mu); };
        EXPECT_EQ(at(between), Motion::slide_rock);
        EXPECT_TRUE(near(boundary(0.5 / gamma, between, at), 1 / gamma, initiation_limit));
        EXPECT_TRUE(near(boundary(between, std::min(1.3, 2 * rocks), at), rocks, initiation_limit));
    }
}

INSTANTIATE_TEST_SUITE_P(Slenderness, Initiation, ::testing::Values(1.1, 1.5, 2.0, 4.0, 8.0));

TEST(InitiationValue, SlendernessTwoUnderOneGRocksFrom14Over23) {
    auto const at = [](double mu) { return initiation(2, 1, mu); };
    EXPECT_TRUE(near(boundary(0.55, 0.7, at), 14.0 / 23, initiation_limit));
}

TEST(InitiationValue, KineticFrictionBelowTheEdgeLetsItSlideFlat) {
    // Static friction lets it tip at 0.5 g but cannot hold the corner (14/23 at 1 g); kinetic friction cannot tip it.
    RockingBlock const block{.alpha_rad = std::atan(0.5),
                             .p_radps = 2,
                             .restitution = 0.5,
                             .friction_static = 0.55,
                             .friction_kinetic = 0.45};
    std::vector<double> const pulse(11, g0);
    auto const out = simulate_slipping(block, shaking_of(pulse, 0.01));
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_EQ(out.peak_rotation_rad, 0);
    EXPECT_TRUE(std::isnan(out.first_uplift_s));
    EXPECT_TRUE(near(out.peak_slip_m, 0.5 * (1 - 0.45) * g0 * 0.1 * 0.1 / 0.45, testing::exact_formula));
}

TEST(Painleve, RectangleIsRefusedFromFourThirdsOn) { EXPECT_DOUBLE_EQ(painleve_bound(0.75), 4.0 / 3); }

// --- sliding blocks --------------------------------------------------------------------------------------------------

/// Broad enough never to tip.
RockingBlock slab(double friction_static, double friction_kinetic) {
    return {.alpha_rad = 1.3,
            .p_radps = 2,
            .restitution = 0.5,
            .friction_static = friction_static,
            .friction_kinetic = friction_kinetic};
}

/// The instant at which a base that is only braked by friction stops, seen from the last step.
double stop_time(History const& history, double friction_kinetic) {
    for (auto i = history.instants.rbegin(); i != history.instants.rend(); ++i) {
        if (i->slip_velocity_mps != 0) {
            return i->time_s + std::abs(i->slip_velocity_mps) / (friction_kinetic * g0);
        }
    }
    return -1;
}

struct FrictionPair {
    double of_rest, of_slip;
};
constexpr std::array frictions{FrictionPair{0.2, 0.2}, FrictionPair{0.3, 0.2}, FrictionPair{0.05, 0.01}};

// Newmark (1965): under A g the base gains (A - mu) g against the ground for a time T, then mu g brakes it:
// v = (A - mu) g T, it stops at T + v/(mu g) = A T / mu, having slipped v T/2 + v^2/(2 mu g) = (A - mu) g T^2 A/(2 mu).
TEST(SlidingBlock, RectangularPulseIsNewmarks) {
    for (double const sign : {1.0, -1.0}) {
        for (auto const [mu_s, mu] : frictions) {
            double const a = 0.5;
            double const length = 0.3;
            std::vector<double> const pulse(31, sign * a * g0);
            History history;
            auto const out = simulate_slipping(slab(mu_s, mu), shaking_of(pulse, 0.01), &history);

            double const slip = (a - mu) * g0 * length * length * a / (2 * mu);
            EXPECT_EQ(out.verdict, Verdict::slid);
            EXPECT_TRUE(near(out.peak_slip_m, slip, testing::exact_formula));
            EXPECT_TRUE(near(out.residual_slip_m, -sign * slip, testing::exact_formula));
            EXPECT_TRUE(near(stop_time(history, mu), a * length / mu, testing::exact_formula));
        }
    }
}

// Half a sine A g sin(wt): slip starts at t0 = asin(mu_s/A)/w; the speed against the ground at T = pi/w is
// v = A g/w (cos w t0 + 1) - mu g (T - t0), the path so far A g [cos(w t0)(T - t0)/w + sin(w t0)/w^2] -
// mu g (T - t0)^2/2, and the brake adds v^2/(2 mu g). Samples see chords of the sine: the error goes with dt^2.
TEST(SlidingBlock, SinePulseIsNewmarks) {
    for (auto const [mu_s, mu] : frictions) {
        double const a = 0.5;
        double const length = 0.5;
        double const w = pi / length;
        double const t0 = std::asin(mu_s / a) / w;
        double const rest = length - t0;
        double const v = a * g0 / w * (std::cos(w * t0) + 1) - mu * g0 * rest;
        double const slip = a * g0 * (std::cos(w * t0) * rest / w + std::sin(w * t0) / (w * w))
                            - 0.5 * mu * g0 * rest * rest + v * v / (2 * mu * g0);
        ASSERT_GT(v, 0);
        std::array<double, 2> errors{};
        for (int refined = 0; refined < 2; ++refined) {
            std::size_t const steps = refined == 0 ? 2000 : 4000;
            std::vector<double> pulse(steps + 1);
            for (std::size_t i = 0; i <= steps; ++i) {
                pulse[i] = a * g0 * std::sin(pi * static_cast<double>(i) / static_cast<double>(steps));
            }
            History history;
            auto const out =
                simulate_slipping(slab(mu_s, mu), shaking_of(pulse, length / static_cast<double>(steps)), &history);
            errors.at(refined) = std::abs(out.peak_slip_m - slip) / slip;
            EXPECT_TRUE(near(stop_time(history, mu), length + v / (mu * g0), {2e-6, "chords of a sine"}));
        }
        EXPECT_LT(errors[1], 5e-7);
        EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
    }
}

TEST(SlidingBlock, SmoothGroundLeavesItAtRestInSpace) {
    // Ground that moves from rest under a(t), linear between samples: d = sum of exact cubics. The slip is -d.
    auto const wave = testing::short_wave(1);
    double const dt = 0.02;
    History history;
    auto const out = simulate_slipping(slab(0, 0), shaking_of(wave, dt), &history);

    double velocity = 0;
    double ground = 0;
    double largest = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < wave.size(); ++i) {
        double const t = dt * static_cast<double>(i);
        while (next < history.instants.size() && history.instants[next].time_s < t - 1e-9) {
            ++next;
        }
        ASSERT_NEAR(history.instants[next].time_s, t, 1e-9);
        EXPECT_NEAR(history.instants[next].slip_m, -ground, 1e-12) << t;
        EXPECT_NEAR(history.instants[next].slip_velocity_mps, -velocity, 1e-12) << t;
        ground += dt * velocity + dt * dt * (wave[i] / 3 + wave[i + 1] / 6);
        velocity += 0.5 * dt * (wave[i] + wave[i + 1]);
        largest = std::max(largest, std::abs(ground));
    }
    EXPECT_GT(largest, 0.05);
    EXPECT_EQ(out.energy.friction_work, 0);
}

// One sample of 1 s from +g to -g, friction 0.1: slip starts at once, v/g = -(t - t^2) + 0.1 t falls to zero at
// t = 0.9, where the ground pulls with -0.8 g: slip goes on the other way with v/g = t^2 - t - 0.1 t from there.
TEST(SlidingBlock, SlipReversesInsideOneSample) {
    double const mu = 0.1;
    std::vector<double> const wave{g0, -g0};
    auto const out = simulate_slipping(slab(mu, mu), shaking_of(wave, 1.0));

    double const turn = 1 - mu;
    double const there = -g0 * (turn * turn * turn / 6);  // int (-(1-mu) t + t^2) dt from 0 to 1-mu
    auto const speed = [&](double t) { return g0 * (t * t - (1 + mu) * t + 2 * mu * turn); };
    auto const path = [&](double t) { return g0 * (t * t * t / 3 - (1 + mu) * t * t / 2 + 2 * mu * turn * t); };
    ASSERT_NEAR(speed(turn), 0, 1e-12);
    double const brake = speed(1) * speed(1) / (2 * mu * g0);
    double const back = path(1) - path(turn) + brake;
    EXPECT_EQ(out.verdict, Verdict::slid);
    EXPECT_TRUE(near(out.peak_slip_m, -there, testing::exact_formula));
    EXPECT_TRUE(near(out.residual_slip_m, there + back, testing::exact_formula));
}

TEST(SlidingBlock, StaysStuckWhereStaticFrictionHoldsAfterAStop) {
    // 0.5 g for 0.1 s, then 0.25 g: it stops under mu_k = 0.3 > 0.25, and mu_s holds it.
    double const mu = 0.3;
    std::vector<double> wave(12, 0.25 * g0);
    wave[0] = wave[1] = 0.5 * g0;
    double const dt = 0.1;
    auto const out = simulate_slipping(slab(0.35, mu), shaking_of(wave, dt));
    // speeds at the sample ends, per g: 0.2 t; then 0.2 t - 1.25 t^2 down to -0.05 after it; then -0.05 t to rest.
    double const v1 = 0.2 * dt;
    double const v2 = v1 + 0.2 * dt - 1.25 * dt * dt;
    double const slip = 0.1 * dt * dt + v1 * dt + 0.1 * dt * dt - 1.25 / 3 * dt * dt * dt + v2 * v2 / (2 * 0.05);
    EXPECT_TRUE(near(out.peak_slip_m, g0 * slip, testing::exact_formula));
    EXPECT_TRUE(near(out.residual_slip_m, -g0 * slip, testing::exact_formula));
}

TEST(SlidingBlock, VerticalAccelerationChangesItsWeight) {
    // a = 0.5 g, gv = 1.2 g, mu = 0.3: slips at 0.5 - 0.36 = 0.14 g; the brake after the wave is 0.3 g.
    double const length = 0.2;
    std::vector<double> const pulse(21, 0.5 * g0);
    std::vector<double> const up(21, 0.2 * g0);
    auto shaking = shaking_of(pulse, 0.01);
    shaking.vertical_mps2 = up;
    auto const out = simulate_slipping(slab(0.3, 0.3), shaking);
    double const v = 0.14 * g0 * length;
    EXPECT_TRUE(near(out.peak_slip_m, 0.5 * v * length + v * v / (0.6 * g0), testing::exact_formula));
}

// how far it slipped to either side is what every instant says, and goes to the other side with the wave.
TEST(Sliding, SlipsToEitherSide) {
    std::vector<double> wave(400, 0.0);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        double const t = 0.01 * static_cast<double>(i);
        wave[i] = (t < 2 ? 6 : 4) * std::sin(4 * t * (1 + 0.3 * t));
    }
    auto const block = testing::type_a(0.3);
    History history;
    auto const out = simulate_slipping(block, shaking_of(wave, 0.01), &history);
    double most = 0;
    double least = 0;
    for (auto const& at : history.instants) {
        most = std::max(most, at.slip_m);
        least = std::min(least, at.slip_m);
    }
    EXPECT_NEAR(out.most_slip_m, most, 1e-12);
    EXPECT_NEAR(out.least_slip_m, least, 1e-12);
    EXPECT_EQ(std::max(out.most_slip_m, -out.least_slip_m), out.peak_slip_m);
    EXPECT_GT(std::abs(out.most_slip_m + out.least_slip_m), 1e-3);
    auto const other = simulate_slipping(block, shaking_of(testing::mirrored(wave), 0.01));
    EXPECT_EQ(other.most_slip_m, -out.least_slip_m);
    EXPECT_EQ(other.least_slip_m, -out.most_slip_m);
}

}  // namespace
}  // namespace overturn
