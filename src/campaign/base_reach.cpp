#include "campaign/base_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"

namespace overturn {
namespace {

// In the order of Sides.
constexpr std::array<double, Sides::count> side_angles_rad{0, pi, pi / 2, -pi / 2};

}  // namespace

BaseReach::BaseReach(BodySpec const& body) : farthest_m_(body.body.half_width_m()) {
    auto corners = body.footing.base.corners_m;
    if (body.footing.base.shape == BaseShape::square) {
        double const b = body.body.half_width_m();
        corners = {{b, b}, {-b, b}, {-b, -b}, {b, -b}};
    }
    for (auto const& [x, y] : corners) {
        corners_.push_back({std::hypot(x, y), std::atan2(y, x)});
    }
    if (!corners_.empty()) {
        farthest_m_ = std::ranges::max(corners_, {}, &Corner::far_m).far_m;
    }
}

double BaseReach::within_m(std::size_t side, double turn_rad) const {
    if (corners_.empty()) {
        return farthest_m_;
    }
    double most = 0;
    for (auto const& corner : corners_) {
        double const apart = std::abs(corner.angle_rad - side_angles_rad.at(side));
        double const away = std::min(apart, 2 * pi - apart);
        most = std::max(most, corner.far_m * std::cos(std::max(0.0, away - turn_rad)));
    }
    return most;
}

// Of a tilt the plan shortens what lies along the azimuth by its cosine.
double BaseReach::posed_m(std::size_t side, Pose const& pose) const {
    double const towards = pose.azimuth_rad - side_angles_rad.at(side);
    double const versine = 1 - std::cos(pose.tilt_rad);
    if (corners_.empty()) {
        return farthest_m_ * std::sqrt(1 - std::pow(std::sin(pose.tilt_rad) * std::cos(towards), 2));
    }
    double most = -std::numeric_limits<double>::infinity();
    for (auto const& corner : corners_) {
        double const angle = corner.angle_rad + pose.yaw_rad;
        double const along = std::cos(angle - pose.azimuth_rad);
        most = std::max(
            most, corner.far_m * (std::cos(angle - side_angles_rad.at(side)) - versine * along * std::cos(towards)));
    }
    return most;
}

}  // namespace overturn
