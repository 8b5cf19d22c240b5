/// Bodies pressing on compliant points, stepped in SIMD lanes of any mixture of trials up to the first instant that
/// needs care. One arithmetic serves one lane and many: whatever the machine's vectors, the bits are the same.
#pragma once

#include <cstdint>

#include "body/footing.hpp"
#include "simd/point_lanes.hpp"

namespace overturn::contact {

/// Fields of the body in a lane. SI; forces over the mass, as accelerations.
enum class ContactField : int {
    // state
    sway,      ///< x of the centre of gravity
    rise,      ///< z - h; -g/w_v^2 in rest
    rotation,  ///< theta
    sine,      ///< of theta, carried by rotation
    cosine,
    sway_speed,
    rise_speed,
    spin,  ///< theta'
    // place in the wave
    index,    ///< of the sample
    substep,  ///< since that sample
    horizontal,
    horizontal_change,  ///< to the next sample
    vertical,
    vertical_change,
    // log
    crest,  ///< largest theta
    crest_time,
    trough,  ///< smallest theta
    trough_time,
    force,  ///< sum of the normal forces at the start of the last step
    least_force,
    most_force,
    most_rise,
    most_slip,
    most_x,       ///< farthest that either corner of the base reached
    least_x,      ///< likewise
    most_top,     ///< way of the top, at twice h
    most_energy,  ///< of rocking, over m g R
    uplift_time,  ///< negative: not yet
    loss_time,    ///< likewise
    impacts,
    most_spin,  ///< fastest at an impact
    side,       ///< sign of theta when it last passed zero
    steps,
    // trial
    step,
    substeps,  ///< of a sample
    inverse_substeps,
    time_step,  ///< of the samples
    origin,     ///< time of sample 0
    last,       ///< index of the last sample
    horizontal_scale,
    vertical_scale,  ///< 0: without vertical motion
    gravity,
    height,              ///< h
    half_width,          ///< b
    stiffness,           ///< w_v^2: k / m of all the base
    mass_over_inertia,   ///< m / I_G
    friction,            ///< mu
    hold,                ///< mu k / k_t: largest elastic shift of a point, over its normal force / stiffness
    tangential_ratio,    ///< k_t / k
    tangential_damping,  ///< c_t / k
    damping,             ///< y: of the normal law
    most_damping,        ///< y / w_v: cap of c / k
    least_approach,      ///< v_min = g / w_v
    inverse_p,           ///< 1 / p of the rigid body
    sine_alpha,          ///< of the critical angle
    cosine_alpha,        ///< likewise
    impact_spin,         ///< slower passages of theta through zero are no impacts
    quiet_energy,        ///< negative: the body is never held at rest
    inertia,             ///< I_G / m
    flexibility,         ///< m / k_t: turns a squared unbalanced acceleration into energy over the mass
    rest_ratio,          ///< |a| / gv up to which a quiet body is held at rest
    count
};

/// Fields of each point of the base in a lane.
enum class Spot : int {
    offset,     ///< X, from the body's axis
    stiffness,  ///< k / m
    lever,      ///< X k / m
    yield,      ///< depth at which the pad yields; infinite: never
    crush,      ///< q: depth that the pad remembers
    gain,       ///< y / v: v the approach speed at the last touch
    anchor,     ///< p: where it holds the ground
    count
};

enum class ContactWave : int { horizontal, vertical, count };

/// Points of a base at most.
inline constexpr int most_points = BasePlan::most_points_across;

template <int Lanes> struct ContactLanes : simd::PointLanes<ContactField, ContactWave, Spot, most_points, Lanes> {
    bool of_rim = false;  ///< ContactBlock::of_rim of all lanes

    template <int From> void take_lane(ContactLanes<From> const& from, int from_lane, int to_lane) {
        simd::PointLanes<ContactField, ContactWave, Spot, most_points, Lanes>::take_lane(from, from_lane, to_lane);
        of_rim = from.of_rim;
    }
};

/// Steps the first `used` lanes, all or half of lane_width(), until at least one needs care: its wave has ended, it
/// may rest, or |theta| has reached pi/2. \return one bit per such lane
[[nodiscard]] std::uint32_t step_lanes(ContactLanes<simd::most_lanes>& lanes, int used);
/// Steps one lane until it needs care.
void step_lanes(ContactLanes<1>& lane);
/// One step of one lane. \return whether it now needs care
[[nodiscard]] bool step_lane_once(ContactLanes<1>& lane);
/// Lanes that this machine steps at once.
[[nodiscard]] int lane_width();

}  // namespace overturn::contact
