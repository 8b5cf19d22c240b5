/// Bodies on compliant points in space, stepped in SIMD lanes of any mixture of trials up to the first instant that
/// needs care. One arithmetic serves one lane and many: whatever the machine's vectors, the bits are the same.
#pragma once

#include <cstdint>
#include <tuple>

#include "simd/point_lanes.hpp"
#include "spatial/spatial_block.hpp"

namespace overturn::spatial {

/// Fields of the body in a lane. SI, forces over the mass, as accelerations. x and y horizontal, z up; the quaternion q
/// turns the body's axes to those of space.
enum class State : int {
    // state
    x,  ///< of the centre of gravity
    y,
    rise,  ///< z - h; -g/w_v^2 in rest
    qw,
    qx,
    qy,
    qz,
    vx,
    vy,
    vz,
    wx,  ///< angular velocity about the body's own axes
    wy,
    wz,
    shear_x,      ///< of a rim's springs, as friction holds it
    shear_y,      ///< likewise
    shear_twist,  ///< about the vertical, times the arc's radius of gyration
    // place in the wave
    index,    ///< of the sample
    substep,  ///< since that sample
    ax,
    ax_change,  ///< to the next sample
    ay,
    ay_change,
    az,
    az_change,
    // log
    most_tilt,  ///< as the squared sine of half the tilt
    tilt_time,
    force,  ///< sum of the normal forces at the start of the last step
    least_force,
    most_force,
    most_rise,
    most_lift,    ///< height of the centre of gravity above the lowest point, less h
    most_energy,  ///< of rocking, over m g R
    most_slip,    ///< squared
    slip_path,    ///< that it has travelled
    base_x,       ///< place of the base when slip was last checked
    base_y,       ///< likewise
    most_x,       ///< farthest that the circle round the base reached
    least_x,      ///< likewise
    most_y,       ///< likewise
    least_y,      ///< likewise
    most_top,     ///< way of the top in plan, squared
    turns,        ///< whole turns of yaw
    most_yaw,     ///< largest |yaw_measure|
    uplift_time,  ///< negative: not yet
    loss_time,    ///< likewise
    impacts,
    most_spin,  ///< fastest tilting at an impact, squared
    lean_x,     ///< direction of the last tilt that was more than the springs' own
    lean_y,     ///< likewise
    steps,
    // trial
    step,
    substeps,  ///< of a sample
    inverse_substeps,
    time_step,  ///< of the samples
    origin,     ///< time of sample 0
    last,       ///< index of the last sample
    x_scale,
    y_scale,  ///< 0: without transverse motion
    z_scale,  ///< 0: without vertical motion
    gravity,
    height,     ///< h
    edge,       ///< from the axis to the nearest edge; of a rim its radius
    reach,      ///< from the axis to the farthest point
    stiffness,  ///< w_v^2: k / m of all the base
    ring,       ///< of a rim w_v^2 / pi; of a disc or ring w_v^2 over its area
    hole,       ///< inner radius of a ring over its outer one
    hole_arc,   ///< angle whose cosine that is
    inertia_x,  ///< I / m, about the body's own axes
    inertia_y,
    inertia_z,
    mass_over_inertia_x,
    mass_over_inertia_y,
    mass_over_inertia_z,
    friction,            ///< mu
    hold,                ///< mu k / k_t: largest elastic shift of a point, over its normal force / stiffness
    tangential_ratio,    ///< k_t / k
    tangential_damping,  ///< c_t / k
    damping,             ///< y: of the normal law
    most_damping,        ///< y / w_v: cap of c / k
    least_approach,      ///< v_min = g / w_v
    inverse_p,           ///< 1 / p of the rigid body
    inverse_radius,      ///< 1 / R
    impact_spin,         ///< slower reversals of the tilt are no impacts
    least_lean,          ///< sine of a tilt that springs have at rest
    upright,             ///< sine of a tilt above which nothing rests, squared
    quiet_energy,        ///< negative: the body is never held at rest
    flexibility,         ///< m / k_t: turns a squared unbalanced acceleration into energy over the mass
    rest_ratio,          ///< |a| / gv up to which a quiet body is held at rest
    count
};

/// Fields of each point of the base in a lane.
enum class Spot : int {
    x,  ///< from the body's axis, along the body's own
    y,
    stiffness,  ///< k / m
    yield,      ///< depth at which the pad yields; infinite: never
    crush,      ///< q: depth that the pad remembers
    gain,       ///< y / v: v the approach speed at the last touch
    anchor_x,   ///< p: where it holds the ground
    anchor_y,
    count
};

enum class Wave : int { x, y, z, count };

/// Kind of a base for the arithmetic: bodies step side by side on bases of one kind.
struct BaseKind {
    int points = 0;        ///< none: a continuous base
    bool opposite = true;  ///< whether the points of every pair are opposite ones
    bool disc = false;     ///< whether a continuous base bears within its rim
    bool of_rim = false;   ///< whether points damp as elements of a rim

    [[nodiscard]] bool operator<(BaseKind const& other) const {
        return std::tie(points, opposite, disc, of_rim)
               < std::tie(other.points, other.opposite, other.disc, other.of_rim);
    }
};
[[nodiscard]] BaseKind kind_of(SpatialBlock const& block);

template <int Lanes> struct SpatialLanes : simd::PointLanes<State, Wave, Spot, most_spatial_points, Lanes> {
    bool opposite = true;  ///< BaseKind::opposite of all lanes
    bool disc = false;     ///< BaseKind::disc of all lanes
    bool of_rim = false;   ///< BaseKind::of_rim of all lanes

    template <int From> void take_lane(SpatialLanes<From> const& from, int from_lane, int to_lane) {
        simd::PointLanes<State, Wave, Spot, most_spatial_points, Lanes>::take_lane(from, from_lane, to_lane);
        opposite = from.opposite;
        disc = from.disc;
        of_rim = from.of_rim;
    }
};

/// Steps the first `used` lanes, all or half of step_width(), until at least one needs care: its wave has ended, it may
/// rest, or the tilt has reached pi/2. \return one bit per such lane
[[nodiscard]] std::uint32_t step_on(SpatialLanes<simd::most_lanes>& lanes, int used);
/// Steps one lane until it needs care.
void step_on(SpatialLanes<1>& lane);
/// One step of one lane. \return whether it now needs care
[[nodiscard]] bool step_once(SpatialLanes<1>& lane);
/// Lanes that this machine steps at once.
[[nodiscard]] int step_width();

}  // namespace overturn::spatial
