// Requirement R-603: a base in space bears as its plan says: a square one looks like the planar bed along both axes,
// every one carries its body on the axis, and what bears nothing is refused in one line.
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"
#include "spatial/spatial_block.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::polygon_base;
using testing::round_base;
using testing::square_base;
using testing::standing;

struct Moments {
    double k = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    explicit Moments(SpatialBlock const& block) {
        for (auto const& [px, py, share] : block.points) {
            k += share;
            x += share * px;
            y += share * py;
            xx += share * px * px;
            xy += share * px * py;
            yy += share * py * py;
        }
    }
};

TEST(SpatialBase, SquareLooksLikeThePlanarBed) {
    for (auto const& footing : {square_base(), square_base(0.1), square_base(0.3, 5), square_base(0.5, 16)}) {
        auto const block = standing(body_a(), footing, 0.8);
        auto const plane = contact_block(body_a(), footing.base, {}, {});
        EXPECT_EQ(block.points.size() % 2, 0U);
        for (bool const along : {true, false}) {
            std::map<double, double> seen;
            for (auto const& point : block.points) {
                seen[along ? point.x_m : point.y_m] += point.stiffness_share;
            }
            ASSERT_EQ(seen.size(), plane.points.size());
            auto expected = plane.points.begin();
            for (auto const& [offset, share] : seen) {
                EXPECT_EQ(offset, expected->offset_m);
                EXPECT_NEAR(share, expected->stiffness_share, 1e-15);
                ++expected;
            }
        }
    }
    auto const corners = standing(body_a(), square_base(), 0.8);
    EXPECT_EQ(corners.points.size(), 4U);
    EXPECT_EQ(corners.edge_m, 0.68);
    EXPECT_NEAR(corners.reach_m, 0.68 * std::sqrt(2), 1e-15);
}

TEST(SpatialBase, RoundBearsEvenlyRoundItsRim) {
    for (int const points : {16, 17, 18, 32, 100, 256}) {
        auto const block = standing(body_a(), round_base(points), 0.8);
        Moments const sum(block);
        EXPECT_NEAR(sum.k, 1, 1e-14) << points;
        EXPECT_NEAR(std::hypot(sum.x, sum.y), 0, 1e-15) << points;
        EXPECT_NEAR(sum.xx, 0.68 * 0.68 / 2, 1e-14) << points;
        EXPECT_NEAR(sum.yy, 0.68 * 0.68 / 2, 1e-14) << points;
        EXPECT_NEAR(sum.xy, 0, 1e-15) << points;
        EXPECT_NEAR(block.edge_m, 0.68 * std::cos(pi / points), 1e-15) << points;
        for (auto const& point : block.points) {
            EXPECT_NEAR(std::hypot(point.x_m, point.y_m), 0.68, 1e-15) << points;
        }
    }
}

TEST(SpatialBase, PolygonsCarryTheirBodyOnTheAxis) {
    struct Case {
        std::vector<std::array<double, 2>> corners_m;
        double edge_m, area_m2;
    };
    for (auto const& [corners, edge, area] :
         {Case{{{0.6, 0}, {-0.4, 0.6}, {-0.4, -0.6}}, 0.6 * 0.6 / std::hypot(1.0, 0.6), 0.6},
          {{{-0.4, -0.6}, {-0.4, 0.6}, {0.6, 0}}, 0.6 * 0.6 / std::hypot(1.0, 0.6), 0.6},
          {{{1, 0.5}, {-0.8, 0.5}, {-0.8, -0.6}, {1, -0.6}}, 0.5, 1.98},
          {{{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}}, 0.5, 1}}) {
        auto footing = polygon_base(corners);
        footing.pad.strength_pa = 1e6;
        auto const block = standing(body_a(), footing, 0.8);
        Moments const sum(block);
        EXPECT_NEAR(sum.k, 1, 1e-14);
        EXPECT_NEAR(std::hypot(sum.x, sum.y), 0, 1e-15);
        EXPECT_NEAR(block.edge_m, edge, 1e-15);
        double const w = block.planar.vertical_radps();
        EXPECT_NEAR(block.planar.yield_depth_m, 1e6 * area / (body_a().mass_kg() * w * w), 1e-15);
        EXPECT_EQ(block.points.size() % 2, 0U);
    }
    // Four corners off the axis: the least change from a quarter each, so linear in their place.
    auto const block = standing(body_a(), polygon_base({{1, 0.5}, {-0.8, 0.5}, {-0.8, -0.6}, {1, -0.6}}), 0.8);
    for (auto const& [x, y, share] : block.points) {
        EXPECT_NEAR(share, 0.25 - (x - 0.1) * 0.1 / 3.24 + (y + 0.05) * 0.05 / 1.21, 1e-15);
    }
}

TEST(SpatialBase, InertiaIsStatedOrTheSolidsOwn) {
    double const m = body_a().mass_kg();
    auto const plane = body_a().inertia_kgm2() / m;
    auto const of = [](Footing const& footing) { return standing(body_a(), footing, 0.8).inertia_over_mass_m2; };
    EXPECT_EQ(of(square_base())[0], plane);
    EXPECT_EQ(of(square_base())[1], plane);
    EXPECT_NEAR(of(square_base())[2], 1.36 * 1.36 / 6, 1e-15);
    EXPECT_NEAR(of(round_base())[2], 0.68 * 0.68 / 2, 1e-15);
    EXPECT_NEAR(of(polygon_base({{0.68, 0.68}, {-0.68, 0.68}, {-0.68, -0.68}, {0.68, -0.68}}))[2], 1.36 * 1.36 / 6,
                1e-15);
    auto stated = square_base();
    stated.inertia_across_kgm2 = 2 * m;
    stated.inertia_vertical_kgm2 = 3 * m;
    EXPECT_EQ(of(stated), (std::array{2.0, plane, 3.0}));
    // Uniform solids, as slender or squat as they may be, shiver at most sqrt(3) times as quickly as they bounce.
    for (double const b : {0.01, 0.68, 50.0}) {
        for (auto const& footing : {square_base(), square_base(0.1), round_base()}) {
            double const h = 1.045;
            RigidBody const body({.mass_kg = 1,
                                  .half_width_m = b,
                                  .centre_height_m = h,
                                  .inertia_kgm2 = (b * b + h * h) / 3,
                                  .restitution = 0.5});
            EXPECT_LE(standing(body, footing, 0.8).rotation_stiffness, 3) << b;
        }
    }
}

void expect_refused(Footing const& footing, std::string const& part) {
    testing::expect_input_error([&] { static_cast<void>(spatial_block(body_a(), footing, {})); }, part);
}

TEST(SpatialBase, WhatBearsNothingIsRefused) {
    double const nan = std::numeric_limits<double>::quiet_NaN();
    expect_refused(square_base(1, 1), "1 points");
    expect_refused(square_base(1.1), "share");
    expect_refused(round_base(2), "2 points");
    expect_refused(round_base(15), "15 points");
    expect_refused(round_base(257), "257 points");
    expect_refused(polygon_base({}), "0 corners");
    expect_refused(polygon_base({{1, 0}}), "1 corners");
    expect_refused(polygon_base({{1, 0}, {-1, 0}}), "2 corners");
    expect_refused(polygon_base({{1, 0}, {0, 0}, {-1, 0}}), "axis");    // no area
    expect_refused(polygon_base({{2, 1}, {2, -1}, {1, 0}}), "axis");    // beside it
    expect_refused(polygon_base({{1, 1}, {-1, 1}, {-1, -1}}), "axis");  // on an edge
    expect_refused(polygon_base({{1, 1}, {0, 0.2}, {-1, 1}, {-1, -1}, {1, -1}}), "inwards");
    expect_refused(polygon_base({{1, 0}, {-0.8, 0.6}, {0.3, -0.95}, {0.3, 0.95}, {-0.8, -0.6}}), "round");  // a star
    expect_refused(polygon_base({{1, nan}, {-1, 1}, {-1, -1}}), "corner 1");
    expect_refused(polygon_base({{0.1, 0.05}, {-3, 0.05}, {-3.1, 0}, {-3, -0.05}, {-2.9, -0.06}, {0.1, -0.05}}),
                   "bears nothing");
    auto footing = square_base();
    footing.inertia_across_kgm2 = -1;
    expect_refused(footing, "horizontal");
    footing = square_base();
    footing.inertia_vertical_kgm2 = nan;
    expect_refused(footing, "vertical");
    footing.inertia_vertical_kgm2 = 1e-3 * body_a().mass_kg();
    expect_refused(footing, "inertia");
    footing = round_base();
    footing.pad.strength_pa = 0;
    expect_refused(footing, "strength");
    footing = round_base();
    footing.pad.normal_restitution = 0;
    expect_refused(footing, "restitution");
}

}  // namespace
}  // namespace overturn
