/// The same equations written down plainly: one body, doubles, vectors and matrices of Eigen, the quaternion's own rate
/// integrated and angular momentum about the body's axes. Shares no line with the kernel. A rim is summed over its
/// Gauss nodes for its damping, or over as many midpoints as are wanted.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact/detail/rim_law.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn::testing {

class PlainBody {
  public:
    struct State {
        Eigen::Vector3d place{0, 0, 0}, velocity{0, 0, 0}, momentum{0, 0, 0};
        Eigen::Vector4d turn{1, 0, 0, 0};  // w, x, y, z
        Eigen::Vector3d shear{0, 0, 0};    // of a rim's springs
    };

    /// \param midpoints of an arc's damping; 0: the kernel's nodes
    explicit PlainBody(SpatialBlock const& block, int midpoints = 0) : block_(block), midpoints_(midpoints) {
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
        state.shear += h / 6 * (a.shear + 2 * b.shear + 2 * c.shear + d.shear);
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
        at.shear += time * rate.shear;
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
            double const elastic = std::min(now.depth, block_.planar.yield_depth_m);
            if (block_.planar.of_rim) {
                double const root = std::hypot(velocity.z(), block_.planar.vertical_radps() * elastic);
                now.normal = elastic * std::max(0.0, 1 - rim_damping_ * velocity.z() / root);
                return now;
            }
            double const y = normal_damping(block_.planar.pad.normal_restitution);
            double const damping = std::min(y * elastic / point.approach, y / block_.planar.vertical_radps());
            now.normal = std::max(0.0, elastic - damping * velocity.z());
        }
        return now;
    }
    struct Rim {
        double press = 0;
        Eigen::Vector3d torque{0, 0, 0};  // of the normal forces
        Eigen::Vector3d centre{0, 0, 0};  // where it grips, from the centre of gravity
        double gyration = 0;
    };
    [[nodiscard]] Rim rim(State const& at) const {
        double const r = block_.edge_m;
        double const w = block_.planar.vertical_radps();
        double const y = rim_damping_;
        Eigen::Matrix3d const turn = matrix(at);
        Eigen::Vector3d const axis = turn.col(2);
        Eigen::Vector3d const omega = turn * spin(at);
        double const lean = std::hypot(axis.x(), axis.y());
        Eigen::Vector3d d(axis.z() * axis.x(), axis.z() * axis.y(), -lean * lean);
        if (d.norm() == 0) {
            d = -axis.cross(omega);  // the way in which it begins to lean
        }
        d = d.norm() > 0 ? Eigen::Vector3d(d.normalized()) : Eigen::Vector3d(turn.col(0));
        Eigen::Vector3d const n = axis.cross(d);
        double const h0 = -(at.place - block_.planar.centre_height_m * axis).z();
        double const h1 = r * lean;
        double const arc = h0 >= h1 ? pi : h0 <= -h1 ? 0 : 2 * std::atan2(std::sqrt(h1 + h0), std::sqrt(h1 - h0));
        double const k = w * w / (2 * pi);
        Rim sum;
        auto const element = [&](double phi, double force) {
            Eigen::Vector3d const arm =
                r * (std::cos(phi) * d + std::sin(phi) * n) - block_.planar.centre_height_m * axis;
            sum.press += force;
            sum.torque += arm.cross(Eigen::Vector3d(0, 0, force));
        };
        auto const damped = [&](double phi, double share) {
            Eigen::Vector3d const arm =
                r * (std::cos(phi) * d + std::sin(phi) * n) - block_.planar.centre_height_m * axis;
            double const depth = std::max(0.0, h0 + h1 * std::cos(phi));
            double const rate = -(at.velocity + omega.cross(arm)).z();
            double const root = std::hypot(rate, w * depth);
            element(phi, root > 0 ? share * std::max(-depth, y * depth * rate / root) : 0);
        };
        // Elastic: its sum and its first moment, as two forces at the ends of a diameter.
        double const all = 2 * k * (h0 * arc + h1 * std::sin(arc));
        double const first = 2 * k * (h0 * std::sin(arc) + h1 * (arc + std::sin(arc) * std::cos(arc)) / 2);
        element(0, (all + first) / 2);
        element(pi, (all - first) / 2);
        constexpr std::array places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
        constexpr std::array weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
        int const count = midpoints_ > 0 ? midpoints_ : h0 >= h1 ? 8 : 0;
        for (int i = 0; i < count; ++i) {
            damped(arc * ((2 * i + 1.0) / count - 1), k * 2 * arc / count);
        }
        for (std::size_t i = 0; count == 0 && i < places.size(); ++i) {
            damped(arc * places[i], k * arc * weights[i]);
            damped(-arc * places[i], k * arc * weights[i]);
        }
        sum.press = std::max(0.0, sum.press);
        double const inner = all > 0 ? std::clamp(first / all, std::cos(arc), 1.0) : 1;
        sum.centre = r * inner * d - block_.planar.centre_height_m * axis;
        sum.gyration = r * std::sqrt(1 - inner * inner);
        return sum;
    }
    [[nodiscard]] State rim_rate(State const& at, Eigen::Vector3d& force, Eigen::Vector3d& torque) const {
        auto const& pad = block_.planar.pad;
        double const w = block_.planar.vertical_radps();
        auto const now = rim(at);
        Eigen::Vector3d const omega = matrix(at) * spin(at);
        Eigen::Vector3d const slide = at.velocity + omega.cross(now.centre);
        State rate;
        rate.shear = {slide.x(), slide.y(), now.gyration * omega.z()};
        Eigen::Vector3d grip = -pad.tangential_ratio * w * w * at.shear
                               - 2 * pad.tangential_damping * std::sqrt(pad.tangential_ratio) * w * rate.shear;
        double const limit = block_.planar.friction * now.press;
        grip *= grip.norm() > limit ? limit / grip.norm() : 1;
        force = {grip.x(), grip.y(), now.press};
        torque = now.torque + now.centre.cross(Eigen::Vector3d(grip.x(), grip.y(), 0))
                 + Eigen::Vector3d(0, 0, now.gyration * grip.z());
        return rate;
    }
    void remember() {
        if (block_.rim) {
            double const w = block_.planar.vertical_radps();
            double const most =
                block_.planar.friction * rim(state).press / (block_.planar.pad.tangential_ratio * w * w);
            state.shear *= state.shear.norm() > most ? most / state.shear.norm() : 1;
        }
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
        if (block_.rim) {
            rate = rim_rate(at, force, torque);
        }
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
    double rim_damping_ = rim_damping(block_.planar.pad.normal_restitution);
    int midpoints_;
    std::vector<Point> points_;
};

}  // namespace overturn::testing
