// The arithmetic of one step of rocking, in any vector width. Included once per instruction set, so without a
// #pragma once; by lane_step.cpp only.
#if defined(OVERTURN_LANE_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANE_STEP
#undef OVERTURN_LANE_STEP
#else
#define OVERTURN_LANE_STEP
#endif

#include "rocking/detail/block_laws.hpp"
#include "rocking/detail/lane_bounds-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

template <class V, int Stride, bool Vertical> class Stepper : private LaneBounds<V, Stride, Vertical> {
  public:
    using Base = LaneBounds<V, Stride, Vertical>;
    using Path = typename Base::Path;
    using M = typename Base::M;
    using Base::Base;

    // Returns the lanes that need care. Those that took no step are unchanged.
    OVERTURN_LANES_INLINE M step(LaneStep* shown);

  private:
    using Base::forces;
    using Base::get;
    using Base::order;
    using Base::put;
    using Base::shaking_pull_of;
    using Base::trig;
    using typename Base::Bounds;
    using typename Base::Forces;
    using typename Base::Forcing;
    using typename Base::Landing;
    using typename Base::Plan;
    using typename Base::Series;
    using typename Base::Target;

    // The highest rotation inside a step, and two energies that may be the highest: where the block turns, and where
    // the shaking's power changes its sign.
    struct StepPeaks {
        V phi, energy, share;
        V free_energy, free_share;
    };
    // What the step leaves; of the lanes that take it.
    struct After {
        V phi, omega, s, c, index, tau, start;
        V energy, demand, normal;
        V share;  // of the step that was taken
        M taken;
    };

    OVERTURN_LANES_INLINE V energy_here(Plan const& plan) const;
    OVERTURN_LANES_INLINE StepPeaks peaks_of(Plan const& plan, Bounds const& bounds, V energy, M& fine) const;
    OVERTURN_LANES_INLINE After at_end(Plan const& plan, V energy, Forces const& here) const;
    OVERTURN_LANES_INLINE void apply_impacts(Plan const& plan, M started, M impacts, After& after);
    OVERTURN_LANES_INLINE void write(Plan const& plan, StepPeaks const& peaks, Forces const& here, After& after);
    static OVERTURN_LANES_INLINE void show(Plan const& plan, After const& after, LaneStep& shown);
    OVERTURN_LANES_INLINE V power_over_cosine(V u, Plan const& plan) const;
    OVERTURN_LANES_INLINE V energy_at(V u, Plan const& plan) const;
};

// The shaking's power over -phi' cos psi, (Gv - 1) tan psi + A: almost linear in time.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V Stepper<V, Stride, Vertical>::power_over_cosine(V u, Plan const& plan) const {
    V const across = fma(plan.a.change, u, plan.a.start);
    if constexpr (Vertical) {
        auto const [s, c] = this->turned(plan.x, this->gain(u, plan.x));
        return fma(fma(plan.g.change, u, plan.g.start) - 1.0, s / c, across);
    }
    return across;
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V Stepper<V, Stride, Vertical>::energy_at(V u, Plan const& plan) const {
    V const rate = Path::at(u, plan.x.rate) / (get(RockingField::p) * plan.length);
    return rocking_energy(rate, this->turned(plan.x, this->gain(u, plan.x)).c - get(RockingField::cosine_alpha));
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V Stepper<V, Stride, Vertical>::energy_here(Plan const& plan) const {
    return rocking_energy(plan.omega * get(RockingField::inverse_p), plan.c - get(RockingField::cosine_alpha));
}

// Energy is stationary where the block turns and where the shaking's power changes its sign. A path that bends one way
// turns once at most; what may turn twice, or up, is left to the scalar step where it could hide a record.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto Stepper<V, Stride, Vertical>::peaks_of(Plan const& plan, Bounds const& bounds, V energy,
                                                                  M& fine) const -> StepPeaks {
    V const zero = 0;
    V const one = 1;
    Forcing const& a = plan.a;
    Forcing const& g = plan.g;
    V const rate = plan.x.rate[0];
    V const down = Vertical ? g.start - 1.0 : zero;
    V const down_end = Vertical ? g.end - 1.0 : zero;
    // |phi - phi(0)| <= arc; and energy changes by the shaking's share of the pull along it.
    M const may_be_highest = plan.phi + bounds.arc > get(RockingField::peak);
    V const work = bounds.arc * (Vertical ? bounds.across + max(abs(down), abs(down_end)) : bounds.across);
    M const may_have_most = energy + work > get(RockingField::energy);
    M const may_turn_twice =
        without(without((bounds.slowest <= zero) & (bounds.fastest >= zero), bounds.concave), bounds.convex);
    // Beyond alpha energy may have a maximum where a fall back turns into a rise.
    M const may_turn_up = may_have_most & (rate < zero) & (plan.to.speed > zero);
    fine = without(fine, (may_turn_twice & (may_be_highest | may_have_most)) | may_turn_up);
    M const turns = fine & (may_be_highest | may_have_most) & (rate > zero) & (plan.to.speed <= zero);
    StepPeaks peaks{zero, zero, one, zero, one};
    if (any(turns)) {
        auto const [u, found] = this->turning(plan.x);
        fine = without(fine, without(turns, found));
        V const gain = this->gain(u, plan.x);
        peaks.phi = choose(turns, plan.phi + gain, zero);
        peaks.energy = choose(turns, this->turned(plan.x, gain).c - get(RockingField::cosine_alpha), zero);
        peaks.share = choose(turns, u, one);
    }
    V const power = shaking_pull_of(g.start, a.start, plan.s, plan.c);
    V const power_end = shaking_pull_of(g.end, a.end, plan.to.s, plan.to.c);
    M const power_turns = fine & may_have_most & (power * power_end < zero);
    if (any(power_turns)) {  // by regula falsi, twice
        V const here = Vertical ? fma(down, plan.s / plan.c, a.start) : a.start;
        V const fall = here - (Vertical ? fma(down_end, plan.to.s / plan.to.c, a.end) : a.end);
        V const u = here / fall;
        peaks.free_share = choose(power_turns, max(zero, min(one, u + power_over_cosine(u, plan) / fall)), one);
        peaks.free_energy = choose(power_turns, energy_at(peaks.free_share, plan), zero);
    }
    return peaks;
}

// The sample's end, where nothing happens on the way.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto Stepper<V, Stride, Vertical>::at_end(Plan const& plan, V energy, Forces const& here) const
    -> After {
    V const zero = 0;
    return {plan.to.phi,
            plan.to.speed / plan.length,  // times its inverse would round the same way in every step
            plan.to.s,
            plan.to.c,
            get(RockingField::index) + 1.0,
            zero,
            zero,
            max(get(RockingField::energy), energy),
            get(RockingField::demand),
            min(here.normal, get(RockingField::normal)),
            1,
            zero > zero};  // NOLINT(misc-redundant-expression): no lane
}

// Guard: phi falls through zero, and what follows is no settling: the rebound is not slow, or slow but its bouncing
// lasts longer than the sample does, by the corner that holds it least; and the other corner sticks.
// Reset: omega -> e omega on the other corner.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE void Stepper<V, Stride, Vertical>::apply_impacts(Plan const& plan, M started, M impacts,
                                                                       After& after) {
    V const zero = 0;
    V const one = 1;
    V const length = plan.length;
    auto const [u, found] = this->first_zero(plan.x, started);
    V const approach = -Path::at(u, plan.x.rate) / length;
    V const rebound = get(RockingField::restitution) * approach;
    V const gv = Vertical ? fma(plan.g.change, u, plan.g.start) : one;
    V const av = fma(plan.a.change, u, plan.a.start);
    V const hold = gv * get(RockingField::uplift_ratio) - abs(av);
    V const settle = get(RockingField::settle_speed);
    M const lasts = (rebound > settle * rest_speed_share)
                    & (rebound * get(RockingField::settle_rate) > fma(-u, length, length) * hold);
    impacts = impacts & found & ((rebound > settle) | lasts) & (u > zero) & (u < one)
              & (get(RockingField::impact_demand) <= get(RockingField::friction_limit));
    V const rate = approach * get(RockingField::inverse_p);
    after.energy = choose(impacts, max(after.energy, rocking_energy(rate, zero)), after.energy);
    after.demand = choose(impacts, max(after.demand, get(RockingField::impact_demand)), after.demand);
    auto const before = forces(get(RockingField::sine_alpha), get(RockingField::cosine_alpha), approach, av, gv);
    after.normal = choose(impacts, min(after.normal, before.normal), after.normal);
    after.demand = choose(impacts & (before.friction > after.demand * before.normal), before.friction / before.normal,
                          after.demand);
    after.share = choose(impacts, u, one);
    after.phi = choose(impacts, zero, after.phi);
    after.omega = choose(impacts, rebound, after.omega);
    after.s = choose(impacts, get(RockingField::sine_alpha), after.s);
    after.c = choose(impacts, get(RockingField::cosine_alpha), after.c);
    after.index = choose(impacts, get(RockingField::index), after.index);
    after.tau = choose(impacts, min(get(RockingField::time_step), fma(u, length, get(RockingField::tau))), after.tau);
    after.start = choose(impacts, one, zero);
    after.taken = after.taken | impacts;
    put(RockingField::side, choose(impacts, -plan.side, plan.side));
    V const fastest = get(RockingField::impact_spin);
    put(RockingField::impact_spin, choose(impacts, max(approach, fastest), fastest));
    V const count = get(RockingField::impacts);
    put(RockingField::impacts, choose(impacts, count + 1.0, count));
}

// Of the lanes that take the step: where they stand, and their records.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE void Stepper<V, Stride, Vertical>::write(Plan const& plan, StepPeaks const& peaks,
                                                               Forces const& here, After& after) {
    M const stays = !after.taken;
    after.energy =
        max(after.energy, max(peaks.energy, choose(peaks.free_share < after.share, peaks.free_energy, V(0))));
    M const demands = without(here.friction > after.demand * here.normal, stays);
    if (any(demands)) {
        after.demand = choose(demands, here.friction / here.normal, after.demand);
    }
    V const peak = get(RockingField::peak);
    if (M const higher = without(max(after.phi, peaks.phi) > peak, stays); any(higher)) {
        V const index = get(RockingField::index);
        V const tau = get(RockingField::tau);
        V const dt = get(RockingField::time_step);
        M const inside = peaks.phi > after.phi;
        V const since = choose(inside, peaks.share * plan.length, fma(after.index - index, dt, after.tau - tau));
        put(RockingField::peak_time, choose(higher, fma(index, dt, tau + since), get(RockingField::peak_time)));
        put(RockingField::peak, choose(higher, max(after.phi, peaks.phi), peak));
        put(RockingField::peak_side, choose(higher, plan.side, get(RockingField::peak_side)));
    }
    bool const some_stay = any(stays);
    auto const keep = [&](RockingField field, V now)
                          HWY_ATTR { put(field, some_stay ? choose(stays, get(field), now) : now); };
    keep(RockingField::phi, after.phi);
    keep(RockingField::omega, after.omega);
    keep(RockingField::sine, after.s);
    keep(RockingField::cosine, after.c);
    keep(RockingField::index, after.index);
    keep(RockingField::tau, after.tau);
    keep(RockingField::start, after.start);
    keep(RockingField::energy, after.energy);
    keep(RockingField::demand, after.demand);
    keep(RockingField::normal, after.normal);
    keep(RockingField::steps, get(RockingField::steps) + 1.0);
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE void Stepper<V, Stride, Vertical>::show(Plan const& plan, After const& after, LaneStep& shown) {
    shown.length_s = plan.length.first();
    shown.share = after.share.first();
    for (int k = 0; k < order; ++k) {
        shown.rates[k] = plan.x.rate[k].first();
    }
    for (int k = 0; k < trig; ++k) {
        shown.sine[k] = plan.x.s[k].first();
        shown.cosine[k] = plan.x.c[k].first();
    }
    shown.horizontal = {plan.a.start.first(), plan.a.change.first()};
    shown.vertical = {plan.g.start.first(), plan.g.change.first()};
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto Stepper<V, Stride, Vertical>::step(LaneStep* shown) -> M {
    V const one = 1;
    V const index = get(RockingField::index);
    V const tau = get(RockingField::tau);
    V const scale = get(RockingField::scale);
    V const length = get(RockingField::time_step) - tau;
    V const into = tau * get(RockingField::sampling_rate);
    V const side = get(RockingField::side);
    Forcing const a = this->forcing(RockingWave::horizontal, side * scale, index, into);
    Forcing g{one, 0, one};
    if constexpr (Vertical) {
        g = this->forcing(RockingWave::vertical, scale, index, into);
        g.start = g.start + 1.0;
        g.end = g.end + 1.0;
    }
    V const ph = get(RockingField::p) * length;
    V const w = ph * ph;
    Series const x = this->expand(length, w, a, g);
    Target const to = this->target(x);
    Plan const plan{side, length, a, g, ph, w, x, get(RockingField::phi), get(RockingField::omega), x.s[0], x.c[0], to};
    Bounds const bounds = this->bounds_of(plan);
    Landing const landing = this->landing_of(plan, bounds);
    // The series is sound: its last terms are small (as in step_length), its sums exact. A fall is out of reach.
    auto const& rate = plan.x.rate;
    V const last_terms = max(abs(rate[order - 1]), abs(rate[order - 2]) * plan.ph);
    M fine = (last_terms <= get(RockingField::tolerance)) & (bounds.arc <= most_arc)
             & (plan.to.phi < overturned_rad - most_arc);
    V const energy = energy_here(plan);
    StepPeaks const peaks = peaks_of(plan, bounds, energy, fine);
    Forces const here = forces(plan.s, plan.c, plan.omega, plan.a.start, plan.g.start);
    fine = fine & this->contact_holds(plan, bounds, here);

    After after = at_end(plan, energy, here);
    after.taken = landing.clear & fine;
    if (M const impacts = landing.lands & fine; any(impacts)) {
        apply_impacts(plan, landing.started, impacts, after);
    }
    write(plan, peaks, here, after);
    if (shown != nullptr) {
        show(plan, after, *shown);
    }
    return (!after.taken) | (after.index >= get(RockingField::last)) | (after.tau >= get(RockingField::time_step));
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
