// The arithmetic of one step of a body on compliant points, in any vector width. Included once per instruction set, so
// without a #pragma once; by contact_step.cpp only.
#if defined(OVERTURN_CONTACT_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_CONTACT_STEP
#undef OVERTURN_CONTACT_STEP
#else
#define OVERTURN_CONTACT_STEP
#endif

#include <numbers>

#include "contact/detail/contact_force-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

/// RK4 with a fixed step. What the points remember is frozen within a step and brought up to date at the state where
/// one ends and the next begins.
template <class V, int Stride, int Points> class ContactStepper : private ContactForce<V, Stride, Points> {
  public:
    using Force = ContactForce<V, Stride, Points>;
    using M = typename Force::M;
    explicit ContactStepper(ContactLanes<Stride>& lanes) : Force(lanes) {}

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
    OVERTURN_LANES_INLINE M next_sample(Motion const& at, Pull const& pull, V index, M ended);
    OVERTURN_LANES_INLINE M advanced(Motion const& at, Pull const& pull, V index, V substep);
    OVERTURN_LANES_INLINE void save(Motion const& to, V turn);
};

// By these displacements, and to the velocities that a pull gives in this time. The first terms that the sums for the
// turn leave out are turn^8 / 8! of its cosine and turn^9 / 9! of its sine: below rounding (2^-53) up to 0.038 rad, and
// far below RK4's own error at any turn that a step can hold. How large that is: README.md, bounds.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE auto ContactStepper<V, Stride, Points>::moved(Motion const& from, V sway, V rise, V turn,
                                                                    Pull const& by, V time) const -> Motion {
    V const square = turn * turn;
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
OVERTURN_LANES_INLINE void ContactStepper<V, Stride, Points>::log(Motion const& at, Pull const& pull, V index,
                                                                  V substep) {
    V const zero = 0;
    V const time =
        get(ContactField::origin) + fma(index, get(ContactField::time_step), substep * get(ContactField::step));
    V const rotation = get(ContactField::rotation);
    auto const record = [&](ContactField value, ContactField when, M better, V reached) HWY_ATTR {
        if (any(better)) {
            put(value, choose(better, reached, get(value)));
            put(when, choose(better, time, get(when)));
        }
    };
    record(ContactField::crest, ContactField::crest_time, rotation > get(ContactField::crest), rotation);
    record(ContactField::trough, ContactField::trough_time, rotation < get(ContactField::trough), rotation);
    record(ContactField::uplift_time, ContactField::uplift_time,
           (pull.least_depth <= zero) & (get(ContactField::uplift_time) < zero), time);
    record(ContactField::loss_time, ContactField::loss_time,
           (pull.press <= zero) & (get(ContactField::loss_time) < zero), time);
    put(ContactField::force, pull.press);
    put(ContactField::least_force, min(pull.press, get(ContactField::least_force)));
    put(ContactField::most_force, max(pull.press, get(ContactField::most_force)));
    put(ContactField::most_rise, max(at.rise, get(ContactField::most_rise)));
    // Of the corner that it leans on: rocking about a corner moves the middle of the base, not that corner.
    V const lifted = get(ContactField::half_width) * (at.sine * at.sine / (1.0 + abs(at.cosine)));
    V const middle = at.sway - get(ContactField::height) * at.sine;
    put(ContactField::most_slip,
        max(abs(middle - choose(rotation < zero, -lifted, lifted)), get(ContactField::most_slip)));
    V const reach = get(ContactField::half_width) * abs(at.cosine);
    put(ContactField::most_x, max(middle + reach, get(ContactField::most_x)));
    put(ContactField::least_x, min(middle - reach, get(ContactField::least_x)));
    put(ContactField::most_top,
        max(abs(fma(get(ContactField::height), at.sine, at.sway)), get(ContactField::most_top)));
    V const spread = at.spin * get(ContactField::inverse_p);
    V const lean =
        fma(get(ContactField::sine_alpha), abs(at.sine), get(ContactField::cosine_alpha) * (at.cosine - 1.0));
    put(ContactField::most_energy, max(fma(0.5 * spread, spread, lean), get(ContactField::most_energy)));
    V const side = get(ContactField::side);
    if (M const passes = rotation * side < zero; any(passes)) {
        // Where the angle was zero, under the acceleration of now.
        V const spin = sqrt(max(fma(-2.0 * (at.sine / at.cosine), pull.spin, at.spin * at.spin), zero));
        M const impacts = passes & (spin > get(ContactField::impact_spin));
        put(ContactField::most_spin, max(choose(impacts, spin, zero), get(ContactField::most_spin)));
        put(ContactField::impacts, get(ContactField::impacts) + choose(impacts, V(1), zero));
        put(ContactField::side, choose(passes, -side, side));
    }
    put(ContactField::steps, get(ContactField::steps) + 1.0);
}

// The next sample, for the lanes whose last step reached it. Returns those that are at the end or may rest.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE auto ContactStepper<V, Stride, Points>::next_sample(Motion const& at, Pull const& pull, V index,
                                                                          M ended) -> M {
    V const last = get(ContactField::last);
    V const place = min(index, last - 1.0);
    V here;
    V next;
    auto const read = [&](ContactWave wave, ContactField scale, ContactField value, ContactField change) HWY_ATTR {
        this->fetch_wave(wave, place, here, next);
        here = here * get(scale);
        next = next * get(scale);
        put(value, choose(ended, here, get(value)));
        put(change, choose(ended, next - here, get(change)));
    };
    read(ContactWave::horizontal, ContactField::horizontal_scale, ContactField::horizontal,
         ContactField::horizontal_change);
    V const strongest = max(abs(here), abs(next));
    read(ContactWave::vertical, ContactField::vertical_scale, ContactField::vertical, ContactField::vertical_change);
    V const weight = min(here, next) + get(ContactField::gravity);
    auto const square = [](V sway, V rise, V spin, V inertia)
                            HWY_ATTR { return fma(sway, sway, fma(rise, rise, inertia * (spin * spin))); };
    V const inertia = get(ContactField::inertia);
    V const energy = 0.5
                     * fma(square(pull.sway, pull.rise, pull.spin, inertia), get(ContactField::flexibility),
                           square(at.sway_speed, at.rise_speed, at.spin, inertia));
    // Upright only: a body that balances near its critical angle is as quiet, and may yet fall.
    M const upright = abs(at.sine) < upright_share * get(ContactField::sine_alpha);
    M const quiet =
        upright & (energy < get(ContactField::quiet_energy)) & (strongest <= get(ContactField::rest_ratio) * weight);
    return ended & (quiet | (index >= last));
}

template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE void ContactStepper<V, Stride, Points>::save(Motion const& to, V turn) {
    put(ContactField::sway, to.sway);
    put(ContactField::rise, to.rise);
    put(ContactField::rotation, get(ContactField::rotation) + turn);
    put(ContactField::sine, to.sine);
    put(ContactField::cosine, to.cosine);
    put(ContactField::sway_speed, to.sway_speed);
    put(ContactField::rise_speed, to.rise_speed);
    put(ContactField::spin, to.spin);
}

template <class V, int Stride, int Points> OVERTURN_LANES_INLINE auto ContactStepper<V, Stride, Points>::step() -> M {
    Motion const start{get(ContactField::sway),   get(ContactField::rise),       get(ContactField::sine),
                       get(ContactField::cosine), get(ContactField::sway_speed), get(ContactField::rise_speed),
                       get(ContactField::spin)};
    V const index = get(ContactField::index);
    V const substep = get(ContactField::substep);
    V const h = get(ContactField::step);
    V const half = 0.5 * h;
    V const share = get(ContactField::inverse_substeps);
    V const across = get(ContactField::horizontal_change) * share;
    V const up = get(ContactField::vertical_change) * share;
    auto const shaken = [&](double later) HWY_ATTR {
        V const at = substep + later;
        return typename Force::Shaking{fma(across, at, get(ContactField::horizontal)),
                                       fma(up, at, get(ContactField::vertical)) + get(ContactField::gravity)};
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
OVERTURN_LANES_INLINE auto ContactStepper<V, Stride, Points>::advanced(Motion const& at, Pull const& pull, V index,
                                                                       V substep) -> M {
    V const after = substep + 1.0;
    M const ended = after >= get(ContactField::substeps);
    M const fell = !(abs(get(ContactField::rotation)) < 0.5 * std::numbers::pi);  // or is no number any more
    if (!any(ended)) {
        put(ContactField::substep, after);
        return fell;
    }
    V const reached = choose(ended, index + 1.0, index);
    M const turned = next_sample(at, pull, reached, ended);
    put(ContactField::index, reached);
    put(ContactField::substep, choose(ended, V(0), after));
    return fell | turned;
}

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
