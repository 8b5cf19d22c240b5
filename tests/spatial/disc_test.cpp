// Requirement R-606: a round base that bears evenly within its rim, or between two radii, presses as the integral of
// its law over what touches says, knows no direction, keeps its energy without damping, and is the rim where it is
// narrow.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contact/detail/rim_law.hpp"
#include "contact/matching.hpp"
#include "core/units.hpp"
#include "spatial/cases.hpp"
#include "spatial/rolling_cylinder.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::constant;
using testing::released;
using testing::round_base;
using testing::shaken;
using testing::Shaking;
using testing::standing;

Footing face(double hole) {  // of the radius
    auto footing = round_base();
    footing.base.corner_share.reset();
    footing.base.inner_radius_m = hole * body_a().half_width_m();
    return footing;
}

class Face : public ::testing::TestWithParam<double> {
  protected:
    [[nodiscard]] SpatialBlock block(double friction, Pad const& pad = {}) const {
        auto footing = face(GetParam());
        footing.pad = pad;
        return standing(body_a(), footing, friction);
    }
};
INSTANTIATE_TEST_SUITE_P(SpatialFace, Face, ::testing::Values(0.0, 0.6, 0.95),
                         [](auto const& info) { return fmt::format("{:.0f}", 100 * info.param); });

// A tilt at which the lowest point is this deep, moving in every way.
SpatialStart pressed(SpatialBlock const& block, double tilt, double deep_m) {
    double const h = block.planar.centre_height_m;
    return {.rise_m = block.edge_m * std::sin(tilt) - h * (1 - std::cos(tilt)) - deep_m + block.planar.settlement_m(),
            .rotation_rad = {0, tilt, 0},
            .velocity_mps = {0, 0, -0.02},
            .angular_velocity_radps = {0.03, -0.05, 0}};
}

struct Accelerations {
    double rise, about_x, about_y;
};

// Of a disc or ring of very many points, without friction.
Accelerations of_points(SpatialBlock const& block, SpatialStart const& start) {
    double const w = block.planar.vertical_radps();
    double const h = block.planar.centre_height_m;
    double const r = block.edge_m;
    double const tilt = start.rotation_rad[1];
    double const c = std::cos(tilt);
    double const s = std::sin(tilt);
    double const wx = start.angular_velocity_radps[0];
    double const wy = start.angular_velocity_radps[1];
    double const y = rim_damping(block.planar.pad.normal_restitution);
    double const share = w * w / (pi * (r * r - *block.inner_m * *block.inner_m));
    Accelerations sum{-block.planar.gravity_mps2, 0, 0};
    double const middle = -(start.rise_m - block.planar.settlement_m() + h * (1 - c));  // depth there
    double const chord = std::max(-r, -middle / s);
    double const half = chord > 0 ? std::sqrt(r * r - chord * chord) : r;
    constexpr int across = 600;
    double const area = (r - chord) / across * 2 * half / across;
    for (int i = 0; i < across; ++i) {
        for (int j = 0; j < across; ++j) {
            double const x = chord + (r - chord) * (i + 0.5) / across;
            double const side = half * (2 * (j + 0.5) / across - 1);
            double const far = std::hypot(x, side);
            double const depth = middle + s * x;
            if (far > r || far < *block.inner_m || depth <= 0) {
                continue;
            }
            // w x (x, y, -h), its part along the vertical, which is (-s, 0, c) along the body's axes
            double const up = s * wy * h + c * (wx * side - wy * x);
            double const approach = -(start.velocity_mps[2] + up);
            double const root = std::sqrt(approach * approach + w * w * depth * depth);
            double const force = share * area * depth * std::max(0.0, 1 + y * approach / root);
            sum.rise += force;
            sum.about_x += side * c * force;
            sum.about_y += (h * s - x * c) * force;
        }
    }
    sum.about_x /= block.inertia_over_mass_m2[0];
    sum.about_y /= block.inertia_over_mass_m2[1];
    return sum;
}

TEST_P(Face, PressesAsVeryManyPoints) {
    auto const body = block(0);
    for (double const tilt : {1e-4, 0.02, 0.3}) {
        for (double const deep : {3e-5, 1e-3, 2e-2}) {
            auto const start = pressed(body, tilt, deep);
            auto const expected = of_points(body, start);
            constexpr double step = 1e-7;
            auto const history = released(body, start, 2 * step, testing::unheld, step).instants;
            ASSERT_GE(history.size(), 2U);
            auto const rate = [&](double before, double after) { return (after - before) / step; };
            auto const& [first, second] = std::pair(history[0], history[1]);
            double const largest = std::abs(expected.rise) + std::abs(expected.about_y);
            double const close = 2e-3 * largest;
            EXPECT_NEAR(rate(first.velocity_mps[2], second.velocity_mps[2]), expected.rise, close)
                << tilt << " " << deep;
            EXPECT_NEAR(rate(first.angular_radps[1], second.angular_radps[1]), expected.about_y, close)
                << tilt << " " << deep;
            EXPECT_NEAR(rate(first.angular_radps[0], second.angular_radps[0]), expected.about_x, close)
                << tilt << " " << deep;
        }
    }
}

TEST_P(Face, SettlesAsDeepAsItsWeightPresses) {
    auto const end = released(block(0.8), {.rise_m = 1e-3}, 3).instants.back();
    EXPECT_NEAR(end.rise_m, -g0 / std::pow(2 * pi * 98, 2), 1e-12);
    EXPECT_EQ(end.tilt_rad(), 0);
    EXPECT_EQ(end.yaw_rad, 0);
}

// Of the segment that touches where the middle is this much higher than the lowest point, by its integrals.
double press_of(SpatialBlock const& block, double slope, double deep_m) {
    double const w = block.planar.vertical_radps();
    double const r = block.edge_m;
    auto const depths = [&](double radius) {
        double const middle = deep_m - slope * r;
        double const p = std::acos(std::clamp(radius > 0 ? -middle / (slope * radius) : 1.0, -1.0, 1.0));
        double const s = std::sin(p);
        return radius * radius * (middle * (p - s * std::cos(p)) + slope * radius * 2 * s * s * s / 3);
    };
    return w * w * (depths(r) - depths(*block.inner_m)) / (pi * (r * r - *block.inner_m * *block.inner_m));
}

// So deep that it bears this acceleration.
double depth_for(SpatialBlock const& block, double slope, double press) {
    double low = 0;
    double high = slope * block.edge_m;
    for (int i = 0; i < 60; ++i) {
        double const middle = (low + high) / 2;
        (press_of(block, slope, middle) < press ? low : high) = middle;
    }
    return low;
}

double largest_loss(SpatialBlock const& block, SpatialStart const& start, double step_ratio) {
    double lost = 0;
    auto const history =
        released(block, start, 1, {.step_ratio = step_ratio, .longest_after_s = 0, .rest_gate = false}).instants;
    for (auto const& instant : history) {
        lost = std::max(lost, std::abs(instant.energy_jpkg / history.front().energy_jpkg - 1));
    }
    return lost;
}

// Without friction, bouncing from one side to the other; and rolling, so that it never leaves the ground.
TEST_P(Face, KeepsItsEnergy) {
    for (double const friction : {0.0, 100.0}) {
        auto const body = block(friction, {.normal_restitution = 1, .tangential_damping = 0});
        double const slope = std::sin(0.2);
        auto start = rolling_start(body, 0.2, 1.5);
        double const of_rim = body.edge_m * slope - (start.rise_m - body.planar.settlement_m())
                              - body.planar.centre_height_m * (1 - std::cos(0.2));
        double const arc = std::acos(1 - of_rim / (body.edge_m * slope));
        double const w = body.planar.vertical_radps();
        start.rise_m += of_rim - depth_for(body, slope, std::pow(arc, 3) * w * w * body.edge_m * slope / (3 * pi));
        if (friction == 0) {
            start.angular_velocity_radps = {0.3, 0, 0};
        }
        double const coarse = largest_loss(body, start, 0.05);
        double const fine = largest_loss(body, start, 0.0125);
        RecordProperty(fmt::format("lost_{}", friction), fmt::format("{:.3g} {:.3g}", coarse, fine));
        EXPECT_LT(coarse, 1e-5) << friction;
        EXPECT_LT(fine, coarse / 16) << friction;
    }
}

// A coin that settles: damping and friction take, nothing gives.
TEST_P(Face, NeverGainsEnergy) {
    auto const body = block(0.5);
    auto start = pressed(body, 0.2, 1e-4);
    start.velocity_mps = {};
    start.angular_velocity_radps = {0.8, 0, 0.3};
    auto const history = released(body, start, 6).instants;
    double least = history.front().energy_jpkg;
    for (auto const& instant : history) {
        EXPECT_LT(instant.energy_jpkg, least + 1e-5 * history.front().energy_jpkg) << instant.time_s;
        least = std::min(least, instant.energy_jpkg);
    }
    EXPECT_LT(least, 0.8 * history.front().energy_jpkg);
}

// Two components, of which the strongest that it stands: whatever the direction, the same tilt, slip, path and yaw.
TEST_P(Face, KnowsNoDirection) {
    auto const one_sine = testing::sine(1, 0.7, 1, 0.5, 0.01);
    auto late = one_sine;
    std::rotate(late.rbegin(), late.rbegin() + 40, late.rend());
    auto const body = block(0.7);
    auto const turned = [&](double amplitude, double degrees) {
        double const c = std::cos(degrees * pi / 180);
        double const s = std::sin(degrees * pi / 180);
        std::vector<double> x(one_sine.size());
        std::vector<double> y(one_sine.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = amplitude * (c * one_sine[i] - 0.6 * s * late[i]);
            y[i] = amplitude * (s * one_sine[i] + 0.6 * c * late[i]);
        }
        return shaken(body, {x, y});
    };
    double amplitude = 8;
    auto first = turned(amplitude, 0);
    while (first.verdict == Verdict::overturned) {
        amplitude -= 0.1;
        first = turned(amplitude, 0);
    }
    RecordProperty("stands", fmt::format("{:.1f} {:.4f}", amplitude, first.peak_rotation_ratio));
    EXPECT_GT(first.peak_rotation_ratio, 0.02);
    EXPECT_GT(first.extra.slip_path_m, 1e-3);
    for (double const degrees : {17.0, 77.0, 251.0}) {
        auto const out = turned(amplitude, degrees);
        EXPECT_NEAR(out.peak_rotation_rad / first.peak_rotation_rad, 1, 1e-6) << degrees;
        EXPECT_NEAR(out.extra.slip_path_m / first.extra.slip_path_m, 1, 1e-6) << degrees;
        EXPECT_NEAR(out.extra.peak_yaw_rad, first.extra.peak_yaw_rad, 1e-6) << degrees;
        EXPECT_EQ(out.verdict, first.verdict) << degrees;
    }
}

// Under a constant push far below what parts it, it leans by h a / (w_v^2 (R^2 + r^2) / 4 - g h) once it is still.
TEST_P(Face, LeansUnderAPush) {
    auto const body = block(10);
    auto const& planar = body.planar;
    auto const push = constant(0.02 * g0, 301);
    testing::SpatialHistory history;
    static_cast<void>(shaken(body, {push, Shaking::nothing()}, testing::unheld, &history));
    double const w = planar.vertical_radps();
    double const square = (body.edge_m * body.edge_m + *body.inner_m * *body.inner_m) / 4;
    double const lean = planar.centre_height_m * 0.02 * g0 / (w * w * square - g0 * planar.centre_height_m);
    EXPECT_NEAR(history.instants.back().tilt_rad() / lean, 1, 1e-5);
}

// Let go at 0.3 alpha, as deep as its weight presses it: what of the energy it has when it leans farthest to the other
// side.
double gives_back(SpatialBlock const& block, double deep_m, double step_ratio = ContactAccuracy{}.step_ratio) {
    double const alpha = body_a().alpha_rad();
    double const tilt = 0.3 * alpha;
    SpatialStart const start{.rise_m = block.edge_m * std::sin(tilt) - deep_m
                                       - block.planar.centre_height_m * (1 - std::cos(tilt))
                                       + block.planar.settlement_m(),
                             .rotation_rad = {0, tilt, 0}};
    auto const history =
        released(block, start, 1, {.step_ratio = step_ratio, .longest_after_s = 0, .rest_gate = false}).instants;
    EXPECT_NEAR(history.front().contact_force_ratio, 1, 1e-3);
    double back = 0;
    for (auto const& instant : history) {
        back = std::min(back, instant.tilts_rad()[1]);
        if (back < 0 && instant.tilts_rad()[1] > 0) {
            break;
        }
    }
    auto const lifted = [&](double at) { return std::sin(alpha - at / 2) * std::sin(at / 2); };
    return std::sqrt(lifted(-back) / lifted(tilt));
}

double gives_back(SpatialBlock const& face, SpatialBlock const& same, double step_ratio) {
    return gives_back(same, depth_for(face, std::sin(0.3 * body_a().alpha_rad()), g0), step_ratio);
}

// Narrower and narrower, a ring is the rim.
TEST(SpatialFaces, ARingOfNoWidthIsTheRim) {
    auto const rim = standing(body_a(), round_base(), firm_grip);
    double const usual = ContactAccuracy{}.step_ratio;
    std::array<double, 3> apart{};
    std::array<double, 3> given{};
    double of_rim = 0;
    for (std::size_t i = 0; i < apart.size(); ++i) {
        auto const ring = standing(body_a(), face(1 - std::pow(10.0, -1.0 - 2.0 * static_cast<double>(i))), firm_grip);
        given.at(i) = gives_back(ring, ring, usual);
        of_rim = i == 2 ? gives_back(ring, rim, usual) : 0;  // as deep: its force is that of the narrowest
        apart.at(i) = given.at(i);
    }
    for (auto& e : apart) {
        e = std::abs(e - of_rim);
    }
    RecordProperty("given", fmt::format("{:.5f} {:.5f} {:.5f} rim {:.5f}", given[0], given[1], given[2], of_rim));
    EXPECT_LT(apart[1], apart[0] / 2);
    EXPECT_LT(apart[2], 2e-3);
}

// What it gives back in its plane, by plain arithmetic, is what space has: by its few nodes within 3e-3.
TEST(SpatialFaces, RocksAsInItsPlane) {
    auto const disc = standing(body_a(), face(0), firm_grip);
    double const in_plane = emergent_restitution(body_a(), face(0).base, {});
    double const in_space = gives_back(disc, disc, ContactAccuracy{}.step_ratio);
    RecordProperty("restitution", fmt::format("{:.5f} {:.5f}", in_plane, in_space));
    EXPECT_NEAR(in_space, in_plane, 3e-3);
    EXPECT_NEAR(in_plane, 0.833, 3e-3);
    EXPECT_GT(in_plane, emergent_restitution(body_a(), round_base().base, {}) + 0.1) << "a rim gives back less";
}

// Side by side as alone, beside rims.
TEST(SpatialFaces, LanesGiveTheBitsOfOne) {
    auto const wave = testing::sine(8, 0.7, 1, 0.5, 0.01);
    std::vector<SpatialBlock> const blocks{standing(body_a(), face(0), 0.7), standing(body_a(), round_base(), 0.7),
                                           standing(body_a(), face(0.6), 0.7), standing(body_a(), face(0), 0.3),
                                           standing(body_a(), face(0.9), 0.7)};
    Shaking const by{wave, wave};
    std::vector<SpatialTrial> trials;
    for (auto const& block : blocks) {
        trials.push_back({&block, by.excitation()});
    }
    std::vector<SpatialOutcome> outcomes(trials.size());
    simulate_spatial(trials, {}, outcomes);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        auto const alone = shaken(blocks[i], by);
        EXPECT_EQ(outcomes[i].peak_rotation_rad, alone.peak_rotation_rad) << i;
        EXPECT_EQ(outcomes[i].extra.slip_path_m, alone.extra.slip_path_m) << i;
    }
}

}  // namespace
}  // namespace overturn
