// How a disc or a ring presses, in any vector width. Included once per instruction set, so without a #pragma once; by
// spatial_step-inl.hpp only.
#if defined(OVERTURN_FACE_PRESSURE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_FACE_PRESSURE
#undef OVERTURN_FACE_PRESSURE
#else
#define OVERTURN_FACE_PRESSURE
#endif

#include <array>
#include <cstddef>
#include <numbers>

#include "simd/lanes-inl.hpp"
#include "spatial/detail/arc-inl.hpp"
#include "spatial/detail/continuous_base-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// A face, which is a disc or a ring, presses as a rim does, but per area: beyond the chord at which its depth is 0.
template <class V, int Stride> class FacePressure : protected ContinuousBase<V, Stride> {
  public:
    using Common = ContinuousBase<V, Stride>;
    using typename Common::Base;

  protected:
    using Common::get;
    using Common::lean_of;
    using typename Common::Patch;

    explicit FacePressure(SpatialLanes<Stride>& lanes) : Common(lanes) {}
    [[nodiscard]] OVERTURN_LANES_INLINE Patch patch_of(Base const& base) const;

  private:
    using typename Common::Damping;  // over k and the radius squared
    using typename Common::Lean;

    /// Over what touches, of depth and of depth times x, and times the squared distance from the middle: in closed
    /// form. x towards the lowest point.
    struct Segment {
        V depths, first_moment, polar_moment;
    };

    [[nodiscard]] OVERTURN_LANES_INLINE V damped_share(V depth, V approach) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Segment segment_of(V middle, V slope, V radius, Arc<V> const& arc) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Damping damping_of(Base const& base, Lean const& lean, V arc, V even) const;
};

// y d' / sqrt(d'^2 + w^2 d^2): of an element, over its depth, which never pulls.
template <class V, int Stride>
OVERTURN_LANES_INLINE V FacePressure<V, Stride>::damped_share(V depth, V approach) const {
    constexpr double least = 1e-300;
    V const square = fma(get(State::stiffness) * depth, depth, approach * approach);
    return max(get(State::damping) * (approach / sqrt(max(square, V(least)))), V(-1));
}

// Of the disc of this radius beyond its chord at the angle p = arc.all: with s and c its sine and cosine the integrals
// of 1, x, x^2 + y^2 and x (x^2 + y^2).
template <class V, int Stride>
OVERTURN_LANES_INLINE auto FacePressure<V, Stride>::segment_of(V middle, V slope, V radius, Arc<V> const& arc) const
    -> Segment {
    V const s = arc.sine;
    V const square = s * s;
    V const product = s * arc.cosine;
    V const both = product * (1.0 - (square + square));
    V const cube = s * square;
    V const area = arc.all - product;
    V const along = (2.0 / 3) * cube;
    V const along_square = 0.25 * (arc.all - both);
    V const across_square = fma(both, 1.0 / 12, 0.25 * arc.all - (1.0 / 3) * product);
    V const along_polar = cube * (2.0 / 3 - (4.0 / 15) * square);
    V const rise = slope * radius;
    V const radius2 = radius * radius;
    return {radius2 * fma(middle, area, rise * along), radius2 * radius * fma(middle, along, rise * along_square),
            radius2 * radius2 * fma(middle, along_square + across_square, rise * along_polar)};
}

// What damping differs by from `even`, its share of the depth at the centre of pressure, which is all of it in a flat
// drop. By chords at Gauss nodes of their angle, before, within and past the hole, and four nodes across each.
template <class V, int Stride>
OVERTURN_LANES_INLINE auto FacePressure<V, Stride>::damping_of(Base const& base, Lean const& lean, V arc, V even) const
    -> Damping {
    constexpr std::array places{0.06943184420297371, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
    constexpr std::array weights{0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};
    constexpr double near = 0.2113248654051871;  // of two Gauss nodes
    constexpr double far = 0.7886751345948129;
    V const zero = 0;
    V const radius = get(State::edge);
    V const along = radius * (base.approach.by_x * lean.x + base.approach.by_y * lean.y);
    V const across = radius * (base.approach.by_y * lean.x - base.approach.by_x * lean.y);
    V const hole2 = get(State::hole) * get(State::hole);
    Damping sum{zero, zero, zero};
    auto const add_chord = [&](V angle, V weight) HWY_ATTR {
        V const half_sine = sine_of(0.5 * angle);
        V const square = half_sine * half_sine;
        V const x = 1.0 - (square + square);
        V const wide = 2.0 * (half_sine * sqrt(max(1.0 - square, zero)));
        V const narrow = sqrt(max(hole2 - x * x, zero));
        V const length = max(wide - narrow, zero);
        V const depth = max(fma(lean.change, x, base.depth.at), zero);
        V const middle = fma(along, x, base.approach.at);
        auto const at = [&](double place) HWY_ATTR {
            V const y = fma(length, place, narrow);
            V const one = damped_share(depth, fma(across, y, middle)) - even;
            V const other = damped_share(depth, middle - across * y) - even;
            return Damping{one + other, x * (one + other), y * (one - other)};
        };
        auto const a = at(near);
        auto const b = at(far);
        V const share = weight * wide * (0.5 * length) * depth;
        sum = {fma(share, a.press + b.press, sum.press), fma(share, a.along + b.along, sum.along),
               fma(share, a.across + b.across, sum.across)};
    };
    auto const add_chords = [&](V from, V to) HWY_ATTR {
        if (V const wide = to - from; any(wide > zero)) {
            for (std::size_t i = 0; i < places.size(); ++i) {
                add_chord(fma(wide, places[i], from), weights[i] * wide);
            }
        }
    };
    V const near_hole = min(arc, get(State::hole_arc));
    V const past_hole = min(arc, std::numbers::pi - get(State::hole_arc));
    add_chords(zero, near_hole);
    add_chords(near_hole, past_hole);
    add_chords(past_hole, arc);
    return sum;
}

template <class V, int Stride>
OVERTURN_LANES_INLINE auto FacePressure<V, Stride>::patch_of(Base const& base) const -> Patch {
    V const zero = 0;
    auto const lean = lean_of(base);
    V const radius = get(State::edge);
    V const hole = get(State::hole) * radius;
    V const slope = lean.change / radius;
    auto const arc = arc_of(base.depth.at, lean.change);
    auto const all = segment_of(base.depth.at, slope, radius, arc);
    auto const none = segment_of(base.depth.at, slope, hole, arc_of(base.depth.at, slope * hole));
    V const depths = max(all.depths - none.depths, zero);
    V const first = all.first_moment - none.first_moment;
    V const stiffness = get(State::ring);                                   // per area
    V const inner = min(max(first / (depths * radius), arc.cosine), V(1));  // beyond the chord, however near the edge
    V const lever = radius * inner;
    V const polar = (all.polar_moment - none.polar_moment) / depths;
    V press = stiffness * depths;
    V along = stiffness * first;
    V across = zero;
    if (any(arc.half > zero)) {
        V const here = max(fma(lean.change, inner, base.depth.at), zero);
        V const turning = base.approach.by_x * lean.x + base.approach.by_y * lean.y;
        V const even = damped_share(here, fma(turning, lever, base.approach.at));
        auto const damping = damping_of(base, lean, arc.all, even);
        V const share = stiffness * radius * radius;
        press = max(fma(share, damping.press, fma(press, even, press)), zero);
        along = fma(share * radius, damping.along, fma(along, even, along));
        across = share * radius * damping.across;
    }
    return {press,          along * lean.x - across * lean.y,      along * lean.y + across * lean.x, lever * lean.x,
            lever * lean.y, sqrt(max(polar - lever * lever, zero))};
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
