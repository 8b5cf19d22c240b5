// The arithmetic of one step of a body on compliant points in space, in any vector width. Included once per instruction
// set, so without a #pragma once; by spatial_kernel.cpp only.
#if defined(OVERTURN_SPATIAL_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_SPATIAL_STEP
#undef OVERTURN_SPATIAL_STEP
#else
#define OVERTURN_SPATIAL_STEP
#endif

#include <limits>
#include <numbers>

#include "spatial/detail/point_force-inl.hpp"
#include "spatial/detail/rim_force-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// RK4 with a fixed step, on the rotation vector of the step (Munthe-Kaas 1999): about one axis it is the planar code's
/// RK4 on the angle. What the points remember is frozen within a step and brought up to date at the state where one
/// ends and the next begins.
template <class Force> class SpatialStepper : private Force {
  public:
    using V = typename Force::Value;
    using M = typename Force::M;
    template <class Lanes> explicit SpatialStepper(Lanes& lanes) : Force(lanes) {}

    /// \return the lanes that need care
    M step();
    using Force::complete;

  private:
    using Force::base_at_start;
    using Force::get;
    using Force::now;
    using Force::put;
    using typename Force::Depths;
    using typename Force::Motion;
    using typename Force::Pull;
    using typename Force::Shaking;

    [[nodiscard]] OVERTURN_LANES_INLINE Motion load() const;
    OVERTURN_LANES_INLINE void save(Motion const& at);
    [[nodiscard]] OVERTURN_LANES_INLINE Shaking shaken(V substep) const;
    [[nodiscard]] static OVERTURN_LANES_INLINE Motion moved(Motion const& from, Triple<V> const& way,
                                                            Triple<V> const& turn, Pull const& by, V time);
    void log(Motion const& at, Pull const& pull, Depths const& depths);
    OVERTURN_LANES_INLINE void log_height(Motion const& at, Depths const& depths, V time);
    OVERTURN_LANES_INLINE void log_place(Motion const& at, Pull const& pull);
    OVERTURN_LANES_INLINE void log_reach(Motion const& at, Triple<V> const& axis);
    OVERTURN_LANES_INLINE void log_reversal(Motion const& at, Pull const& pull, Triple<V> const& axis);
    M next_sample(Motion const& at, Pull const& pull, V index, M ended);
    OVERTURN_LANES_INLINE M advanced(Motion const& at, Pull const& pull);
};

template <class Force> OVERTURN_LANES_INLINE auto SpatialStepper<Force>::load() const -> Motion {
    return {{get(State::x), get(State::y), get(State::rise)},
            {get(State::qw), get(State::qx), get(State::qy), get(State::qz)},
            {get(State::vx), get(State::vy), get(State::vz)},
            {get(State::wx), get(State::wy), get(State::wz)},
            {get(State::shear_x), get(State::shear_y), get(State::shear_twist)}};
}

template <class Force> OVERTURN_LANES_INLINE void SpatialStepper<Force>::save(Motion const& at) {
    put(State::x, at.at.x);
    put(State::y, at.at.y);
    put(State::rise, at.at.z);
    put(State::qw, at.turn.w);
    put(State::qx, at.turn.x);
    put(State::qy, at.turn.y);
    put(State::qz, at.turn.z);
    put(State::vx, at.velocity.x);
    put(State::vy, at.velocity.y);
    put(State::vz, at.velocity.z);
    put(State::wx, at.spin.x);
    put(State::wy, at.spin.y);
    put(State::wz, at.spin.z);
    if constexpr (Force::shears) {
        put(State::shear_x, at.shear.x);
        put(State::shear_y, at.shear.y);
        put(State::shear_twist, at.shear.z);
    }
}

template <class Force> OVERTURN_LANES_INLINE auto SpatialStepper<Force>::shaken(V substep) const -> Shaking {
    V const share = get(State::inverse_substeps);
    auto const at = [&](State value, State change) HWY_ATTR { return fma(get(change) * share, substep, get(value)); };
    return {at(State::ax, State::ax_change), at(State::ay, State::ay_change),
            at(State::az, State::az_change) + get(State::gravity)};
}

// By this way and turn, and to the velocities that a pull gives in this time.
template <class Force>
OVERTURN_LANES_INLINE auto SpatialStepper<Force>::moved(Motion const& from, Triple<V> const& way, Triple<V> const& turn,
                                                        Pull const& by, V time) -> Motion {
    Motion to{from.at + way, turned(from.turn, turn), fma(time, by.move, from.velocity), fma(time, by.spin, from.spin),
              from.shear};
    if constexpr (Force::shears) {
        to.shear = fma(time, by.shear, from.shear);
    }
    return to;
}

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

// The next sample, for the lanes whose last step reached it. Returns those that are at the end or may rest.
template <class Force>
auto SpatialStepper<Force>::next_sample(Motion const& at, Pull const& pull, V index, M ended) -> M {
    V const last = get(State::last);
    V const place = min(index, last - 1.0);
    auto const read = [&](Wave wave, State scale, State value, State change, V& here, V& next) HWY_ATTR {
        this->fetch_wave(wave, place, here, next);
        here = here * get(scale);
        next = next * get(scale);
        put(value, choose(ended, here, get(value)));
        put(change, choose(ended, next - here, get(change)));
    };
    Triple<V> here;
    Triple<V> next;
    read(Wave::x, State::x_scale, State::ax, State::ax_change, here.x, next.x);
    read(Wave::y, State::y_scale, State::ay, State::ay_change, here.y, next.y);
    read(Wave::z, State::z_scale, State::az, State::az_change, here.z, next.z);
    V const ratio = get(State::rest_ratio);
    auto const weak = [&](Triple<V> const& a)
                          HWY_ATTR { return sqrt(a.x * a.x + a.y * a.y) <= ratio * (a.z + get(State::gravity)); };
    Triple<V> const inertia{get(State::inertia_x), get(State::inertia_y), get(State::inertia_z)};
    auto const square = [&](Triple<V> const& move, Triple<V> const& spin) HWY_ATTR {
        return dot(move, move) + dot(inertia, Triple<V>{spin.x * spin.x, spin.y * spin.y, spin.z * spin.z});
    };
    V const energy = 0.5 * fma(square(pull.move, pull.spin), get(State::flexibility), square(at.velocity, at.spin));
    // Upright only: a body that balances near its critical angle is as quiet, and may yet fall.
    auto const axis = axes_of(at.turn).third;
    M const upright = axis.x * axis.x + axis.y * axis.y < get(State::upright);
    M const quiet = upright & (energy < get(State::quiet_energy)) & weak(here) & weak(next);
    return ended & (quiet | (index >= last));
}

template <class Force> auto SpatialStepper<Force>::step() -> M {
    Motion start = load();
    V const substep = get(State::substep);
    V const h = get(State::step);
    V const half = 0.5 * h;
    auto const middle = shaken(substep + 0.5);

    auto const depths = this->begin(start);
    Pull const a = this->at_start(start, shaken(substep));
    log(start, a, depths);
    Motion const second = moved(start, half * start.velocity, half * start.spin, a, half);
    auto const second_excess = turning_excess(half * start.spin, second.spin);
    Pull const b = now(second, middle);
    auto const second_turn = half * (second.spin + second_excess);
    Motion const third = moved(start, half * second.velocity, second_turn, b, half);
    auto const third_excess = turning_excess(second_turn, third.spin);
    Pull const c = now(third, middle);
    auto const third_turn = h * (third.spin + third_excess);
    Motion const fourth = moved(start, h * third.velocity, third_turn, c, h);
    auto const fourth_excess = turning_excess(third_turn, fourth.spin);
    Pull const d = now(fourth, shaken(substep + 1.0));

    V const sixth = h * h * (1.0 / 6);
    auto const way = [&](Triple<V> const& speed, Triple<V> const& one, Triple<V> const& two, Triple<V> const& three)
                         HWY_ATTR { return fma(sixth, one + (two + three), h * speed); };
    auto const mean = [&](Triple<V> const& one, Triple<V> const& two, Triple<V> const& three, Triple<V> const& four)
                          HWY_ATTR { return V(1.0 / 6) * fma(V(2), two + three, one + four); };
    Pull sum{mean(a.move, b.move, c.move, d.move), mean(a.spin, b.spin, c.spin, d.spin), d.press, d.shear};
    if constexpr (Force::shears) {
        sum.shear = mean(a.shear, b.shear, c.shear, d.shear);
    }
    Triple<V> const none{V(0), V(0), V(0)};
    auto const turn =
        fma(h, mean(none, second_excess, third_excess, fourth_excess), way(start.spin, a.spin, b.spin, c.spin));
    Motion end = moved(start, way(start.velocity, a.move, b.move, c.move), turn, sum, h);
    end.turn = normalised(end.turn);
    // Passing half a turn of yaw, w changes its sign.
    V const zero = 0;
    if (M const passes = start.turn.w * end.turn.w < zero; any(passes)) {
        V const way_round = choose(end.turn.z * start.turn.w < zero, V(-1), V(1));
        put(State::turns, get(State::turns) + choose(passes, way_round, zero));
    }
    save(end);

    return advanced(end, sum);
}

// The place that the step has reached. Returns the lanes that need care there.
template <class Force>
OVERTURN_LANES_INLINE auto SpatialStepper<Force>::advanced(Motion const& at, Pull const& pull) -> M {
    V const index = get(State::index);
    V const after = get(State::substep) + 1.0;
    M const ended = after >= get(State::substeps);
    M const fell = !(at.turn.x * at.turn.x + at.turn.y * at.turn.y < V(0.5));  // or is no number any more
    if (!any(ended)) {
        put(State::substep, after);
        return fell;
    }
    V const reached = choose(ended, index + 1.0, index);
    M const turned = next_sample(at, pull, reached, ended);
    put(State::index, reached);
    put(State::substep, choose(ended, V(0), after));
    return fell | turned;
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
