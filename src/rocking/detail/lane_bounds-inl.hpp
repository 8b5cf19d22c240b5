// What a step in lanes can do at most, from what is known where it starts and where it leads: whether phi keeps clear
// of the ground or falls to it once, whether friction and contact hold. Included once per instruction set, so without a
// #pragma once; by lane_step-inl.hpp only.
#if defined(OVERTURN_LANE_BOUNDS) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANE_BOUNDS
#undef OVERTURN_LANE_BOUNDS
#else
#define OVERTURN_LANE_BOUNDS
#endif

#include "rocking/detail/lane_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

// Time is the share u of the step in all that follows, 0 to 1; a prime is d/du. So phi'' = -w pull, w = (p length)^2,
// pull = Gv sin psi + A cos psi; sin psi' = -phi' cos psi, cos psi' = phi' sin psi; A' and Gv' are constant. With
// m = A sin psi - Gv cos psi: pull' = Gv' sin psi + A' cos psi + phi' m, m' = A' sin psi - Gv' cos psi - phi' pull.
template <class V, int Stride, bool Vertical> class LaneBounds : protected LaneSeries<V, Stride, Vertical> {
  public:
    using Path = LaneSeries<V, Stride, Vertical>;
    using M = typename Path::M;
    using Path::Path;

  protected:
    using Path::get;
    using typename Path::Forcing;
    using typename Path::Series;
    using typename Path::Target;

    // A step as planned, from here to the sample's end. What is large is referred to: copies go through memory.
    struct Plan {
        V side, length;
        Forcing const& a;  // A
        Forcing const& g;  // Gv
        V ph, w;           // p length, and its square
        Series const& x;
        V phi, omega, s, c;  // here
        Target const& to;
    };
    struct Bounds {
        V across;                     // of |A|
        V change;                     // |A'| + |Gv'|
        V force;                      // of |A| + |Gv|, and so of |pull| and |m|
        V arc;                        // of |phi'|, and so of |phi - phi(0)| [rad]
        V most_curved, least_curved;  // of phi''
        V slowest, fastest;           // of phi'
        M concave, convex;            // all along
    };
    struct Landing {
        M started;  // on the ground: that zero is no event
        M lands;    // falls to it once
        M clear;    // does not get there
    };
    struct Forces {
        V spin, friction, normal;  // r phi'^2 by time; friction's amount
    };

    // The pull, and the shaking's share of it, where there is vertical motion or none.
    static OVERTURN_LANES_INLINE V pull_of(V g, V a, V s, V c) { return Vertical ? pull(g, a, s, c) : pull(a, s, c); }
    static OVERTURN_LANES_INLINE V shaking_pull_of(V g, V a, V s, V c) {
        return Vertical ? pull(g - 1.0, a, s, c) : a * c;
    }
    // Whether any lane stands on a slope.
    OVERTURN_LANES_INLINE bool inclined() const { return any(abs(get(RockingField::incline_sine)) > V(0)); }
    OVERTURN_LANES_INLINE Forces forces(V s, V c, V rate, V a, V g) const;
    OVERTURN_LANES_INLINE Bounds bounds_of(Plan const& plan) const;
    OVERTURN_LANES_INLINE Landing landing_of(Plan const& plan, Bounds const& bounds) const;
    OVERTURN_LANES_INLINE M contact_holds(Plan const& plan, Bounds const& bounds, Forces const& here) const;
};

// Contact forces over m g, along and across the ground.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneBounds<V, Stride, Vertical>::forces(V s, V c, V rate, V a, V g) const -> Forces {
    V const spin = get(RockingField::r) * (rate * rate);
    V const grip = get(RockingField::inertia_ratio) * pull_of(g, a, s, c);
    auto at = contact_forces_in_motion(s, c, spin, a, g, grip);
    if (inclined()) {  // level ground changes no bit of its lanes
        at = turned_to_ground(at, get(RockingField::incline_sine), get(RockingField::incline_cosine));
    }
    return {spin, abs(at.friction), at.normal};
}

// A and Gv are linear, so their amounts are largest at an end, and |phi'| <= |phi'(0)| + w force.
// The pull is almost a line: pull'' = 2 phi' (A' sin psi - Gv' cos psi) - w pull m - phi'^2 pull, so that
// |pull''| <= 2 arc change + force (w force + arc^2) = off_line. A curve strays from the line between its ends by an
// eighth of that; all of it is allowed for.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneBounds<V, Stride, Vertical>::bounds_of(Plan const& plan) const -> Bounds {
    V const zero = 0;
    V const one = 1;
    Forcing const& a = plan.a;
    Forcing const& g = plan.g;
    Target const& to = plan.to;
    V const w = plan.w;
    V const rate = plan.x.rate[0];
    V const pull_here = pull_of(g.start, a.start, plan.s, plan.c);
    V const pull_end = pull_of(g.end, a.end, to.s, to.c);
    V const change = Vertical ? abs(a.change) + abs(g.change) : abs(a.change);
    V const across = max(abs(a.start), abs(a.end));
    V const force = across + (Vertical ? max(abs(g.start), abs(g.end)) : one);
    V const arc = fma(w, force, abs(rate));
    V const off_line = fma(force, fma(arc, arc, w * force), (change + change) * arc);
    V const most_curved = w * (off_line - min(pull_here, pull_end));
    V const least_curved = -(w * (off_line + max(pull_here, pull_end)));
    V const slowest = rate + min(least_curved, zero);
    V const fastest = rate + max(most_curved, zero);
    return {
        across, change, force, arc, most_curved, least_curved, slowest, fastest, most_curved<zero, least_curved> zero};
}

// phi >= phi(0) + phi'(0) u + least_curved u^2 / 2. After a start on the ground both sides are divided by u: what keeps
// the block off it at first is then its rate. A path that is concave, or falls all along, crosses zero once at most,
// and does if it ends below.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneBounds<V, Stride, Vertical>::landing_of(Plan const& plan, Bounds const& bounds) const
    -> Landing {
    V const zero = 0;
    V const rate = plan.x.rate[0];
    M const started = get(RockingField::start) > zero;
    V const lift = choose(started, rate, plan.phi);
    V const drop = 0.5 * min(bounds.least_curved, zero);
    V const fall_back = choose(started, drop, min(rate, zero) + drop);
    M const once = (lift > zero) & (bounds.concave | without(bounds.fastest < zero, started));
    M const lands = once & (plan.to.phi <= zero);
    M const clear = (lift + fall_back > zero) | ((rate >= zero) & bounds.convex) | without(once, lands);
    return {started, lands, clear};
}

// How far the contact forces can move within a step. Let lambda = r p^2 < 1 (the inertia ratio), spin = r phi'^2 by
// time, D = Gv' sin psi + A' cos psi and E = A' sin psi - Gv' cos psi, so that D' = phi' E, m' = E - phi' pull and
// spin' = -2 lambda phi' pull; |D|, |E| <= change. From its start spin grows by 2 lambda arc force at most.
// First derivatives, of F = A - lambda cos psi pull + sin psi spin and N = Gv - lambda sin psi pull - cos psi spin:
//     F' = A' - lambda cos psi D - lambda phi' (3 sin psi pull + cos psi m) - phi' cos psi spin,
//     N' = Gv' - lambda sin psi D + lambda phi' (3 cos psi pull - sin psi m) - phi' sin psi spin,
// whose brackets are 2 A sin 2psi + Gv (1 - 2 cos 2psi) and 2 Gv sin 2psi + A (1 + 2 cos 2psi): 3 force at most. So
//     |F'|, |N'| <= 2 change + arc (lambda (3 + 2 arc) force + spin at the start) <= 2 change + 3 arc (force + spin)
// while lambda (3 + 2 most_arc) <= 3, which most_lane_inertia_ratio sees to.
// Second derivatives, for any lambda:
//     F'' = lambda (w pull (3 sin psi pull + cos psi m) + phi'^2 (6 cos psi pull - 4 sin psi m)
//           - phi' (4 sin psi D + 2 cos psi E)) + spin (w pull cos psi - phi'^2 sin psi),
//     N'' = lambda (-w pull (3 cos psi pull - sin psi m) + phi'^2 (6 sin psi pull + 4 cos psi m)
//           + phi' (4 cos psi D - 2 sin psi E)) + spin (w pull sin psi + phi'^2 cos psi),
// in which the brackets with w, phi'^2 and phi' are at most 3 force, 6 force and 4 change. So both are at most
// (w force + arc^2) (spin at the start + (6 + 2 arc) force) + 4 arc change; the code has 10 for 6 and 6 for 4. A curve
// strays from the line between its ends by an eighth of that.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneBounds<V, Stride, Vertical>::contact_holds(Plan const& plan, Bounds const& bounds,
                                                                          Forces const& here) const -> M {
    V const one = 1;
    V const force = bounds.force;
    V const arc = bounds.arc;
    V const change = bounds.change;
    // On a slope each of the two moves by both.
    V const both = inclined() ? get(RockingField::incline_cosine) + abs(get(RockingField::incline_sine)) : one;
    V const limit = get(RockingField::friction_limit);
    auto const holds = [&](V friction, V normal, V astray) HWY_ATTR {
        V const least = normal - astray;
        return (least > V(0)) & (friction + astray <= limit * least);
    };
    static_assert(most_lane_inertia_ratio * (3 + 2 * most_arc) <= 3);
    V const moved = both * fma(force + here.spin, 3.0 * arc, change + change);
    M held = holds(here.friction, here.normal, moved);
    if (any(!held)) {  // near a limit: from both ends
        constexpr double growth = 10 + 2 * most_arc;
        Target const& to = plan.to;
        Forces const there = forces(to.s, to.c, to.speed / plan.length, plan.a.end, plan.g.end);
        V const astray =
            0.125 * both * fma(fma(arc, arc, plan.w * force), here.spin + growth * force, 6.0 * arc * change);
        held = held | (holds(here.friction, here.normal, astray) & holds(there.friction, there.normal, astray));
    }
    return held;
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
