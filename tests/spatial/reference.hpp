/// The same equations written down plainly: one body, doubles, vectors and matrices of Eigen, the quaternion's own rate
/// integrated and angular momentum about the body's axes. Shares no line with the kernel.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spatial/spatial_motion.hpp"

namespace overturn::testing {

class PlainBody {
  public:
    struct State {
        Eigen::Vector3d place{0, 0, 0}, velocity{0, 0, 0}, momentum{0, 0, 0};
        Eigen::Vector4d turn{1, 0, 0, 0};  // w, x, y, z
    };

    explicit PlainBody(SpatialBlock const& block) : block_(block) {
        state.place.z() = block.planar.centre_height_m - block.planar.settlement_m();
        double const w = block.planar.vertical_radps();
        for (auto const& point : block.points) {
            points_.push_back({{point.x_m, point.y_m, -block.planar.centre_height_m},
                               point.stiffness_share * w * w,
                               0,
                               block.planar.approach_floor_mps(),
                               {point.x_m, point.y_m}});
        }
    }

    /// \param shaking acceleration of the ground at a time
    template <class Shaking> void step(double time_s, double h, Shaking const& shaking) {
        remember();
        auto const rate = [&](State const& at, double later) { return rate_of(at, shaking(time_s + later)); };
        State const a = rate(state, 0);
        State const b = rate(moved(state, a, h / 2), h / 2);
        State const c = rate(moved(state, b, h / 2), h / 2);
        State const d = rate(moved(state, c, h), h);
        state.place += h / 6 * (a.place + 2 * b.place + 2 * c.place + d.place);
        state.velocity += h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity);
        state.momentum += h / 6 * (a.momentum + 2 * b.momentum + 2 * c.momentum + d.momentum);
        state.turn += h / 6 * (a.turn + 2 * b.turn + 2 * c.turn + d.turn);
        state.turn.normalize();
    }

    State state;

  private:
    struct Point {
        Eigen::Vector3d arm;
        double stiffness, crush, approach;
        Eigen::Vector2d anchor;
    };
    struct Touch {
        Eigen::Vector3d place, velocity;
        double depth, normal;  // over the stiffness
    };

    static Eigen::Matrix3d matrix(State const& at) {
        return Eigen::Quaterniond(at.turn[0], at.turn[1], at.turn[2], at.turn[3]).normalized().toRotationMatrix();
    }
    static State moved(State at, State const& rate, double time) {
        at.place += time * rate.place;
        at.velocity += time * rate.velocity;
        at.momentum += time * rate.momentum;
        at.turn = (at.turn + time * rate.turn).normalized();
        return at;
    }
    [[nodiscard]] Eigen::Vector3d spin(State const& at) const {
        auto const& i = block_.inertia_over_mass_m2;
        return {at.momentum.x() / i[0], at.momentum.y() / i[1], at.momentum.z() / i[2]};
    }
    [[nodiscard]] Touch touch(State const& at, Point const& point) const {
        Eigen::Matrix3d const turn = matrix(at);
        Eigen::Vector3d const arm = turn * point.arm;
        Eigen::Vector3d const velocity = at.velocity + (turn * spin(at)).cross(arm);
        Touch now{at.place + arm, velocity, 0, 0};
        now.depth = -now.place.z() - point.crush;
        if (now.depth > 0) {
            double const y = normal_damping(block_.planar.pad.normal_restitution);
            double const elastic = std::min(now.depth, block_.planar.yield_depth_m);
            double const damping = std::min(y * elastic / point.approach, y / block_.planar.vertical_radps());
            now.normal = std::max(0.0, elastic - damping * velocity.z());
        }
        return now;
    }
    void remember() {
        for (auto& point : points_) {
            auto const now = touch(state, point);
            if (now.depth <= 0) {
                point.approach = std::max(-now.velocity.z(), block_.planar.approach_floor_mps());
            }
            point.crush += std::max(0.0, now.depth - block_.planar.yield_depth_m);
            Eigen::Vector2d const shift = now.place.head<2>() - point.anchor;
            double const most = block_.planar.friction * now.normal / block_.planar.pad.tangential_ratio;
            if (shift.norm() > most) {
                point.anchor = now.place.head<2>() - shift * (most / shift.norm());
            }
        }
    }
    [[nodiscard]] State rate_of(State const& at, std::array<double, 3> const& ground) const {
        auto const& pad = block_.planar.pad;
        double const drag =
            2 * pad.tangential_damping * std::sqrt(pad.tangential_ratio) / block_.planar.vertical_radps();
        Eigen::Vector3d force(0, 0, 0);
        Eigen::Vector3d torque(0, 0, 0);
        for (auto const& point : points_) {
            auto const now = touch(at, point);
            Eigen::Vector2d grip =
                -pad.tangential_ratio * (now.place.head<2>() - point.anchor) - drag * now.velocity.head<2>();
            double const limit = block_.planar.friction * now.normal;
            if (grip.norm() > limit) {
                grip *= limit / grip.norm();
            }
            Eigen::Vector3d const of_point = point.stiffness * Eigen::Vector3d(grip.x(), grip.y(), now.normal);
            force += of_point;
            torque += (now.place - at.place).cross(of_point);
        }
        State rate;
        Eigen::Vector3d const w = spin(at);
        rate.place = at.velocity;
        rate.velocity = force - Eigen::Vector3d(ground[0], ground[1], block_.planar.gravity_mps2 + ground[2]);
        rate.momentum = matrix(at).transpose() * torque - w.cross(at.momentum);
        auto const& q = at.turn;
        rate.turn = 0.5
                    * Eigen::Vector4d(-q[1] * w[0] - q[2] * w[1] - q[3] * w[2], q[0] * w[0] + q[2] * w[2] - q[3] * w[1],
                                      q[0] * w[1] + q[3] * w[0] - q[1] * w[2], q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
        return rate;
    }

    SpatialBlock const& block_;
    std::vector<Point> points_;
};

}  // namespace overturn::testing
