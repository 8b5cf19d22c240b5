#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/rest_gate.hpp"
#include "spatial/detail/spatial_run.hpp"

namespace overturn::spatial {

BaseKind kind_of(SpatialBlock const& block) {
    auto const& points = block.points;
    BaseKind kind{
        .points = static_cast<int>(points.size()), .disc = block.inner_m.has_value(), .of_rim = block.planar.of_rim};
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        auto const& one = points[i];
        auto const& other = points[i + 1];
        kind.opposite = kind.opposite && other.x_m == -one.x_m && other.y_m == -one.y_m;
    }
    return kind;
}

void SpatialRun::fill_trial(ContactAccuracy const& accuracy) {
    // Largest rotation_stiffness of uniform solids, for which the step is made. A body above it vibrates faster on its
    // points, and its damping grows as the stiffness itself: its step is shorter by the whole factor.
    constexpr double uniform_solid = 3;
    // Nothing touches and leaves a rim within a step: twice as long a one errs by 9e-4 of the peak in place of 8e-4,
    // which its eight nodes make (median of 16 waves; 2e-3 at 90 % either way).
    double const smooth = block_.rim ? 2 : 1;
    auto const& inertias = block_.inertia_over_mass_m2;
    fill_steps(accuracy, smooth * std::min(1.0, uniform_solid / block_.rotation_stiffness),
               std::min(inertias[0], inertias[1]));
    fill_law();
    fill_waves();
    double const h = planar_.centre_height_m;
    double const radius = std::hypot(planar_.half_width_m, h);
    double const lowest_sine = block_.edge_m / std::hypot(block_.edge_m, h);
    auto const& inertia = block_.inertia_over_mass_m2;
    put(State::edge, block_.edge_m);
    put(State::reach, block_.reach_m);
    put(State::inertia_x, inertia[0]);
    put(State::inertia_y, inertia[1]);
    put(State::inertia_z, inertia[2]);
    put(State::mass_over_inertia_x, 1 / inertia[0]);
    put(State::mass_over_inertia_y, 1 / inertia[1]);
    put(State::mass_over_inertia_z, 1 / inertia[2]);
    put(State::inverse_p, std::sqrt((inertia[1] + radius * radius) / (planar_.gravity_mps2 * radius)));
    put(State::inverse_radius, 1 / radius);
    put(State::impact_spin, planar_.approach_floor_mps() / planar_.half_width_m);
    put(State::least_lean, planar_.settlement_m() / block_.reach_m);
    put(State::upright, contact::upright_share_squared * lowest_sine * lowest_sine);
    put(State::quiet_energy, accuracy.rest_gate ? quiet_energy() : -1);
    put(State::rest_ratio,
        std::min(contact::parting_share * parting_ratio(), contact::friction_share * planar_.friction));
    put(State::least_force, std::numeric_limits<double>::infinity());
    put(State::uplift_time, -1);
    put(State::loss_time, -1);
}

// A push a leans the base by s = M^-1 h a / w_v^2, M the second moments of the shares; the point at P is lifted by s P,
// and off the ground where that is the settlement g / w_v^2.
double SpatialRun::parting_ratio() const {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (auto const& point : block_.points) {
        xx += point.stiffness_share * point.x_m * point.x_m;
        xy += point.stiffness_share * point.x_m * point.y_m;
        yy += point.stiffness_share * point.y_m * point.y_m;
    }
    if (block_.rim) {
        double const h = planar_.centre_height_m;
        return block_.inner_m ? block_.mean_square_m2() / (block_.edge_m * h) : block_.edge_m / (2 * h);
    }
    double const determinant = xx * yy - xy * xy;
    double steepest = 0;
    for (auto const& point : block_.points) {
        steepest = std::max(steepest, std::hypot(yy * point.x_m - xy * point.y_m, xx * point.y_m - xy * point.x_m));
    }
    return determinant / (steepest * planar_.centre_height_m);
}

void SpatialRun::fill_waves() {
    auto const show = [&](Wave wave, State scale, std::span<double const> samples) {
        bool const there = !samples.empty();
        put(scale, there ? shaking_.scale : 0);
        lane_.body.at(wave, 0) = (there ? samples : shaking_.horizontal_mps2).data();
    };
    show(Wave::x, State::x_scale, shaking_.horizontal_mps2);
    show(Wave::y, State::y_scale, shaking_.transverse_mps2);
    show(Wave::z, State::z_scale, shaking_.vertical_mps2);
}

void SpatialRun::fill_points() {
    double const w = planar_.vertical_radps();
    put(State::ring, w * w / pi);
    if (block_.inner_m) {
        double const hole = *block_.inner_m / block_.edge_m;
        put(State::hole, hole);
        put(State::hole_arc, std::acos(hole));
        put(State::ring, w * w / (pi * block_.edge_m * block_.edge_m * (1 - hole * hole)));
    }
    for (int i = 0; i < lane_.points; ++i) {
        auto const& point = block_.points[i];
        lane_.at(Spot::x, i, 0) = point.x_m;
        lane_.at(Spot::y, i, 0) = point.y_m;
        lane_.at(Spot::stiffness, i, 0) = point.stiffness_share * w * w;
        lane_.at(Spot::yield, i, 0) = planar_.yield_depth_m;
        lane_.at(Spot::gain, i, 0) = get(State::damping) / planar_.approach_floor_mps();
    }
}

void SpatialRun::place(SpatialStart const& start) {
    put(State::qw, 1);
    turn_by(start.rotation_rad);
    put(State::x, start.x_m);
    put(State::y, start.y_m);
    put(State::rise, start.rise_m - planar_.settlement_m());
    put(State::vx, start.velocity_mps[0]);
    put(State::vy, start.velocity_mps[1]);
    put(State::vz, start.velocity_mps[2]);
    put(State::wx, start.angular_velocity_radps[0]);
    put(State::wy, start.angular_velocity_radps[1]);
    put(State::wz, start.angular_velocity_radps[2]);
    put(State::most_tilt, half_tilt_sine2());
    put(State::most_rise, get(State::rise));
    auto const [x, y] = base_centre();
    for (int i = 0; i < lane_.points; ++i) {  // springs start unstretched
        auto const point = placed(i);
        lane_.at(Spot::anchor_x, i, 0) = x + point.x;
        lane_.at(Spot::anchor_y, i, 0) = y + point.y;
    }
    put(State::base_x, x);
    put(State::base_y, y);
    put(State::most_x, x + block_.reach_m);
    put(State::least_x, x - block_.reach_m);
    put(State::most_y, y + block_.reach_m);
    put(State::least_y, y - block_.reach_m);
}

// About axes of space.
void SpatialRun::turn_by(std::array<double, 3> const& rotation_rad) {
    auto const& [x, y, z] = rotation_rad;
    double const angle = std::sqrt(x * x + y * y + z * z);
    double const share = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
    std::array const p{std::cos(angle / 2), share * x, share * y, share * z};
    std::array const q{get(State::qw), get(State::qx), get(State::qy), get(State::qz)};
    put(State::qw, p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3]);
    put(State::qx, p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2]);
    put(State::qy, p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3]);
    put(State::qz, p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]);
}

}  // namespace overturn::spatial
