// The arithmetic of one step of a body on compliant points in space, in any vector width. Included once per instruction
// set, so without a #pragma once; by spatial_kernel.cpp only.
#if defined(OVERTURN_SPATIAL_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_SPATIAL_STEP
#undef OVERTURN_SPATIAL_STEP
#else
#define OVERTURN_SPATIAL_STEP
#endif

#include "spatial/detail/face_pressure-inl.hpp"
#include "spatial/detail/patch_force-inl.hpp"
#include "spatial/detail/point_force-inl.hpp"
#include "spatial/detail/rim_pressure-inl.hpp"

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
