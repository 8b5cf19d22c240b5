// Requirement R-605: what is done to the shaking, a turn or a mirror that leaves the base as it is, is done to the
// motion, and a round base knows no direction.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::round_base;
using testing::shaken;
using testing::SpatialHistory;
using testing::square_base;
using testing::standing;

/// Both components as a 2 x 2 matrix maps them.
struct Mapped {
    std::vector<double> x, y;
    Mapped(testing::TwoWaves const& waves, std::size_t samples, double xx, double xy, double yx, double yy) {
        for (std::size_t i = 0; i < samples; ++i) {
            x.push_back(xx * waves.x[i] + xy * waves.y[i]);
            y.push_back(yx * waves.x[i] + yy * waves.y[i]);
        }
    }
    static Mapped turned(testing::TwoWaves const& waves, std::size_t samples, double angle_rad) {
        double const c = std::cos(angle_rad);
        double const s = std::sin(angle_rad);
        return {waves, samples, c, -s, s, c};
    }
};

std::vector<SpatialInstant> history_of(SpatialBlock const& block, Mapped const& waves, double level) {
    SpatialHistory history;
    static_cast<void>(shaken(block, {waves.x, waves.y, 0.01, level}, {}, &history));
    return std::move(history.instants);
}

// The same words of two instants, as the mapping has them.
void expect_mapped(std::vector<SpatialInstant> const& one, std::vector<SpatialInstant> const& other, double x, double y,
                   double yaw) {
    ASSERT_EQ(one.size(), other.size());
    double tilt = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_TRUE(other[i].x_m == x * one[i].x_m && other[i].y_m == y * one[i].y_m && other[i].rise_m == one[i].rise_m
                    && other[i].quaternion[0] == one[i].quaternion[0]
                    && other[i].quaternion[1] == y * one[i].quaternion[1]
                    && other[i].quaternion[2] == x * one[i].quaternion[2] && other[i].yaw_rad == yaw * one[i].yaw_rad)
            << i << " of " << one.size();
        tilt = std::max(tilt, one[i].tilt_rad());
    }
    EXPECT_GT(tilt, 0.001);
}

// To the last bit, friction, impacts and all.
TEST(SpatialSymmetry, MirroredShakingMirrorsCorners) {
    testing::TwoWaves const waves;
    auto const block = standing(body_a(), square_base(), 0.7);
    auto const plain = history_of(block, {waves, 3001, 1, 0, 0, 1}, 14);
    expect_mapped(plain, history_of(block, {waves, 3001, 1, 0, 0, -1}, 14), 1, -1, -1);
    expect_mapped(plain, history_of(block, {waves, 3001, -1, 0, 0, 1}, 14), -1, 1, -1);
}

TEST(SpatialSymmetry, HalfATurnTurnsEveryOppositeBase) {
    testing::TwoWaves const waves;
    for (auto const& footing : {square_base(), square_base(0.1), square_base(0.3, 5), round_base(), round_base(18)}) {
        auto const block = standing(body_a(), footing, 0.7);
        auto const plain = history_of(block, {waves, 2501, 1, 0, 0, 1}, 11);
        expect_mapped(plain, history_of(block, {waves, 2501, -1, 0, 0, -1}, 11), -1, -1, 1);
    }
}

// Rounding goes another way, and rocking lets it grow.
TEST(SpatialSymmetry, AQuarterTurnTurnsASquare) {
    testing::TwoWaves const waves;
    for (auto const& footing : {square_base(), square_base(0.1)}) {
        auto const block = standing(body_a(), footing, 0.8);
        auto const plain = history_of(block, {waves, 2001, 1, 0, 0, 1}, 9);
        auto const turned = history_of(block, {waves, 2001, 0, -1, 1, 0}, 9);
        ASSERT_EQ(plain.size(), turned.size());
        double most = 0;
        double tilt = 0;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            most = std::max({most, std::abs(turned[i].tilts_rad()[1] - plain[i].tilts_rad()[0]),
                             std::abs(turned[i].tilts_rad()[0] + plain[i].tilts_rad()[1]),
                             std::abs(turned[i].yaw_rad - plain[i].yaw_rad)});
            tilt = std::max(tilt, plain[i].tilt_rad());
        }
        EXPECT_LT(most, 1e-10);
        EXPECT_GT(tilt, 0.003);
        RecordProperty("difference_1e-15", std::to_string(most * 1e15));
    }
}

// By a point's place round the rim to rounding; by less, within what the points make of a circle.
TEST(SpatialSymmetry, ARoundBaseKnowsNoDirection) {
    testing::TwoWaves pulse;
    pulse.x = testing::sine(1, 1, 1, 0.3, 0.01);
    pulse.y = testing::sine(0.7, 1.5, 1, 0, 0.01);
    pulse.y.resize(pulse.x.size());
    struct Case {
        int points;
        double angle_rad, difference_rad;
    };
    auto const gap = [](int points) { return 2 * (1 - std::cos(pi / points)); };  // of a chord, over the radius, twice
    for (auto const& [points, angle, difference] : {Case{32, 2 * pi / 32, 1e-12},
                                                    {32, 5 * 2 * pi / 32, 1e-12},
                                                    {32, pi / 32, gap(32)},
                                                    {32, 1.0, gap(32)},
                                                    {128, pi / 128, gap(128)},
                                                    {128, 1.0, gap(128)}}) {
        auto const block = standing(body_a(), round_base(points), 10);
        auto const plain = history_of(block, Mapped::turned(pulse, pulse.x.size(), 0), 9);
        auto const turned = history_of(block, Mapped::turned(pulse, pulse.x.size(), angle), 9);
        double most = 0;
        double tilt = 0;
        for (std::size_t i = 0; i < plain.size() && plain[i].time_s < 1.3; ++i) {
            most = std::max(most, std::abs(plain[i].tilt_rad() - turned[i].tilt_rad()));
            tilt = std::max(tilt, plain[i].tilt_rad());
        }
        EXPECT_LT(most, difference) << points << " " << angle;
        EXPECT_GT(tilt, 0.03);
        RecordProperty("difference_" + std::to_string(points) + "_" + std::to_string(angle),
                       std::to_string(most * 1e9));
    }
}

}  // namespace
}  // namespace overturn
