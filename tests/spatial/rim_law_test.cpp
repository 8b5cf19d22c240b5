// Requirement R-606: elements of a rim give back what the law states, a rim rocks as it does in its plane, far above
// Housner's restitution, and scarcely touching it presses what the integral over its arc says.
#include "contact/detail/rim_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "contact/matching.hpp"
#include "core/units.hpp"
#include "spatial/cases.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::released;
using testing::round_base;
using testing::standing;
using testing::unheld;

// At rest on its lowest point, so deep that the arc bears the weight.
SpatialStart leaning(SpatialBlock const& block, double tilt) {
    double const r = block.edge_m;
    double const h = block.planar.centre_height_m;
    double const change = r * std::sin(tilt);
    double const arc = std::cbrt(3 * pi * block.planar.settlement_m() / change);
    return {.rise_m = change * std::cos(arc) - h * (1 - std::cos(tilt)) + block.planar.settlement_m(),
            .rotation_rad = {0, tilt, 0}};
}

// By quadrature of one element's contact; and a flat drop, whose elements are equal.
TEST(SpatialRimLaw, ElementsHaveTheStatedRestitution) {
    struct Known {
        double e, y;
    };
    for (auto const& [e, y] : {Known{.05, 7.17297230},
                               {.10, 4.29101265},
                               {.25, 1.98833112},
                               {.50, .96355416},
                               {.80, .33189502},
                               {.90, .15774090},
                               {1, 0}}) {
        EXPECT_NEAR(rim_damping(e), y, 1e-6 * y) << e;
    }
    for (double const e : {0.25, 0.8}) {
        for (double const speed : {0.1, 1.0, 5.0}) {
            RigidBody const light({.mass_kg = 12.6e3,
                                   .half_width_m = 0.68,
                                   .centre_height_m = 1.045,
                                   .inertia_kgm2 = body_a().inertia_kgm2(),
                                   .gravity_mps2 = 1e-6});
            auto footing = round_base();
            footing.pad.normal_restitution = e;
            auto const block = standing(light, footing, 0.5);
            auto const end = released(block, {.rise_m = block.planar.settlement_m(), .velocity_mps = {0, 0, -speed}},
                                      0.03, {.step_ratio = 0.03, .longest_after_s = 0, .rest_gate = false})
                                 .instants.back();
            EXPECT_NEAR(end.velocity_mps[2] / speed, e, 1e-4) << e << " " << speed;
        }
    }
    for (double const e : {0.0, 0.04, 1.1}) {
        testing::expect_input_error([&] { static_cast<void>(rim_damping(e)); }, "restitution");
    }
}

// What a rim gives back by rolling from edge to edge: the least is far above Housner's value, and in space it is what
// the plane has.
TEST(SpatialRimLaw, RocksAsInItsPlane) {
    auto const base = round_base().base;
    double const usual = emergent_restitution(body_a(), base, {});
    EXPECT_NEAR(usual, 0.712, 0.003);
    EXPECT_NEAR(emergent_restitution(body_a(), base, {.normal_restitution = 0.48}), 0.738, 0.003);
    double const least = emergent_restitution(body_a(), base, {.normal_restitution = 0.05});
    EXPECT_NEAR(least, 0.696, 0.003);
    EXPECT_GT(least, body_a().housner_restitution() + 0.1);

    double const alpha = body_a().alpha_rad();
    auto const block = standing(body_a(), round_base(), firm_grip);
    auto const start = leaning(block, 0.3 * alpha);
    auto const history = released(block, start, 1).instants;
    double back = 0;
    for (auto const& instant : history) {
        back = std::min(back, instant.tilts_rad()[1]);
        if (back < 0 && instant.tilts_rad()[1] > 0) {
            break;
        }
    }
    auto const lifted = [&](double tilt) { return std::sin(alpha - tilt / 2) * std::sin(tilt / 2); };
    EXPECT_NEAR(std::sqrt(lifted(-back) / lifted(0.3 * alpha)), usual, 1e-3);
}

// One that only just touches, and one that leans on a fraction of its rim: forces are what the arc's integral says.
TEST(SpatialRimLaw, ScarcelyTouches) {
    auto const block = standing(body_a(), round_base(), 0.5);
    double const tilt = 0.1;
    double const h = block.planar.centre_height_m;
    double const change = block.edge_m * std::sin(tilt);
    for (double const share : {0.0, 1e-12, 1e-6, 1e-3, 0.1}) {  // of half the arc's sine, squared
        double const middle = change * (2 * share - 1);
        auto const history = released(block,
                                      {.rise_m = -middle - h * (1 - std::cos(tilt)) + block.planar.settlement_m(),
                                       .rotation_rad = {0, tilt, 0}},
                                      1e-5, unheld, 1e-5)
                                 .instants;
        double const arc = 2 * std::asin(std::sqrt(share));
        double const force =
            std::pow(block.planar.vertical_radps(), 2) / pi * change * (std::sin(arc) - arc * std::cos(arc)) / g0;
        EXPECT_NEAR(history.front().contact_force_ratio, force, 1e-9 + 1e-6 * force) << share;
    }
}

}  // namespace
}  // namespace overturn
