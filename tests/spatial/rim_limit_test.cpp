// Requirement R-606: the continuous rim is the limit of many points, of equal law: of force, restitution, what rolling
// takes, and falls; and points that yield are enough.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contact/matching.hpp"
#include "core/units.hpp"
#include "spatial/cases.hpp"
#include "spatial/noises.hpp"
#include "spatial/rolling_cylinder.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::released;
using testing::round_base;
using testing::standing;

// Regular, with half a facet's turn against round_base.
Footing turned_polygon(int corners) {
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < corners; ++i) {
        double const angle = 2 * pi * (i + 0.5) / corners;
        places.push_back({body_a().half_width_m() * std::cos(angle), body_a().half_width_m() * std::sin(angle)});
    }
    return testing::polygon_base(places);
}

// Pressed in while it turns: what damping adds is up to twice the elastic force.
TEST(SpatialRimLimit, PointsPressAsTheRim) {
    SpatialStart const start{.rise_m = -1.2e-3,
                             .rotation_rad = {0, 2e-3, 0},
                             .velocity_mps = {0, 0, -0.1},
                             .angular_velocity_radps = {0.2, 0.3, 0}};
    auto const accelerations = [&](Footing const& footing) {
        constexpr double step = 1e-7;
        auto const history = released(standing(body_a(), footing, 0), start, 2 * step, testing::unheld, step).instants;
        auto const& [first, second] = std::pair(history[0], history[1]);
        return std::array{(second.velocity_mps[2] - first.velocity_mps[2]) / step,
                          (second.angular_radps[0] - first.angular_radps[0]) / step,
                          (second.angular_radps[1] - first.angular_radps[1]) / step};
    };
    auto const of_rim = accelerations(round_base());
    EXPECT_GT(of_rim[0], 5 * g0);
    for (auto const& footing : {round_base(256), turned_polygon(256)}) {
        auto const of_points = accelerations(footing);
        for (std::size_t i = 0; i < of_rim.size(); ++i) {
            EXPECT_NEAR(of_points.at(i), of_rim.at(i), 2e-3 * (std::abs(of_rim[0]) + std::abs(of_rim.at(i)))) << i;
        }
    }
}

// Restitutions by another integrator, of 512 points. The continuous rim, which grips as one patch, gives up to 0.07
// less.
TEST(SpatialRimLimit, PointsRockAsVeryMany) {
    struct Known {
        double normal, emergent;
    };
    for (auto const& [normal, emergent] :
         {Known{0.94, 0.866}, {0.71, 0.811}, {0.48, 0.762}, {0.25, 0.721}, {0.12, 0.698}}) {
        double const given = emergent_restitution(body_a(), round_base(64).base, {.normal_restitution = normal});
        RecordProperty(fmt::format("given_{}", normal), fmt::format("{:.4f}", given));
        EXPECT_NEAR(given, emergent, 3e-3) << normal;
    }
}

// At the steady precession, once the springs have found their balance: energy lost in three seconds. Points also give
// away the shear that they leave the ground with.
TEST(SpatialRimLimit, RollingTakesAsMuchFromPoints) {
    for (double const tilt : {0.05, 0.2}) {
        auto const lost = [&](Footing const& footing) {
            auto const block = standing(body_a(), footing, 0.8);
            double const precession = rolling_cylinder(block, false).steady_precession_radps(tilt);
            double const spin = RollingCylinder::spin_without_pivoting(tilt, precession);
            auto const history = released(block, rolling_start(block, tilt, precession, spin), 4).instants;
            return (history[history.size() / 4].energy_jpkg - history.back().energy_jpkg) / history.front().energy_jpkg;
        };
        double const of_rim = lost(round_base());
        for (auto const& footing : {round_base(64), turned_polygon(128)}) {
            double const of_points = lost(footing);
            RecordProperty(fmt::format("lost_{}_{}", tilt, footing.base.shape == BaseShape::round),
                           fmt::format("{:.4f} of {:.4f}", of_points, of_rim));
            EXPECT_NEAR(of_points / of_rim, 1, 0.15) << tilt;
        }
    }
}

// Single verdicts differ, as rolling is chaotic; as many fall, within twice the scatter of those that differ.
std::vector<bool> falls(Footing const& footing, std::vector<testing::TwoNoises> const& waves,
                        std::vector<double> const& levels) {
    auto const block = standing(body_a(), footing, 0.8);
    std::vector<SpatialTrial> trials;
    for (auto const& wave : waves) {
        for (double const level : levels) {
            trials.push_back({&block, wave.shaking(level).excitation()});
        }
    }
    std::vector<SpatialOutcome> outcomes(trials.size());
    simulate_spatial(trials, {}, outcomes);
    std::vector<bool> fell;
    for (auto const& outcome : outcomes) {
        fell.push_back(outcome.verdict == Verdict::overturned);
    }
    return fell;
}

void expect_as_many(std::vector<bool> const& found, std::vector<bool> const& of_limit, int at_least) {
    int more = 0;
    int fewer = 0;
    int both = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        more += found[i] && !of_limit[i] ? 1 : 0;
        fewer += of_limit[i] && !found[i] ? 1 : 0;
        both += of_limit[i] && found[i] ? 1 : 0;
    }
    EXPECT_GT(both, at_least);
    EXPECT_LT(std::abs(more - fewer), 2 * std::sqrt(more + fewer) + 1) << more << " more, " << fewer << " fewer";
}

TEST(SpatialRimLimit, PointsFallAsOftenAsTheRim) {
    auto const waves = testing::noises(40);
    std::vector const levels{6.6, 7.0, 7.4};
    auto const of_rim = falls(round_base(), waves, levels);
    for (auto const& footing : {round_base(64), turned_polygon(64)}) {
        expect_as_many(falls(footing, waves, levels), of_rim, 20);
    }
}

Footing crushed_rim(int points) {
    auto footing = round_base(points);
    footing.pad.strength_pa = 3e6;
    return footing;
}

// Where they yield, which is by place: as many fall whatever the direction, and on twice as many points.
TEST(SpatialRimLimit, YieldingPointsFallAsOftenAsMoreOfThem) {
    auto const waves = testing::noises(30);
    std::vector<testing::TwoNoises> turned;
    for (auto const& wave : waves) {
        turned.push_back(wave.turned(pi / BasePlan::points_around));
    }
    auto const of_more = falls(crushed_rim(2 * BasePlan::points_around), waves, {7.0});
    expect_as_many(falls(crushed_rim(BasePlan::points_around), waves, {7.0}), of_more, 12);
    expect_as_many(falls(crushed_rim(BasePlan::points_around), turned, {7.0}), of_more, 12);
}

// One pulse that yields them, turned in plan: how far the directions differ.
TEST(SpatialRimLimit, YieldingPointsKnowLittleOfDirections) {
    struct Law {
        int points;
        double tilt, yaw_rad;
    };
    auto const pulse = testing::sine(7.5, 0.7, 1, 0.5, 0.01);
    for (auto const& law : {Law{64, 6e-3, 0.05}, {128, 1e-3, 0.01}, {256, 5e-4, 5e-3}}) {
        auto const block = standing(body_a(), crushed_rim(law.points), 0.8);
        double least = 1;
        double most = 0;
        double yaw = 0;
        for (double const degrees : {0.0, 1.4, 2.8125, 60.0}) {
            auto x = pulse;
            auto y = pulse;
            for (std::size_t i = 0; i < pulse.size(); ++i) {
                x[i] *= std::cos(degrees * pi / 180);
                y[i] *= std::sin(degrees * pi / 180);
            }
            auto const out = testing::shaken(block, {x, y});
            EXPECT_GT(out.extra.peak_crush_m, 1e-3);
            EXPECT_EQ(out.verdict, Verdict::rocked) << law.points << " " << degrees;
            least = std::min(least, out.peak_rotation_ratio);
            most = std::max(most, out.peak_rotation_ratio);
            yaw = std::max(yaw, out.extra.peak_yaw_rad);
        }
        EXPECT_GT(least, 0.5);
        EXPECT_LT(most / least, 1 + law.tilt) << law.points;
        EXPECT_LT(yaw, law.yaw_rad) << law.points;
    }
}

}  // namespace
}  // namespace overturn
