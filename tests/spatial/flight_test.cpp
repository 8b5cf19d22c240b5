// Requirement R-604: a body that touches nothing keeps its angular momentum and its energy and falls as the closed form
// says, and every step is of fourth order.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::released;
using testing::standing;

using Vector = std::array<double, 3>;

Vector angular_momentum(SpatialBlock const& block, SpatialInstant const& at) {
    auto const matrix = testing::matrix_of(at);
    Vector momentum{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            momentum[i] += matrix[i][j] * block.inertia_over_mass_m2[j] * at.angular_radps[j];
        }
    }
    return momentum;
}

double rotational_energy(SpatialBlock const& block, SpatialInstant const& at) {
    double energy = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        energy += 0.5 * block.inertia_over_mass_m2[i] * at.angular_radps[i] * at.angular_radps[i];
    }
    return energy;
}

// Thrown from so high that it stays in the air.
SpatialStart thrown() { return {.rise_m = 1000, .angular_velocity_radps = {1, 0.5, 2}}; }

SpatialBlock with_inertia(double x_over_y) {
    auto block = standing(body_a(), {}, 0.8);
    block.inertia_over_mass_m2[0] = x_over_y * block.inertia_over_mass_m2[1];
    block.inertia_over_mass_m2[2] = 0.6;  // its axis stays within 90 degrees
    return block;
}

TEST(SpatialFlight, KeepsAngularMomentumAndEnergy) {
    for (double const ratio : {1.0, 1.2, 0.7}) {
        auto const block = with_inertia(ratio);
        auto const history = released(block, thrown(), 10);
        ASSERT_GT(history.instants.back().time_s, 9.99) << ratio;
        auto const momentum = angular_momentum(block, history.instants.front());
        double const energy = rotational_energy(block, history.instants.front());
        double const length = std::hypot(momentum[0], momentum[1], momentum[2]);
        double tilt = 0;
        for (auto const& instant : history.instants) {
            auto const now = angular_momentum(block, instant);
            for (std::size_t i = 0; i < 3; ++i) {
                ASSERT_NEAR(now[i], momentum[i], 1e-12 * length) << ratio << " " << instant.time_s;
            }
            ASSERT_NEAR(rotational_energy(block, instant) / energy, 1, 1e-12) << ratio << " " << instant.time_s;
            tilt = std::max(tilt, instant.tilt_rad());
        }
        EXPECT_GT(tilt, 0.3);
    }
}

TEST(SpatialFlight, FallsAsTheClosedForm) {
    auto const block = with_inertia(1);
    auto start = thrown();
    start.velocity_mps = {3, -2, 1};
    auto const last = released(block, start, 10).instants.back();
    double const t = last.time_s;
    EXPECT_NEAR(t, 10, 1e-12);
    auto const matrix = testing::matrix_of(last);
    double const h = block.planar.centre_height_m;
    EXPECT_NEAR(last.rise_m, 1000 - block.planar.settlement_m() + t - 0.5 * g0 * t * t, 1e-10);
    EXPECT_NEAR(last.x_m + h * matrix[0][2], 3 * t, 1e-10);
    EXPECT_NEAR(last.y_m + h * matrix[1][2], -2 * t, 1e-10);
}

// Of a body symmetric about its axis the free motion is known: the axis goes round the angular momentum at |L| / I_x.
TEST(SpatialFlight, PrecessesAsTheClosedForm) {
    auto const block = with_inertia(1);
    auto const history = released(block, thrown(), 10);
    auto const momentum = angular_momentum(block, history.instants.front());
    double const length = std::hypot(momentum[0], momentum[1], momentum[2]);
    double const angle = length / block.inertia_over_mass_m2[0] * history.instants.back().time_s;
    Vector const u{momentum[0] / length, momentum[1] / length, momentum[2] / length};
    // The vertical axis, turned about u.
    double const c = std::cos(angle);
    double const s = std::sin(angle);
    Vector const expected{u[0] * u[2] * (1 - c) + u[1] * s, u[1] * u[2] * (1 - c) - u[0] * s,
                          c + u[2] * u[2] * (1 - c)};
    auto const matrix = testing::matrix_of(history.instants.back());
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(matrix[i][2], expected[i], 1e-11) << i;
    }
}

// Steps twice as long err sixteen times as much.
TEST(SpatialFlight, IsOfFourthOrder) {
    auto const block = with_inertia(1.2);
    SpatialStart const fast{.rise_m = 1000, .angular_velocity_radps = {4, 2, 8}};
    auto const end_of = [&](double step_s) {
        return released(
                   block, fast, 2,
                   {.step_ratio = step_s * block.planar.vertical_radps(), .longest_after_s = 0, .rest_gate = false},
                   0.04)
            .instants.back()
            .quaternion;
    };
    auto const exact = end_of(2.5e-4);
    auto const error = [&](double step_s) {
        auto const q = end_of(step_s);
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += (q[i] - exact[i]) * (q[i] - exact[i]);
        }
        return std::sqrt(sum);
    };
    double const coarse = error(0.02);
    double const fine = error(0.01);
    EXPECT_GT(coarse, 1e-9);
    EXPECT_NEAR(coarse / fine, 16, 2.5);
}

}  // namespace
}  // namespace overturn
