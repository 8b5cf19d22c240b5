// Requirement: under one horizontal component a square base in space is the planar body, to rounding, and nothing of it
// leaves the plane.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::SpatialHistory;
using testing::standing;

struct Difference {
    double tilt_rad = 0, sway_m = 0, rise_m = 0;
};

struct Pair {
    SpatialBlock space;
    ContactBlock plane;
    Pair(RigidBody const& body, double friction, Footing const& footing = {})
        : space(standing(body, footing, friction)),
          plane(contact_block(body, {*footing.base.corner_share, footing.base.points}, {},
                              Friction{friction, friction})) {}
};

Difference largest_difference(Pair const& pair, Excitation const& shaking, ContactAccuracy const& accuracy) {
    SpatialHistory space;
    testing::ContactHistory plane;
    static_cast<void>(simulate_spatial(pair.space, shaking, accuracy, {}, &space));
    static_cast<void>(simulate_contact(pair.plane, shaking, accuracy, {}, &plane));
    EXPECT_EQ(space.instants.size(), plane.instants.size());
    Difference most;
    double const h = pair.plane.centre_height_m;
    for (std::size_t i = 0; i < std::min(space.instants.size(), plane.instants.size()); ++i) {
        auto const& s = space.instants[i];
        auto const& p = plane.instants[i];
        most.tilt_rad = std::max(most.tilt_rad, std::abs(s.tilts_rad()[1] - p.rotation_rad));
        most.sway_m = std::max(most.sway_m, std::abs(s.x_m - (p.sway_m - h * std::sin(p.rotation_rad))));
        most.rise_m = std::max(most.rise_m, std::abs(s.rise_m - p.rise_m));
    }
    return most;
}

// 60 s of noise at 1.4 times the uplift acceleration, with a vertical component.
TEST(SpatialOneAxis, IsThePlanarBody) {
    testing::TwoWaves const waves;
    for (auto const& body : {body_a(), body_b()}) {
        for (double const friction : {0.8, 10.0}) {
            Pair const pair(body, friction);
            double const level = 1.4 * body.uplift_acceleration_mps2();
            auto const most = largest_difference(
                pair, {.horizontal_mps2 = waves.x, .time_step_s = 0.01, .scale = level}, testing::unheld);
            EXPECT_LT(most.tilt_rad, 1e-12) << friction;
            EXPECT_LT(most.sway_m, 1e-12) << friction;
            EXPECT_LT(most.rise_m, 1e-12) << friction;
            RecordProperty("largest_difference_rad", std::to_string(most.tilt_rad * 1e15) + "e-15");
            printf("%g %g: %g %g %g\n", body.half_width_m(), friction, most.tilt_rad, most.sway_m, most.rise_m);
        }
    }
}

}  // namespace
}  // namespace overturn
