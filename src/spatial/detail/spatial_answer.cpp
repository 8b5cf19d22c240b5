#include <algorithm>
#include <cmath>

#include "spatial/detail/spatial_run.hpp"

namespace overturn::spatial {
namespace {

// The angle of a yaw as lanes keep it: whole turns, and z / (|w| + |z|) / 2 for the rest, which grows with the angle
// and needs no arc tangent.
double yaw_of(double measure) {
    double const turns = std::round(measure);
    double const rest = 2 * (measure - turns);
    return 2 * std::atan2(rest, 1 - std::abs(rest)) + 2 * pi * turns;
}

}  // namespace

double SpatialRun::half_tilt_sine2() const { return get(State::qx) * get(State::qx) + get(State::qy) * get(State::qy); }

// Rows of the matrix from the body's axes to those of space.
std::array<double, 9> SpatialRun::rotation() const {
    double const w = get(State::qw);
    double const x = get(State::qx);
    double const y = get(State::qy);
    double const z = get(State::qz);
    return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
            2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
            2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
}

std::array<double, 2> SpatialRun::base_centre() const {
    auto const r = rotation();
    double const h = planar_.centre_height_m;
    return {get(State::x) - h * r[2], get(State::y) - h * r[5]};
}

SpatialRun::Placed SpatialRun::placed(int point) const {
    auto const r = rotation();
    double const x = lane_.at(Spot::x, point, 0);
    double const y = lane_.at(Spot::y, point, 0);
    double const height = r[6] * x + r[7] * y;
    double const base = get(State::rise) + 2 * planar_.centre_height_m * half_tilt_sine2();
    return {r[0] * x + r[1] * y, r[3] * x + r[4] * y, height, lane_.at(Spot::stiffness, point, 0),
            -(base + height) - lane_.at(Spot::crush, point, 0)};
}

SpatialInstant SpatialRun::instant() const {
    auto const [x, y] = base_centre();
    double const w = get(State::qw);
    double const yaw = 2 * std::atan(get(State::qz) / w) + 2 * pi * get(State::turns);
    return {.time_s = time_s(),
            .x_m = x,
            .y_m = y,
            .rise_m = get(State::rise),
            .quaternion = {w, get(State::qx), get(State::qy), get(State::qz)},
            .velocity_mps = {get(State::vx), get(State::vy), get(State::vz)},
            .angular_radps = {get(State::wx), get(State::wy), get(State::wz)},
            .contact_force_ratio = get(State::force) / planar_.gravity_mps2,
            .yaw_rad = yaw,
            .crush_m = deepest_crush(),
            .energy_jpkg = mechanical_energy()};
}

SpatialRun::RimDepth SpatialRun::rim_depth(double radius_m) const {
    auto const r = rotation();
    double const slope = std::hypot(r[2], r[5]);
    double const middle = -(get(State::rise) + 2 * planar_.centre_height_m * half_tilt_sine2());
    double const change = radius_m * slope;
    double const share = change > 0 ? (middle + change) / (2 * change) : middle > 0 ? 1 : 0;
    double const square = std::clamp(share, 0.0, 1.0);  // sine of half the arc, squared
    return {middle,
            change,
            2 * std::asin(std::sqrt(square)),
            2 * std::sqrt(square * (1 - square)),
            1 - 2 * square,
            slope > 0 ? std::array{r[2] / slope, r[5] / slope} : std::array{1.0, 0.0}};
}

// Of springs, over the mass.
double SpatialRun::spring_energy() const {
    auto const square = [&](State field) { return get(field) * get(field); };
    if (block_.inner_m) {
        // Over what touches: half the square of the depth, and the depth.
        auto const [middle, change, p, s, c, towards] = rim_depth(block_.edge_m);
        auto const [k, x, xx, yy] = touching_moments();
        double const slope = change / block_.edge_m;
        double const hold = get(State::hold) * std::max(0.0, middle * k + slope * x) / get(State::stiffness);
        double const shear =
            std::min(hold * hold, square(State::shear_x) + square(State::shear_y) + square(State::shear_twist));
        return 0.5
               * (middle * middle * k + 2 * middle * slope * x + slope * slope * xx
                  + get(State::stiffness) * planar_.pad.tangential_ratio * shear);
    }
    if (block_.rim) {
        auto const rim = rim_depth(block_.edge_m);
        double const deep = rim.middle * rim.middle * rim.arc + 2 * rim.middle * rim.change * rim.sine
                            + rim.change * rim.change * (rim.arc + rim.sine * rim.cosine) / 2;
        // The step that comes cuts them back to what friction holds of this force.
        double const hold = get(State::hold) * std::max(0.0, rim.middle * rim.arc + rim.change * rim.sine) / pi;
        double const shear =
            std::min(hold * hold, square(State::shear_x) + square(State::shear_y) + square(State::shear_twist));
        return get(State::stiffness) * (deep / (2 * pi) + 0.5 * planar_.pad.tangential_ratio * shear);
    }
    auto const [centre_x, centre_y] = base_centre();
    double springs = 0;
    for (int i = 0; i < lane_.points; ++i) {
        auto const point = placed(i);
        if (point.depth > 0) {
            double const x = centre_x + point.x - lane_.at(Spot::anchor_x, i, 0);
            double const y = centre_y + point.y - lane_.at(Spot::anchor_y, i, 0);
            springs +=
                0.5 * point.stiffness * (point.depth * point.depth + planar_.pad.tangential_ratio * (x * x + y * y));
        }
    }
    return springs;
}

// Kinetic, of position and of springs, over the mass; none in settled rest.
double SpatialRun::mechanical_energy() const {
    auto const square = [&](State field) { return get(field) * get(field); };
    auto const& inertia = block_.inertia_over_mass_m2;
    double const moving = square(State::vx) + square(State::vy) + square(State::vz) + inertia[0] * square(State::wx)
                          + inertia[1] * square(State::wy) + inertia[2] * square(State::wz);
    return 0.5 * moving + spring_energy() + planar_.gravity_mps2 * (get(State::rise) + 0.5 * planar_.settlement_m());
}

// Whether the base's centre or, by yaw, its farthest point has moved farther than springs stretch whose points hold.
bool SpatialRun::slipped() const {
    return std::sqrt(get(State::most_slip)) + block_.reach_m * yaw_of(get(State::most_yaw)) > elastic_way();
}

bool SpatialRun::sound() const {
    double sum = 0;
    for (auto const field : {State::x, State::y, State::rise, State::qw, State::qx, State::qy, State::qz, State::vx,
                             State::vy, State::vz, State::wx, State::wy, State::wz}) {
        sum += get(field);
    }
    return std::isfinite(sum);
}

// What can be read off the lane as it is: extremes, counts, and where the body ended.
void SpatialRun::fill_peaks(SpatialOutcome& out) const {
    double const g = planar_.gravity_mps2;
    double const radius = std::hypot(planar_.half_width_m, planar_.centre_height_m);
    double const lift = std::max(0.0, get(State::most_lift));
    out.impacts = static_cast<std::int64_t>(get(State::impacts));
    out.peak_impact_velocity_mps = 2 * planar_.half_width_m * std::sqrt(get(State::most_spin));
    out.steps = static_cast<std::int64_t>(get(State::steps));
    out.friction_demand = out.friction_work_jpkg = never;
    out.min_contact_force_ratio = out.steps > 0 ? get(State::least_force) / g : 1;
    out.peak_energy_ratio = get(State::most_energy) * radius / (radius - planar_.centre_height_m);
    out.response_velocity_mps = std::sqrt(2 * g * lift);
    out.residual_m = base_centre();
    auto const r = rotation();
    double const lifted = block_.edge_m * std::hypot(r[2], r[5]) / (1 + std::abs(r[8]));
    out.residual_slip_m = std::hypot(out.residual_m[0] - lifted * r[2], out.residual_m[1] - lifted * r[5]);
    out.peak_slip_m = std::sqrt(get(State::most_slip));
    // The last step's end has no step that would have recorded it.
    auto const reach = [&](double slope) { return block_.reach_m * std::sqrt(std::max(1 - slope * slope, 0.0)); };
    double const h = planar_.centre_height_m;
    double const top = std::hypot(get(State::x) + h * r[2], get(State::y) + h * r[5]);
    out.end_velocity_mps = {get(State::vx), get(State::vy), get(State::vz)};
    out.extra = {.peak_crush_m = deepest_crush(),
                 .peak_contact_force_ratio = std::max(1.0, get(State::most_force) / g),
                 .peak_rise_m = get(State::most_rise) + planar_.settlement_m(),
                 .yaw_rad = instant().yaw_rad,
                 .peak_yaw_rad = yaw_of(get(State::most_yaw)),
                 .slip_path_m = get(State::slip_path),
                 .residual_x_m = out.residual_m[0],
                 .residual_y_m = out.residual_m[1],
                 .edge_x_most_m = std::max(get(State::most_x), out.residual_m[0] + reach(r[2])),
                 .edge_x_least_m = std::min(get(State::least_x), out.residual_m[0] - reach(r[2])),
                 .edge_y_most_m = std::max(get(State::most_y), out.residual_m[1] + reach(r[5])),
                 .edge_y_least_m = std::min(get(State::least_y), out.residual_m[1] - reach(r[5])),
                 .peak_top_m = std::max(std::sqrt(get(State::most_top)), top)};
}

// As it is at the end of the first step beyond pi/2.
void SpatialRun::fill_landing(SpatialOutcome& out) const {
    auto const r = rotation();
    double const h = planar_.centre_height_m;
    std::array const spin{get(State::wx), get(State::wy), get(State::wz)};
    std::array const speed{get(State::vx), get(State::vy), get(State::vz)};
    auto const& inertia = block_.inertia_over_mass_m2;
    double velocity = 0;
    double top = 0;
    double energy = 0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        double const of_top = speed[i] + h * (r[3 * i] * spin[1] - r[3 * i + 1] * spin[0]);
        velocity += speed[i] * speed[i];
        top += of_top * of_top;
        energy += 0.5 * (speed[i] * speed[i] + inertia[i] * spin[i] * spin[i]);
    }
    out.landing_spin_radps = std::hypot(spin[0], spin[1]);
    out.landing_velocity_mps = std::sqrt(velocity);
    out.landing_top_mps = std::sqrt(top);
    out.landing_energy_jpkg = energy;
    out.extra.landing_azimuth_rad = std::atan2(r[5], r[2]);
}

void SpatialRun::fill_verdict(SpatialOutcome& out) const {
    bool const fell = half_tilt_sine2() >= 0.5;
    out.peak_rotation_rad = fell ? pi / 2 : 2 * std::asin(std::sqrt(get(State::most_tilt)));
    out.peak_rotation_ratio = out.peak_rotation_rad / std::atan2(planar_.half_width_m, planar_.centre_height_m);
    if (fell) {
        out.overturn_time_s = out.time_of_peak_s = instant().time_s;
        fill_landing(out);
    } else if (out.peak_rotation_rad > 0) {
        out.time_of_peak_s = get(State::tilt_time);
    }
    out.verdict = fell                              ? Verdict::overturned
                  : !std::isnan(out.first_uplift_s) ? Verdict::rocked
                  : slipped()                       ? Verdict::slid
                                                    : Verdict::at_rest;
    if (!sound()) {
        out.verdict = Verdict::failed;
        out.failure = FailureReason::no_convergence;
    }
}

SpatialOutcome SpatialRun::finish() const {
    SpatialOutcome out;
    auto const since = [](double time) { return time < 0 ? never : time; };
    out.first_uplift_s = since(get(State::uplift_time));
    out.contact_lost_s = since(get(State::loss_time));
    fill_peaks(out);
    fill_verdict(out);
    return out;
}

}  // namespace overturn::spatial
