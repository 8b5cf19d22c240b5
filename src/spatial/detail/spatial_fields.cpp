#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/detail/spatial_run.hpp"

namespace overturn::spatial {

BaseKind kind_of(std::vector<SpatialPoint> const& points) {
    BaseKind kind{.points = static_cast<int>(points.size())};
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        auto const& one = points[i];
        auto const& other = points[i + 1];
        kind.opposite = kind.opposite && other.x_m == -one.x_m && other.y_m == -one.y_m;
    }
    return kind;
}

void SpatialRun::fill_trial(ContactAccuracy const& accuracy) {
    fill_steps(accuracy);
    fill_law();
    double const h = planar_.centre_height_m;
    double const w = planar_.vertical_radps();
    double const radius = std::hypot(planar_.half_width_m, h);
    double const lowest_sine = block_.edge_m / std::hypot(block_.edge_m, h);
    auto const& inertia = block_.inertia_over_mass_m2;
    put(State::gravity, planar_.gravity_mps2);
    put(State::height, h);
    put(State::edge, block_.edge_m);
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
    put(State::upright, 0.01 * lowest_sine * lowest_sine);
    put(State::quiet_energy, accuracy.rest_gate ? quiet_energy() : -1);
    put(State::flexibility, 1 / (planar_.pad.tangential_ratio * w * w));
    constexpr double margin = 0.75;  // for what swings beyond its static place
    put(State::rest_ratio, std::min(margin * parting_ratio(), 0.5 * planar_.friction));
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
    double const determinant = xx * yy - xy * xy;
    double steepest = 0;
    for (auto const& point : block_.points) {
        steepest = std::max(steepest, std::hypot(yy * point.x_m - xy * point.y_m, xx * point.y_m - xy * point.x_m));
    }
    return determinant / (steepest * planar_.centre_height_m);
}

// A whole number of steps per sample, and the samples.
void SpatialRun::fill_steps(ContactAccuracy const& accuracy) {
    double const y = normal_damping(planar_.pad.normal_restitution);
    static double const usual_damping = normal_damping(Pad{}.normal_restitution);
    longest_step_s_ =
        accuracy.step_ratio / planar_.vertical_radps() * std::min(1.0, usual_damping / std::max(y, usual_damping));
    constexpr double uniform_solid = 3;  // bodies that shiver quicker than these: their damping grows as the stiffness
    longest_step_s_ *= std::min(1.0, uniform_solid / block_.rotation_stiffness);
    run_out_s_ = accuracy.longest_after_s;
    double const dt = shaking_.time_step_s > 0 ? shaking_.time_step_s : longest_step_s_;
    constexpr double slack = 1e-9;  // a step that divides the sample is taken as it is
    double const substeps = std::max(1.0, std::ceil(dt / longest_step_s_ - slack));
    put(State::step, dt / substeps);
    put(State::substeps, substeps);
    put(State::inverse_substeps, 1 / substeps);
    put(State::time_step, dt);
    put(State::last, static_cast<double>(last_));
    auto const show = [&](Wave wave, State scale, std::span<double const> samples) {
        bool const there = !samples.empty();
        put(scale, there ? shaking_.scale : 0);
        lane_.body.at(wave, 0) = (there ? samples : shaking_.horizontal_mps2).data();
    };
    show(Wave::x, State::x_scale, shaking_.horizontal_mps2);
    show(Wave::y, State::y_scale, shaking_.transverse_mps2);
    show(Wave::z, State::z_scale, shaking_.vertical_mps2);
}

void SpatialRun::fill_law() {
    double const w = planar_.vertical_radps();
    double const y = normal_damping(planar_.pad.normal_restitution);
    auto const& pad = planar_.pad;
    put(State::friction, planar_.friction);
    put(State::hold, planar_.friction / pad.tangential_ratio);
    put(State::tangential_ratio, pad.tangential_ratio);
    put(State::tangential_damping, 2 * pad.tangential_damping * std::sqrt(pad.tangential_ratio) / w);
    put(State::damping, y);
    put(State::most_damping, y / w);
    put(State::least_approach, planar_.approach_floor_mps());
}

void SpatialRun::fill_points() {
    double const w = planar_.vertical_radps();
    for (int i = 0; i < lane_.points; ++i) {
        auto const& point = block_.points[static_cast<std::size_t>(i)];
        lane_.at(Spot::x, i, 0) = lane_.at(Spot::anchor_x, i, 0) = point.x_m;
        lane_.at(Spot::y, i, 0) = lane_.at(Spot::anchor_y, i, 0) = point.y_m;
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
    put(State::base_x, x);
    put(State::base_y, y);
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
