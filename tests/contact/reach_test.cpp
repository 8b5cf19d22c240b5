// Requirement R-713: how far the edges of a base on points, its top and its rotation went to either side.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "contact/cases.hpp"

namespace overturn {
namespace {

struct Extremes {
    double most = 0, least = 0, top = 0, right = 0, left = 0;
};

// Of every instant that a history shows, the last one among them.
Extremes extremes_of(testing::ContactHistory const& history, RigidBody const& body) {
    Extremes all{.most = body.half_width_m(), .least = -body.half_width_m()};
    double const h = body.centre_height_m();
    for (auto const& at : history.instants) {
        double const sine = std::sin(at.rotation_rad);
        double const reach = body.half_width_m() * std::abs(std::cos(at.rotation_rad));
        all.most = std::max(all.most, at.sway_m - h * sine + reach);
        all.least = std::min(all.least, at.sway_m - h * sine - reach);
        all.top = std::max(all.top, std::abs(at.sway_m + h * sine));
        all.right = std::max(all.right, at.rotation_rad);
        all.left = std::min(all.left, at.rotation_rad);
    }
    return all;
}

TEST(ContactReach, IsThatOfEveryInstant) {
    auto const body = testing::body_b();
    for (double const amplitude : {-6.0, 3.0, 6.0, 20.0}) {
        testing::ContactHistory history;
        auto const block = testing::on_corners(body, amplitude == 20 ? 0.8 : 0.35);  // it falls, or slides
        auto const out = testing::shaken(block, testing::sine(amplitude, 1.2, 3, 2), 1e-3, {}, &history);
        auto const all = extremes_of(history, body);
        bool const fell = out.verdict == Verdict::overturned;
        EXPECT_EQ(fell, amplitude == 20) << amplitude;
        EXPECT_NEAR(out.extra.edge_x_most_m, all.most, 1e-12) << amplitude;
        EXPECT_NEAR(out.extra.edge_x_least_m, all.least, 1e-12) << amplitude;
        EXPECT_NEAR(out.extra.peak_top_m, all.top, 1e-12) << amplitude;
        EXPECT_NEAR(out.extra.rotation_most_rad, std::min(all.right, pi / 2), 1e-12) << amplitude;
        EXPECT_NEAR(out.extra.rotation_least_rad, std::max(all.left, -pi / 2), 1e-12) << amplitude;
        auto const& last = history.instants.back();
        EXPECT_NEAR(out.extra.residual_x_m, last.sway_m - body.centre_height_m() * std::sin(last.rotation_rad), 1e-12);
        EXPECT_EQ(std::max(out.extra.rotation_most_rad, -out.extra.rotation_least_rad), out.peak_rotation_rad);
    }
}

// The mirrored wave: the same bits to the other side.
TEST(ContactReach, IsMirroredWithTheWave) {
    auto const block = testing::on_corners(testing::body_b(), 0.35);
    auto const out = testing::shaken(block, testing::sine(6, 1.2, 3, 2), 1e-3);
    auto const mirrored = testing::shaken(block, testing::sine(-6, 1.2, 3, 2), 1e-3);
    EXPECT_EQ(out.extra.edge_x_most_m, -mirrored.extra.edge_x_least_m);
    EXPECT_EQ(out.extra.edge_x_least_m, -mirrored.extra.edge_x_most_m);
    EXPECT_EQ(out.extra.rotation_most_rad, -mirrored.extra.rotation_least_rad);
    EXPECT_EQ(out.extra.residual_x_m, -mirrored.extra.residual_x_m);
    EXPECT_EQ(out.extra.peak_top_m, mirrored.extra.peak_top_m);
    EXPECT_NE(out.extra.edge_x_most_m, -out.extra.edge_x_least_m);
}

}  // namespace
}  // namespace overturn
