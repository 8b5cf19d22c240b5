// What a body in space is remembered by: the records that a step makes of the instant at which it starts. Included once
// per instruction set, so without a #pragma once; by spatial_kernel.cpp only.
#if defined(OVERTURN_SPATIAL_LOG) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_SPATIAL_LOG
#undef OVERTURN_SPATIAL_LOG
#else
#define OVERTURN_SPATIAL_LOG
#endif

#include <limits>
#include <numbers>

#include "spatial/detail/spatial_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

// Records of the instant at which the step starts: once begin has worked out the base there (log_place reads it), and
// before index and substep move on, which give its time.
template <class Force> void SpatialStepper<Force>::log(Motion const& at, Pull const& pull, Depths const& depths) {
    V const zero = 0;
    V const time =
        get(State::origin) + fma(get(State::index), get(State::time_step), get(State::substep) * get(State::step));
    put(State::force, pull.press);
    put(State::least_force, min(pull.press, get(State::least_force)));
    put(State::most_force, max(pull.press, get(State::most_force)));
    if (M const lost = (pull.press <= zero) & (get(State::loss_time) < zero); any(lost)) {
        put(State::loss_time, choose(lost, time, get(State::loss_time)));
    }
    log_height(at, depths, time);
    log_place(at, pull);
    put(State::steps, get(State::steps) + 1.0);
}

template <class Force>
OVERTURN_LANES_INLINE void SpatialStepper<Force>::log_height(Motion const& at, Depths const& depths, V time) {
    V const zero = 0;
    V const tilt = at.turn.x * at.turn.x + at.turn.y * at.turn.y;
    if (M const more = tilt > get(State::most_tilt); any(more)) {
        put(State::most_tilt, choose(more, tilt, get(State::most_tilt)));
        put(State::tilt_time, choose(more, time, get(State::tilt_time)));
    }
    if (M const parts = (depths.least <= zero) & (get(State::uplift_time) < zero); any(parts)) {
        put(State::uplift_time, choose(parts, time, get(State::uplift_time)));
    }
    V const lift = at.at.z + depths.most;
    V const pace = get(State::inverse_p);
    V const square = at.spin.x * at.spin.x + at.spin.y * at.spin.y;
    put(State::most_lift, max(lift, get(State::most_lift)));
    put(State::most_energy,
        max(fma(0.5 * pace * pace, square, lift * get(State::inverse_radius)), get(State::most_energy)));
    put(State::most_rise, max(at.at.z, get(State::most_rise)));
}

// Where the base is, how far it has travelled, how the body has turned about its axis, and which way it leans. The
// place is that of the edge that it leans over: leaning moves the base's centre, not that edge.
template <class Force> OVERTURN_LANES_INLINE void SpatialStepper<Force>::log_place(Motion const& at, Pull const& pull) {
    auto const axis = axes_of(at.turn).third;
    V const lifted = get(State::edge) * sqrt(axis.x * axis.x + axis.y * axis.y) / (1.0 + abs(axis.z));
    V const x = base_at_start().x.at - lifted * axis.x;
    V const y = base_at_start().y.at - lifted * axis.y;
    V const dx = x - get(State::base_x);
    V const dy = y - get(State::base_y);
    put(State::slip_path, get(State::slip_path) + sqrt(dx * dx + dy * dy));
    put(State::base_x, x);
    put(State::base_y, y);
    put(State::most_slip, max(x * x + y * y, get(State::most_slip)));
    log_reach(at, axis);
    V const zero = 0;
    V const z = choose(at.turn.w < zero, -at.turn.z, at.turn.z);
    V const yaw = fma(z / (abs(at.turn.w) + abs(at.turn.z)), 0.5, get(State::turns));
    put(State::most_yaw, max(abs(yaw), get(State::most_yaw)));
    log_reversal(at, pull, axis);
}

// How far the circle round the base reaches along x and y, and how far the top has gone in plan.
template <class Force>
OVERTURN_LANES_INLINE void SpatialStepper<Force>::log_reach(Motion const& at, Triple<V> const& axis) {
    V const reach = get(State::reach);
    auto const log_one = [&](State most, State least, V place, V slope) HWY_ATTR {
        V const far = reach * sqrt(max(1.0 - slope * slope, V(0)));
        put(most, max(place + far, get(most)));
        put(least, min(place - far, get(least)));
    };
    log_one(State::most_x, State::least_x, base_at_start().x.at, axis.x);
    log_one(State::most_y, State::least_y, base_at_start().y.at, axis.y);
    V const x = fma(get(State::height), axis.x, at.at.x);
    V const y = fma(get(State::height), axis.y, at.at.y);
    put(State::most_top, max(x * x + y * y, get(State::most_top)));
}

// Counts an impact where the lean turns to the other side (about one axis: where the angle passes zero) faster than
// impact_spin. The side is that of the last lean beyond what the springs give at rest and beyond what it covers in half
// a period of the vertical mode, in which an impact is over: a body that lands a little aside of upright has landed,
// one that rolls along its edge has not, whatever the step.
template <class Force>
OVERTURN_LANES_INLINE void SpatialStepper<Force>::log_reversal(Motion const& at, Pull const& pull,
                                                               Triple<V> const& axis) {
    V const zero = 0;
    V const lean = fma(axis.x, get(State::lean_x), axis.y * get(State::lean_y));
    M const passes = lean < zero;
    V const least = get(State::least_lean);
    V const tilt = axis.x * axis.x + axis.y * axis.y;
    V const fast = at.spin.x * at.spin.x + at.spin.y * at.spin.y;
    constexpr double half_period = std::numbers::pi;  // over w_v
    M const far = tilt * get(State::stiffness) > half_period * half_period * fast;
    M const leans = (far & (tilt > least * least)) | passes;
    if (!any(leans)) {
        return;
    }
    if (any(passes)) {
        // Since it turned, by how fast it leans on, under the acceleration of now.
        auto const axes = axes_of(at.turn);
        V const rate_x = fma(at.spin.y, axes.first.x, -(at.spin.x * axes.second.x));
        V const rate_y = fma(at.spin.y, axes.first.y, -(at.spin.x * axes.second.y));
        V const rate = fma(rate_x, get(State::lean_x), rate_y * get(State::lean_y));
        V const since = min(lean / min(rate, V(-std::numeric_limits<double>::min())), get(State::step));
        V const power = fma(at.spin.x, pull.spin.x, at.spin.y * pull.spin.y);
        V const then = max(fma(-2.0 * since, power, fast), zero);
        V const slow = get(State::impact_spin);
        M const impacts = passes & (then > slow * slow);
        put(State::most_spin, max(choose(impacts, then, zero), get(State::most_spin)));
        put(State::impacts, get(State::impacts) + choose(impacts, V(1), zero));
    }
    put(State::lean_x, choose(leans, axis.x, get(State::lean_x)));
    put(State::lean_y, choose(leans, axis.y, get(State::lean_y)));
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
