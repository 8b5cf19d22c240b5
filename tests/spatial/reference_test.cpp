// Requirement R-605: bodies on every base, shaken by three components, move as the equations say, written down plainly
// a second time; and holding a quiet body at rest changes that by no more than its springs' swing.
#include "spatial/reference.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::round_base;
using testing::shaken;
using testing::SpatialHistory;
using testing::square_base;
using testing::standing;

struct ThreePulses {
    static constexpr double step_s = 0.01;
    std::vector<double> x = testing::sine(9, 1, 1, 0.6, step_s);
    std::vector<double> y = testing::sine(6, 1.6, 2, 0.35, step_s);
    std::vector<double> z = testing::sine(3, 4, 4, 0.6, step_s);

    [[nodiscard]] std::array<double, 3> at(double time_s) const {
        auto const of = [&](std::vector<double> const& wave) {
            auto const i = std::min(static_cast<std::size_t>(time_s / step_s + 1e-9), wave.size() - 2);
            double const share = time_s / step_s - static_cast<double>(i);
            return wave[i] + share * (wave[i + 1] - wave[i]);
        };
        return {of(x), of(y), of(z)};
    }
};

// Kernel and reference at the same steps, instant by instant: largest difference of place and of the quaternion.
std::tuple<double, double, double> differences(SpatialBlock const& block) {
    ThreePulses const pulses;
    SpatialHistory history;
    static_cast<void>(shaken(block, {pulses.x, pulses.y, ThreePulses::step_s, 1, pulses.z}, testing::unheld, &history));
    testing::PlainBody plain(block);
    double place = 0;
    double turn = 0;
    double tilt = 0;
    double const h = block.planar.centre_height_m;
    for (std::size_t i = 0; i + 1 < history.instants.size(); ++i) {
        auto const& instant = history.instants[i];
        auto const& state = plain.state;
        auto const matrix = testing::matrix_of(instant);
        place = std::max({place, std::abs(instant.x_m + h * matrix[0][2] - state.place.x()),
                          std::abs(instant.y_m + h * matrix[1][2] - state.place.y()),
                          std::abs(instant.rise_m + h - state.place.z())});
        for (int k = 0; k < 4; ++k) {
            turn = std::max(turn, std::abs(instant.quaternion[static_cast<std::size_t>(k)] - state.turn[k]));
        }
        tilt = std::max(tilt, instant.tilt_rad());
        plain.step(instant.time_s, history.instants[i + 1].time_s - instant.time_s,
                   [&](double time_s) { return pulses.at(time_s); });
    }
    return {place, turn, tilt};
}

TEST(SpatialReference, IsMetOnEveryBase) {
    auto weak = square_base(0.3, 5);
    weak.pad.strength_pa = 1e6;
    auto weak_rim = round_base(32);
    weak_rim.pad.strength_pa = 1e6;
    auto unequal = square_base();
    unequal.inertia_across_kgm2 = 0.7 * body_a().inertia_kgm2();
    auto const triangle = testing::polygon_base({{0.6, 0}, {-0.4, 0.6}, {-0.4, -0.6}});
    auto const four = testing::polygon_base({{0.7, 0.6}, {-0.7, 0.5}, {-0.6, -0.6}, {0.7, -0.5}});
    for (auto const& body : {body_a(), body_b()}) {
        int number = 0;
        for (auto const& footing :
             {square_base(), weak, unequal, triangle, four, round_base(32), round_base(17), weak_rim}) {
            for (double const friction : {0.3, 0.8}) {
                auto const [place, turn, tilt] = differences(standing(body, footing, friction));
                EXPECT_LT(place, 1e-9) << number << " " << friction;
                EXPECT_LT(turn, 1e-9) << number << " " << friction;
                EXPECT_GT(tilt, friction < 0.5 ? 0 : 0.01) << number << " " << friction;
            }
            ++number;
        }
    }
}

TEST(SpatialReference, IsMetOnARim) {
    for (auto const& body : {body_a(), body_b()}) {
        for (double const friction : {0.3, 0.8}) {
            auto const [place, turn, tilt] = differences(standing(body, round_base(), friction));
            EXPECT_LT(place, 1e-9) << friction;
            EXPECT_LT(turn, 1e-9) << friction;
            EXPECT_GT(tilt, friction < 0.5 ? 0 : 0.01) << friction;
        }
    }
}

TEST(SpatialReference, HoldingAtRestChangesLittle) {
    testing::TwoWaves const waves;
    for (auto const& footing : {square_base(), round_base(), square_base(0.1)}) {
        auto const block = standing(body_a(), footing, 0.8);
        for (double const level : {3.0, 5.0, 6.0}) {
            auto const held = shaken(block, {waves.x, waves.y, 0.01, level});
            auto const followed = shaken(block, {waves.x, waves.y, 0.01, level}, {.rest_gate = false});
            EXPECT_EQ(held.verdict, followed.verdict) << level;
            EXPECT_LT(held.steps, followed.steps) << level;
            EXPECT_NEAR(held.peak_rotation_rad / followed.peak_rotation_rad, 1, 1e-3) << level;
            EXPECT_NEAR(held.peak_slip_m, followed.peak_slip_m, 1e-6 + 0.02 * followed.peak_slip_m) << level;
        }
    }
}

}  // namespace
}  // namespace overturn
