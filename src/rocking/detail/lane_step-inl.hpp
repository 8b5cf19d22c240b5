// The arithmetic of one step of rocking, in any vector width. Included once per instruction set, so without a
// #pragma once; by lane_step.cpp only.
#if defined(OVERTURN_LANE_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANE_STEP
#undef OVERTURN_LANE_STEP
#else
#define OVERTURN_LANE_STEP
#endif

#include <numbers>

#include "rocking/detail/lane_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

template <class V, int Stride, bool Vertical> class Stepper : private LaneSeries<V, Stride, Vertical> {
  public:
    using Path = LaneSeries<V, Stride, Vertical>;
    using M = typename Path::M;
    using Path::Path;

    // Returns the lanes that need care. Those that took no step are unchanged.
    OVERTURN_LANES_INLINE M step(LaneStep* shown);

  private:
    using Path::expand;
    using Path::first_zero;
    using Path::forcing;
    using Path::get;
    using Path::order;
    using Path::put;
    using Path::target;
    using Path::trig;
    using typename Path::Forcing;
    using typename Path::Series;
    using typename Path::Target;

    struct Forces {
        V spin, friction, normal;  // r phi'^2; friction's amount
    };
    // Whether any lane stands on a slope.
    OVERTURN_LANES_INLINE bool inclined() const { return any(abs(get(RockingField::incline_sine)) > V(0)); }
    // The pull, and the shaking's share of it, where there is vertical motion or none.
    static OVERTURN_LANES_INLINE V pull_of(V g, V a, V s, V c) { return Vertical ? pull(g, a, s, c) : pull(a, s, c); }
    static OVERTURN_LANES_INLINE V shaking_pull_of(V g, V a, V s, V c) {
        return Vertical ? pull(g - 1.0, a, s, c) : a * c;
    }
    OVERTURN_LANES_INLINE Forces forces(V s, V c, V rate, V a, V g) const;
    OVERTURN_LANES_INLINE V slant(V u, Series const& x, Forcing const& a, Forcing const& g) const;
    OVERTURN_LANES_INLINE V energy_at(V u, Series const& x, V length) const;
};

// Contact forces over m g, along and across the ground.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto Stepper<V, Stride, Vertical>::forces(V s, V c, V rate, V a, V g) const -> Forces {
    V const spin = get(RockingField::r) * (rate * rate);
    V const grip = get(RockingField::inertia_ratio) * pull_of(g, a, s, c);
    auto at = contact_forces_in_motion(s, c, spin, a, g, grip);
    if (inclined()) {  // level ground changes no bit of its lanes
        at = turned_to_ground(at, get(RockingField::incline_sine), get(RockingField::incline_cosine));
    }
    return {spin, abs(at.friction), at.normal};
}

// The shaking's pull over m g, along the way of the centre of gravity and over cos psi: almost a line.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V Stepper<V, Stride, Vertical>::slant(V u, Series const& x, Forcing const& a,
                                                            Forcing const& g) const {
    V const across = fma(a.change, u, a.start);
    if constexpr (Vertical) {
        auto const [s, c] = this->turned(x, this->gain(u, x));
        return fma(fma(g.change, u, g.start) - 1.0, s / c, across);
    }
    return across;
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V Stepper<V, Stride, Vertical>::energy_at(V u, Series const& x, V length) const {
    V const spread = Path::at(u, x.rate) / (get(RockingField::p) * length);
    return rocking_energy(spread, this->turned(x, this->gain(u, x)).c - get(RockingField::cosine_alpha));
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto Stepper<V, Stride, Vertical>::step(LaneStep* shown) -> M {
    V const zero = 0;
    V const one = 1;
    V const index = get(RockingField::index);
    V const tau = get(RockingField::tau);
    V const dt = get(RockingField::time_step);
    V const side = get(RockingField::side);
    V const scale = get(RockingField::scale);
    V const length = dt - tau;
    V const into = tau * get(RockingField::sampling_rate);
    Forcing const a = forcing(RockingWave::horizontal, side * scale, index, into);
    Forcing g{one, zero, one};
    if constexpr (Vertical) {
        g = forcing(RockingWave::vertical, scale, index, into);
        g.start = g.start + 1.0;
        g.end = g.end + 1.0;
    }
    V const ph = get(RockingField::p) * length;
    V const w = ph * ph;
    Series const x = expand(length, w, a, g);
    auto const& rate = x.rate;
    V const phi = get(RockingField::phi);
    V const omega = get(RockingField::omega);
    V const s = x.s[0];
    V const c = x.c[0];
    Target const to = target(x);

    // Bounds of what may happen on the way; phi'' = -w pull, and pull is close to a line.
    V const pull_here = pull_of(g.start, a.start, s, c);
    V const pull_end = pull_of(g.end, a.end, to.s, to.c);
    V const change = Vertical ? abs(a.change) + abs(g.change) : abs(a.change);
    V const across = max(abs(a.start), abs(a.end));
    V const force = across + (Vertical ? max(abs(g.start), abs(g.end)) : one);
    V const arc = fma(w, force, abs(rate[0]));
    V const off_line = fma(force, fma(arc, arc, w * force), (change + change) * arc);
    V const most_curved = w * (off_line - min(pull_here, pull_end));
    V const least_curved = -(w * (off_line + max(pull_here, pull_end)));

    // Does phi stay clear of zero, or fall through it once?
    V const slowest = rate[0] + min(least_curved, zero);
    V const fastest = rate[0] + max(most_curved, zero);
    M const concave = most_curved < zero;
    M const convex = least_curved > zero;
    M const started = get(RockingField::start) > zero;
    V const lift = choose(started, rate[0], phi);  // what keeps it off the ground at first
    V const drop = 0.5 * min(least_curved, zero);
    V const fall_back = choose(started, drop, min(rate[0], zero) + drop);
    M const once = (lift > zero) & (concave | without(fastest < zero, started));
    M const lands = once & (to.phi <= zero);
    M const clear = (lift + fall_back > zero) | ((rate[0] >= zero) & convex) | without(once, lands);

    // Every other event must be out of reach, and the series sound.
    V const last_terms = max(abs(rate[order - 1]), abs(rate[order - 2]) * ph);
    M fine =
        (last_terms <= get(RockingField::tolerance)) & (arc <= most_arc) & (to.phi < 0.5 * std::numbers::pi - most_arc);

    // A record of rotation or of energy inside? Energy is stationary where the block turns and where the shaking lets
    // go of it. A path that bends one way has no more than one turn.
    V const peak = get(RockingField::peak);
    V const record = get(RockingField::energy);
    V const spread = omega * get(RockingField::inverse_p);
    V const energy = rocking_energy(spread, c - get(RockingField::cosine_alpha));
    V const down = Vertical ? g.start - 1.0 : zero;
    V const down_end = Vertical ? g.end - 1.0 : zero;
    V const shove = shaking_pull_of(g.start, a.start, s, c);
    V const shove_end = shaking_pull_of(g.end, a.end, to.s, to.c);
    M const reaches = phi + arc > peak;
    M const charged = energy + arc * (Vertical ? across + max(abs(down), abs(down_end)) : across) > record;
    M const wavers = without(without((slowest <= zero) & (fastest >= zero), concave), convex);
    // Beyond alpha energy may have a maximum where a fall back turns into a rise.
    M const falters = charged & (rate[0] < zero) & (to.speed > zero);
    fine = without(fine, (wavers & (reaches | charged)) | falters);
    M const turns = fine & (reaches | charged) & (rate[0] > zero) & (to.speed <= zero);
    V crest = zero;
    V crest_energy = zero;
    V crest_share = one;
    if (any(turns)) {
        auto const [u, found] = this->turning(x);
        fine = without(fine, without(turns, found));
        V const gain = this->gain(u, x);
        crest = choose(turns, phi + gain, zero);
        crest_energy = choose(turns, this->turned(x, gain).c - get(RockingField::cosine_alpha), zero);
        crest_share = choose(turns, u, one);
    }
    M const lets_go = fine & charged & (shove * shove_end < zero);
    V free_energy = zero;
    V free_share = one;
    if (any(lets_go)) {
        V const slant_here = Vertical ? fma(down, s / c, a.start) : a.start;
        V const yield = slant_here - (Vertical ? fma(down_end, to.s / to.c, a.end) : a.end);
        V const u = slant_here / yield;
        free_share = choose(lets_go, max(zero, min(one, u + slant(u, x, a, g) / yield)), one);
        free_energy = choose(lets_go, energy_at(free_share, x, length), zero);
    }

    // Contact forces here, and how far they could move: r p^2 = inertia_ratio < 1.
    Forces const here = forces(s, c, omega, a.start, g.start);
    V const both = inclined() ? get(RockingField::incline_cosine) + abs(get(RockingField::incline_sine)) : one;
    V const sway = both * fma(force + here.spin, 3.0 * arc, change + change);
    V const limit = get(RockingField::friction_limit);
    auto const holds = [&](V pulling, V pressing, V astray) HWY_ATTR {
        V const least = pressing - astray;
        return (least > zero) & (pulling + astray <= limit * least);
    };
    M held = holds(here.friction, here.normal, sway);
    if (any(!held)) {
        // Near a limit: the forces stray from the line between their ends by an eighth of their second derivatives,
        // which are below (arc^2 + w force) (spin + 10.06 force) + 6 arc change.
        Forces const there = forces(to.s, to.c, to.speed / length, a.end, g.end);
        V const bow = 0.125 * both * fma(fma(arc, arc, w * force), here.spin + 10.06 * force, 6.0 * arc * change);
        held = held | (holds(here.friction, here.normal, bow) & holds(there.friction, there.normal, bow));
    }
    fine = fine & held;

    V phi1 = to.phi;
    V omega1 = to.speed / length;  // its inverse would err one way in every step
    V s1 = to.s;
    V c1 = to.c;
    V index1 = index + 1.0;
    V tau1 = zero;
    V start1 = zero;
    V energy1 = max(record, energy);
    V demand1 = get(RockingField::demand);
    V normal1 = min(here.normal, get(RockingField::normal));
    V share = one;
    M taken = clear & fine;
    M impacts = lands & fine;
    if (any(impacts)) {
        auto const [u, found] = first_zero(x, started);
        V const approach = -Path::at(u, rate) / length;
        V const rebound = get(RockingField::restitution) * approach;
        V const gv = Vertical ? fma(g.change, u, g.start) : one;
        V const av = fma(a.change, u, a.start);
        V const hold = gv * get(RockingField::uplift_ratio) - abs(av);
        V const settle = get(RockingField::settle_speed);
        constexpr double rest_speed_share = 1e-3;
        M const lasts = (rebound > settle * rest_speed_share)
                        & (rebound * get(RockingField::settle_rate) > fma(-u, length, length) * hold);
        impacts = impacts & found & ((rebound > settle) | lasts) & (u > zero) & (u < one)
                  & (get(RockingField::impact_demand) <= get(RockingField::friction_limit));
        V const approach_spread = approach * get(RockingField::inverse_p);
        energy1 = choose(impacts, max(energy1, 0.5 * approach_spread * approach_spread), energy1);
        demand1 = choose(impacts, max(demand1, get(RockingField::impact_demand)), demand1);
        auto const before = forces(get(RockingField::sine_alpha), get(RockingField::cosine_alpha), approach, av, gv);
        normal1 = choose(impacts, min(normal1, before.normal), normal1);
        demand1 =
            choose(impacts & (before.friction > demand1 * before.normal), before.friction / before.normal, demand1);
        share = choose(impacts, u, one);
        phi1 = choose(impacts, zero, phi1);
        omega1 = choose(impacts, rebound, omega1);
        s1 = choose(impacts, get(RockingField::sine_alpha), s1);
        c1 = choose(impacts, get(RockingField::cosine_alpha), c1);
        index1 = choose(impacts, index, index1);
        tau1 = choose(impacts, min(dt, fma(u, length, tau)), tau1);
        start1 = choose(impacts, one, zero);
        taken = taken | impacts;
        put(RockingField::side, choose(impacts, -side, side));
        put(RockingField::impact_spin,
            choose(impacts, max(approach, get(RockingField::impact_spin)), get(RockingField::impact_spin)));
        put(RockingField::impacts, choose(impacts, get(RockingField::impacts) + 1.0, get(RockingField::impacts)));
    }
    M const stays = !taken;
    energy1 = max(energy1, max(crest_energy, choose(free_share < share, free_energy, zero)));
    M const demands = without(here.friction > demand1 * here.normal, stays);
    if (any(demands)) {
        demand1 = choose(demands, here.friction / here.normal, demand1);
    }
    if (M const higher = without(max(phi1, crest) > peak, stays); any(higher)) {
        M const inside = crest > phi1;
        V const after = choose(inside, crest_share * length, fma(index1 - index, dt, tau1 - tau));
        put(RockingField::peak_time, choose(higher, fma(index, dt, tau + after), get(RockingField::peak_time)));
        put(RockingField::peak, choose(higher, max(phi1, crest), peak));
    }
    bool const some_stay = any(stays);
    auto const keep = [&](RockingField field, V now)
                          HWY_ATTR { put(field, some_stay ? choose(stays, get(field), now) : now); };
    keep(RockingField::phi, phi1);
    keep(RockingField::omega, omega1);
    keep(RockingField::sine, s1);
    keep(RockingField::cosine, c1);
    keep(RockingField::index, index1);
    keep(RockingField::tau, tau1);
    keep(RockingField::start, start1);
    keep(RockingField::energy, energy1);
    keep(RockingField::demand, demand1);
    keep(RockingField::normal, normal1);
    keep(RockingField::steps, get(RockingField::steps) + 1.0);

    if (shown != nullptr) {
        shown->length_s = length.first();
        shown->share = share.first();
        for (int k = 0; k < order; ++k) {
            shown->rates[k] = rate[k].first();
        }
        for (int k = 0; k < trig; ++k) {
            shown->sine[k] = x.s[k].first();
            shown->cosine[k] = x.c[k].first();
        }
        shown->horizontal = {a.start.first(), a.change.first()};
        shown->vertical = {g.start.first(), g.change.first()};
    }
    return stays | (index1 >= get(RockingField::last)) | (tau1 >= dt);
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
