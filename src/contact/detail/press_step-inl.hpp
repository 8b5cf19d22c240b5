// The arithmetic of one step of a body on compliant points, in any vector width. Included once per instruction set, so
// without a #pragma once; by pressing.cpp only.
#if defined(OVERTURN_PRESS_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_PRESS_STEP
#undef OVERTURN_PRESS_STEP
#else
#define OVERTURN_PRESS_STEP
#endif

#include <numbers>

#include "contact/detail/press_force-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

/// RK4 with a fixed step. What the points remember is frozen within a step and brought up to date at the state where
/// one ends and the next begins.
template <class V, int Stride, int Points> class PressStepper : private PressForce<V, Stride, Points> {
  public:
    using Force = PressForce<V, Stride, Points>;
    using M = typename Force::M;
    explicit PressStepper(PressLanes<Stride>& lanes) : Force(lanes) {}

    /// \return the lanes that need care
    OVERTURN_LANES_INLINE M step();

  private:
    using Force::get;
    using Force::now;
    using Force::now_and_remember;
    using Force::put;
    using typename Force::Motion;
    using typename Force::Pull;

    OVERTURN_LANES_INLINE Motion moved(Motion const& from, V sway, V rise, V turn, Pull const& by, V time) const;
    OVERTURN_LANES_INLINE void log(Motion const& at, Pull const& pull, V index, V substep);
    OVERTURN_LANES_INLINE M turn_page(Motion const& at, Pull const& pull, V index, M ended);
    OVERTURN_LANES_INLINE M advanced(Motion const& at, Pull const& pull, V index, V substep);
    OVERTURN_LANES_INLINE void save(Motion const& to, V turn);
};

// By these displacements, and to the velocities that a pull gives in this time.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE auto PressStepper<V, Stride, Points>::moved(Motion const& from, V sway, V rise, V turn,
                                                                  Pull const& by, V time) const -> Motion {
    V const square = turn * turn;
    // Turns of a step are below 0.05: the next terms are below rounding.
    V const sine = turn * fma(-square, fma(-square, fma(-square, 1.0 / 5040, 1.0 / 120), 1.0 / 6), 1.0);
    V const versine = square * fma(-square, fma(-square, 1.0 / 720, 1.0 / 24), 0.5);
    return {from.sway + sway,
            from.rise + rise,
            from.sine + (from.cosine * sine - from.sine * versine),
            from.cosine - fma(from.sine, sine, from.cosine * versine),
            fma(by.sway, time, from.sway_speed),
            fma(by.rise, time, from.rise_speed),
            fma(by.spin, time, from.spin)};
}

template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE void PressStepper<V, Stride, Points>::log(Motion const& at, Pull const& pull, V index,
                                                                V substep) {
    V const zero = 0;
    V const time = get(Pressing::origin) + fma(index, get(Pressing::time_step), substep * get(Pressing::step));
    V const rotation = get(Pressing::rotation);
    auto const record = [&](Pressing value, Pressing when, M better, V reached) HWY_ATTR {
        if (any(better)) {
            put(value, choose(better, reached, get(value)));
            put(when, choose(better, time, get(when)));
        }
    };
    record(Pressing::crest, Pressing::crest_time, rotation > get(Pressing::crest), rotation);
    record(Pressing::trough, Pressing::trough_time, rotation < get(Pressing::trough), rotation);
    record(Pressing::uplift_time, Pressing::uplift_time,
           (pull.least_depth <= zero) & (get(Pressing::uplift_time) < zero), time);
    record(Pressing::loss_time, Pressing::loss_time, (pull.press <= zero) & (get(Pressing::loss_time) < zero), time);
    put(Pressing::force, pull.press);
    put(Pressing::least_force, min(pull.press, get(Pressing::least_force)));
    put(Pressing::most_force, max(pull.press, get(Pressing::most_force)));
    put(Pressing::most_rise, max(at.rise, get(Pressing::most_rise)));
    // Of the corner that it leans on: rocking about a corner moves the middle of the base, not that corner.
    V const lifted = get(Pressing::half_width) * (at.sine * at.sine / (1.0 + abs(at.cosine)));
    V const middle = at.sway - get(Pressing::height) * at.sine;
    put(Pressing::most_slip, max(abs(middle - choose(rotation < zero, -lifted, lifted)), get(Pressing::most_slip)));
    V const spread = at.spin * get(Pressing::inverse_p);
    V const lean = fma(get(Pressing::sine_alpha), abs(at.sine), get(Pressing::cosine_alpha) * (at.cosine - 1.0));
    put(Pressing::most_energy, max(fma(0.5 * spread, spread, lean), get(Pressing::most_energy)));
    V const side = get(Pressing::side);
    if (M const passes = rotation * side < zero; any(passes)) {
        M const strikes = passes & (abs(at.spin) > get(Pressing::impact_spin));
        put(Pressing::most_spin, max(choose(strikes, abs(at.spin), zero), get(Pressing::most_spin)));
        put(Pressing::impacts, get(Pressing::impacts) + choose(strikes, V(1), zero));
        put(Pressing::side, choose(passes, -side, side));
    }
    put(Pressing::steps, get(Pressing::steps) + 1.0);
}

// The next sample, for the lanes whose last step reached it. Returns those that are at the end or may rest.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE auto PressStepper<V, Stride, Points>::turn_page(Motion const& at, Pull const& pull, V index,
                                                                      M ended) -> M {
    V const last = get(Pressing::last);
    V const place = min(index, last - 1.0);
    V here;
    V next;
    auto const read = [&](PressWave wave, Pressing scale, Pressing value, Pressing change) HWY_ATTR {
        this->fetch_wave(wave, place, here, next);
        here = here * get(scale);
        next = next * get(scale);
        put(value, choose(ended, here, get(value)));
        put(change, choose(ended, next - here, get(change)));
    };
    read(PressWave::horizontal, Pressing::horizontal_scale, Pressing::horizontal, Pressing::horizontal_change);
    V const strongest = max(abs(here), abs(next));
    read(PressWave::vertical, Pressing::vertical_scale, Pressing::vertical, Pressing::vertical_change);
    V const weight = min(here, next) + get(Pressing::gravity);
    auto const square = [](V sway, V rise, V spin, V inertia)
                            HWY_ATTR { return fma(sway, sway, fma(rise, rise, inertia * (spin * spin))); };
    V const inertia = get(Pressing::inertia);
    V const energy = 0.5
                     * fma(square(pull.sway, pull.rise, pull.spin, inertia), get(Pressing::flexibility),
                           square(at.sway_speed, at.rise_speed, at.spin, inertia));
    // Near the critical angle all is quiet too.
    M const upright = abs(at.sine) < 0.1 * get(Pressing::sine_alpha);
    M const quiet =
        upright & (energy < get(Pressing::quiet_energy)) & (strongest <= get(Pressing::rest_ratio) * weight);
    return ended & (quiet | (index >= last));
}

template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE void PressStepper<V, Stride, Points>::save(Motion const& to, V turn) {
    put(Pressing::sway, to.sway);
    put(Pressing::rise, to.rise);
    put(Pressing::rotation, get(Pressing::rotation) + turn);
    put(Pressing::sine, to.sine);
    put(Pressing::cosine, to.cosine);
    put(Pressing::sway_speed, to.sway_speed);
    put(Pressing::rise_speed, to.rise_speed);
    put(Pressing::spin, to.spin);
}

template <class V, int Stride, int Points> OVERTURN_LANES_INLINE auto PressStepper<V, Stride, Points>::step() -> M {
    Motion const start{get(Pressing::sway),       get(Pressing::rise),       get(Pressing::sine), get(Pressing::cosine),
                       get(Pressing::sway_speed), get(Pressing::rise_speed), get(Pressing::spin)};
    V const index = get(Pressing::index);
    V const substep = get(Pressing::substep);
    V const h = get(Pressing::step);
    V const half = 0.5 * h;
    V const share = get(Pressing::inverse_substeps);
    V const across = get(Pressing::horizontal_change) * share;
    V const up = get(Pressing::vertical_change) * share;
    auto const shaken = [&](double later) HWY_ATTR {
        V const at = substep + later;
        return typename Force::Shaking{fma(across, at, get(Pressing::horizontal)),
                                       fma(up, at, get(Pressing::vertical)) + get(Pressing::gravity)};
    };
    auto const middle = shaken(0.5);

    Pull const a = now_and_remember(start, shaken(0));
    log(start, a, index, substep);
    Motion const second = moved(start, half * start.sway_speed, half * start.rise_speed, half * start.spin, a, half);
    Pull const b = now(second, middle);
    Motion const third = moved(start, half * second.sway_speed, half * second.rise_speed, half * second.spin, b, half);
    Pull const c = now(third, middle);
    Motion const fourth = moved(start, h * third.sway_speed, h * third.rise_speed, h * third.spin, c, h);
    Pull const d = now(fourth, shaken(1));

    V const sixth = h * h * (1.0 / 6);
    auto const way = [&](V speed, V one, V two, V three)
                         HWY_ATTR { return fma(h, speed, sixth * (one + (two + three))); };
    auto const mean = [&](V one, V two, V three, V four)
                          HWY_ATTR { return fma(V(2), two + three, one + four) * (1.0 / 6); };
    Pull sum = d;
    sum.sway = mean(a.sway, b.sway, c.sway, d.sway);
    sum.rise = mean(a.rise, b.rise, c.rise, d.rise);
    sum.spin = mean(a.spin, b.spin, c.spin, d.spin);
    V const turn = way(start.spin, a.spin, b.spin, c.spin);
    Motion const end = moved(start, way(start.sway_speed, a.sway, b.sway, c.sway),
                             way(start.rise_speed, a.rise, b.rise, c.rise), turn, sum, h);
    save(end, turn);

    return advanced(end, sum, index, substep);
}

// The place that the step has reached. Returns the lanes that need care there.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE auto PressStepper<V, Stride, Points>::advanced(Motion const& at, Pull const& pull, V index,
                                                                     V substep) -> M {
    V const after = substep + 1.0;
    M const ended = after >= get(Pressing::substeps);
    M const fell = !(abs(get(Pressing::rotation)) < 0.5 * std::numbers::pi);  // or is no number any more
    if (!any(ended)) {
        put(Pressing::substep, after);
        return fell;
    }
    V const reached = choose(ended, index + 1.0, index);
    M const turned = turn_page(at, pull, reached, ended);
    put(Pressing::index, reached);
    put(Pressing::substep, choose(ended, V(0), after));
    return fell | turned;
}

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
