// What the points of a base do to a body in space, in any vector width. Included once per instruction set, so without a
// #pragma once; by spatial_step-inl.hpp only.
#if defined(OVERTURN_POINT_FORCE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_POINT_FORCE
#undef OVERTURN_POINT_FORCE
#else
#define OVERTURN_POINT_FORCE
#endif

#include <bitset>

#include "contact/point_law-inl.hpp"
#include "simd/lanes-inl.hpp"
#include "spatial/detail/spatial_body-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

template <class V, int Stride> class PointForce : protected SpatialBody<V, Stride> {
  public:
    static constexpr bool shears = false;  ///< its points have anchors, Motion::shear has no part in it

    using Body = SpatialBody<V, Stride>;
    using typename Body::Base;
    using typename Body::Depths;
    using typename Body::Line;
    using typename Body::M;
    using typename Body::Motion;
    using typename Body::Pull;
    using typename Body::Shaking;

    explicit PointForce(SpatialLanes<Stride>& lanes)
        : Body(lanes), bed_(lanes.bed.data()), points_(lanes.points), opposite_(lanes.opposite), of_rim_(lanes.of_rim) {
        remembered_.set();  // complete() ended the steps before: every point is up to date
    }

    /// Brings up to date the points that the last step did not ask for. Needed before a lane is read from outside.
    void complete();

  protected:
    using Body::get;
    using Body::pull_of;
    using Body::row;

    /// Starts a step. What points remember is brought up to date at this state, for each point when the step first
    /// asks for it.
    [[nodiscard]] Depths begin(Motion& start);
    /// At the state of begin. To be called before `now`.
    [[nodiscard]] Pull at_start(Motion const& start, Shaking const& by) { return pulled<true>(start_, start, by); }
    [[nodiscard]] Pull now(Motion const& at, Shaking const& by) {
        return pulled<false>(base_of(at, get(State::height)), at, by);
    }
    [[nodiscard]] Base const& base_at_start() const { return start_; }

  private:
    /// Displacements and rates that press and drag points: depth, approach, and horizontal force over stiffness but for
    /// the anchor's share.
    struct Grips {
        Line depth, approach, x, y;
    };
    using typename Body::Sums;

    [[nodiscard]] double* point(int i) const { return bed_ + i * row(Spot::count); }
    [[nodiscard]] static OVERTURN_LANES_INLINE V spot(double const* point, Spot field) {
        return V::load(point + row(field));
    }
    static OVERTURN_LANES_INLINE void set_spot(double* point, Spot field, V value) { value.store(point + row(field)); }

    [[nodiscard]] OVERTURN_LANES_INLINE Line spring(Line const& way, Line const& rate) const;
    [[nodiscard]] static OVERTURN_LANES_INLINE V over(double const* point, Line const& line) {
        return line.of(spot(point, Spot::x), spot(point, Spot::y));
    }
    [[nodiscard]] static OVERTURN_LANES_INLINE V depth_of(double const* point, Base const& base) {
        return over(point, base.depth) - spot(point, Spot::crush);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE V normal_of(double const* point, V depth, V approach) const;
    V remember(int i);
    OVERTURN_LANES_INLINE void remember_anchor(double* place, V most);
    template <bool AtStart> OVERTURN_LANES_INLINE bool press(int i, Grips const& grips, Triple<V>& force);
    template <bool AtStart> [[nodiscard]] Pull pulled(Base const& base, Motion const& at, Shaking const& by);

    double* bed_;
    int points_;
    bool opposite_, of_rim_;
    Base start_;
    std::bitset<most_spatial_points> remembered_;  // in this step
};

// Horizontal force of springs and dampers against a displacement and its rate, over the stiffness.
template <class V, int Stride>
OVERTURN_LANES_INLINE auto PointForce<V, Stride>::spring(Line const& way, Line const& rate) const -> Line {
    V const ratio = -get(State::tangential_ratio);
    V const drag = -get(State::tangential_damping);
    return {fma(ratio, way.by_x, drag * rate.by_x), fma(ratio, way.by_y, drag * rate.by_y),
            fma(ratio, way.at, drag * rate.at)};
}

template <class V, int Stride>
OVERTURN_LANES_INLINE V PointForce<V, Stride>::normal_of(double const* point, V depth, V approach) const {
    if (of_rim_) {
        return contact::HWY_NAMESPACE::element_depth(depth, approach, spot(point, Spot::yield), get(State::damping),
                                                     get(State::stiffness));
    }
    return contact::HWY_NAMESPACE::normal_depth(depth, approach, spot(point, Spot::yield), spot(point, Spot::gain),
                                                get(State::most_damping));
}

// The approach speed until it touches; the crush that it leaves; an anchor that friction cannot hold follows its point.
// Returns the normal force there, over the stiffness.
template <class V, int Stride> V PointForce<V, Stride>::remember(int i) {
    remembered_.set(static_cast<std::size_t>(i));
    double* const place = point(i);
    V const zero = 0;
    V const depth = depth_of(place, start_);
    V const approach = over(place, start_.approach);
    if (M const away = depth <= zero; any(away)) {
        V const fresh =
            contact::HWY_NAMESPACE::gain_of_approach(approach, get(State::damping), get(State::least_approach));
        set_spot(place, Spot::gain, choose(away, fresh, spot(place, Spot::gain)));
    }
    V const normal = normal_of(place, depth, approach);
    if (V const excess = depth - spot(place, Spot::yield); any(excess > zero)) {
        set_spot(place, Spot::crush, spot(place, Spot::crush) + max(excess, zero));
    }
    remember_anchor(place, get(State::hold) * normal);
    return normal;
}

template <class V, int Stride>
OVERTURN_LANES_INLINE void PointForce<V, Stride>::remember_anchor(double* place, V most) {
    V const x = over(place, start_.x);
    V const y = over(place, start_.y);
    V const shift_x = x - spot(place, Spot::anchor_x);
    V const shift_y = y - spot(place, Spot::anchor_y);
    V const square = fma(shift_x, shift_x, shift_y * shift_y);
    if (M const drags = square > most * most; any(drags)) {
        V const share = most / sqrt(square);
        set_spot(place, Spot::anchor_x, choose(drags, x - share * shift_x, spot(place, Spot::anchor_x)));
        set_spot(place, Spot::anchor_y, choose(drags, y - share * shift_y, spot(place, Spot::anchor_y)));
    }
}

// A point that touches now but did not in the last step has not been asked for there: it is brought up to date as of
// that step's start, where it was away.
template <class V, int Stride> auto PointForce<V, Stride>::begin(Motion& start) -> Depths {
    auto const base = base_of(start, get(State::height));
    Depths all{1e300, -1e300};
    for (int i = 0; i < points_; ++i) {
        V const reach = over(point(i), base.depth);
        V const depth = reach - spot(point(i), Spot::crush);
        all.least = min(depth, all.least);
        all.most = max(reach, all.most);
        if (!remembered_[i] && any(depth > V(0))) {
            static_cast<void>(remember(i));
        }
    }
    start_ = base;
    remembered_.reset();
    return all;
}

template <class V, int Stride> void PointForce<V, Stride>::complete() {
    for (int i = 0; i < points_; ++i) {
        if (!remembered_[i]) {
            static_cast<void>(remember(i));
        }
    }
}

// A point that touches the ground in no lane presses nothing, and is not brought up to date for it.
template <class V, int Stride>
template <bool AtStart>
OVERTURN_LANES_INLINE bool PointForce<V, Stride>::press(int i, Grips const& grips, Triple<V>& force) {
    double* const place = point(i);
    V const zero = 0;
    V const depth = over(place, grips.depth);
    if (!any(depth - spot(place, Spot::crush) > zero)) {
        force = {zero, zero, zero};
        return false;
    }
    V normal;
    if constexpr (AtStart) {
        normal = remember(i);
    } else {
        if (!remembered_[i]) {
            static_cast<void>(remember(i));
        }
        normal = normal_of(place, depth - spot(place, Spot::crush), over(place, grips.approach));
    }
    V const ratio = get(State::tangential_ratio);
    V held_x = fma(ratio, spot(place, Spot::anchor_x), over(place, grips.x));
    V held_y = fma(ratio, spot(place, Spot::anchor_y), over(place, grips.y));
    V const limit = get(State::friction) * normal;
    V const length = fma(held_x, held_x, held_y * held_y);
    if (M const slips = length > limit * limit; any(slips)) {
        V const share = choose(slips, limit / sqrt(length), V(1));
        held_x = share * held_x;
        held_y = share * held_y;
    }
    force = spot(place, Spot::stiffness) * Triple<V>{held_x, held_y, normal};
    return true;
}

// Points come in pairs whose sums are made first, unfused: on opposite points of a symmetric base what both do equally
// cancels to the last bit, and mirrored motions are mirrored.
template <class V, int Stride>
template <bool AtStart>
auto PointForce<V, Stride>::pulled(Base const& base, Motion const& at, Shaking const& by) -> Pull {
    Grips const grips{base.depth, base.approach, spring(base.x, base.x_rate), spring(base.y, base.y_rate)};
    V const zero = 0;
    Triple<V> const none{zero, zero, zero};
    Sums sums{none, none, none};
    for (int i = 0; i < points_; i += 2) {
        Triple<V> one;
        Triple<V> other;
        bool const first = press<AtStart>(i, grips, one);
        bool const second = press<AtStart>(i + 1, grips, other);
        if (!first && !second) {
            continue;
        }
        V const x = spot(point(i), Spot::x);
        V const y = spot(point(i), Spot::y);
        sums.all = sums.all + (one + other);
        if (opposite_) {
            auto const turning = one - other;
            sums.by_x = sums.by_x + x * turning;
            sums.by_y = sums.by_y + y * turning;
        } else {
            sums.by_x = sums.by_x + (x * one + spot(point(i + 1), Spot::x) * other);
            sums.by_y = sums.by_y + (y * one + spot(point(i + 1), Spot::y) * other);
        }
    }
    return pull_of(sums, at, by);
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
