// What a continuous rim, disc or ring does to a body in space, in any vector width. Included once per instruction set,
// so without a #pragma once; by spatial_step-inl.hpp only.
#if defined(OVERTURN_RIM_FORCE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_RIM_FORCE
#undef OVERTURN_RIM_FORCE
#else
#define OVERTURN_RIM_FORCE
#endif

#include <array>
#include <cstddef>
#include <numbers>

#include "simd/lanes-inl.hpp"
#include "spatial/detail/arc-inl.hpp"
#include "spatial/detail/spatial_body-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// What of a continuous base bears.
enum class Bears : bool { rim, face };

/// A rim presses where it touches, evenly per length: its elastic force in closed form, its damping by Gauss nodes that
/// turn with the tilt, so that no direction differs from another. It grips as one patch at the centre of the elastic
/// pressure: springs that roll with it, by two displacements and a twist, up to mu N together.
/// A face, which is a disc or a ring, presses likewise per area: beyond the chord at which its depth is 0.
template <class V, int Stride, Bears bears> class RimForce : protected SpatialBody<V, Stride> {
  public:
    static constexpr bool shears = true;  ///< Motion::shear is what its springs are stretched by

    using Body = SpatialBody<V, Stride>;
    using typename Body::Base;
    using typename Body::Depths;
    using typename Body::Line;
    using typename Body::M;
    using typename Body::Motion;
    using typename Body::Pull;
    using typename Body::Shaking;

    explicit RimForce(SpatialLanes<Stride>& lanes) : Body(lanes) {}
    void complete() {}

  protected:
    using Body::get;
    using Body::pull_of;

    /// Starts a step: springs that friction cannot hold slip back to what it can.
    [[nodiscard]] OVERTURN_LANES_INLINE Depths begin(Motion& start);
    /// At the state of begin.
    [[nodiscard]] OVERTURN_LANES_INLINE Pull at_start(Motion const& start, Shaking const& by) {
        return pulled(patch_, start_, start, by);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE Pull now(Motion const& at, Shaking const& by) {
        auto const base = base_of(at, get(State::height));
        return pulled(patch_of(base), base, at, by);
    }
    [[nodiscard]] Base const& base_at_start() const { return start_; }

  private:
    using typename Body::Sums;

    /// Towards the lowest point, along the body's own axes, and how much lower than the middle that is.
    struct Lean {
        V x, y, change;
    };
    /// Pressure on the rim, and the place where it grips.
    struct Patch {
        V press;           // sum of the normal forces
        V by_x, by_y;      // of these times x and y of where they act
        V x, y, gyration;  // centre of the elastic pressure, radius of gyration about it
    };
    struct Node {
        V cosine, sine, weight;  // of phi, which stands for -phi as well
    };
    static constexpr std::size_t node_pairs = 4;
    /// Over what touches of a face, of depth and of depth times x, and times the squared distance from the middle: in
    /// closed form. x towards the lowest point.
    struct FaceSums {
        V depths, first_moment, polar_moment;
    };
    struct Damping {
        V press, along,
            across;  // of damping, over k pc / pi; moments over the radius, towards the lowest point and across
    };

    [[nodiscard]] OVERTURN_LANES_INLINE Lean lean_of(Base const& base) const;
    [[nodiscard]] OVERTURN_LANES_INLINE V damped(V depth, V approach) const;
    [[nodiscard]] static OVERTURN_LANES_INLINE std::array<Node, node_pairs> nodes_of(V half);
    [[nodiscard]] OVERTURN_LANES_INLINE Damping damping_of(Base const& base, Lean const& lean, V half) const;
    [[nodiscard]] OVERTURN_LANES_INLINE V damped_share(V depth, V approach) const;
    [[nodiscard]] OVERTURN_LANES_INLINE FaceSums segment_of(V middle, V slope, V radius, Arc<V> const& arc) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Damping damping_of_face(Base const& base, Lean const& lean, V arc,
                                                                V even) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Patch patch_of_face(Base const& base) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Patch patch_of(Base const& base) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Pull pulled(Patch const& patch, Base const& base, Motion const& at,
                                                    Shaking const& by) const;

    Base start_;
    Patch patch_;
};

// Upright it leans nowhere: there the way in which it begins to lean takes its place, so that what is done to the
// motion, a turn or a mirror, is done to the nodes.
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::lean_of(Base const& base) const -> Lean {
    V const zero = 0;
    V x = base.depth.by_x;
    V y = base.depth.by_y;
    V const slope = sqrt(x * x + y * y);
    V length = slope;
    if (M const upright = slope <= zero; any(upright)) {
        x = choose(upright, base.approach.by_x, x);
        y = choose(upright, base.approach.by_y, y);
        length = sqrt(x * x + y * y);
    }
    M const leans = length > zero;
    return {choose(leans, x / length, V(1)), choose(leans, y / length, zero), get(State::edge) * slope};
}

// y d d' / sqrt(d'^2 + w^2 d^2) of an element, which never pulls: homogeneous of degree one in depth and approach.
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE V RimForce<V, Stride, bears>::damped(V depth, V approach) const {
    constexpr double least = 1e-300;
    V const square = fma(get(State::stiffness) * depth, depth, approach * approach);
    return max(get(State::damping) * depth * (approach / sqrt(max(square, V(least)))), -depth);
}

// Gauss-Legendre on an arc; evenly spread round a rim that touches everywhere, where what is even cancels to the last
// bit. Cosine and sine of phi by those of its half.
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::nodes_of(V half) -> std::array<Node, node_pairs> {
    constexpr std::array places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr std::array weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    constexpr double far = 0.92387953251128676;   // cos(pi / 8)
    constexpr double near = 0.38268343236508977;  // sin(pi / 8)
    constexpr std::array cosines{far, near, -near, -far};
    constexpr std::array sines{near, far, far, near};
    std::array<Node, node_pairs> nodes;
    for (std::size_t i = 0; i < node_pairs; ++i) {
        V const half_sine = sine_of(places[i] * half);
        V const square = half_sine * half_sine;
        nodes[i] = {1.0 - (square + square), 2.0 * (half_sine * sqrt(1.0 - square)), V(weights[i])};
    }
    if (M const whole = half >= V(0.5 * std::numbers::pi); any(whole)) {
        for (std::size_t i = 0; i < node_pairs; ++i) {
            nodes[i] = {choose(whole, V(cosines[i]), nodes[i].cosine), choose(whole, V(sines[i]), nodes[i].sine),
                        choose(whole, V(1.0 / node_pairs), nodes[i].weight)};
        }
    }
    return nodes;
}

template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::damping_of(Base const& base, Lean const& lean, V half) const
    -> Damping {
    V const zero = 0;
    V const radius = get(State::edge);
    V const along = radius * (base.approach.by_x * lean.x + base.approach.by_y * lean.y);
    V const across = radius * (base.approach.by_y * lean.x - base.approach.by_x * lean.y);
    auto const nodes = nodes_of(half);
    auto const at = [&](Node const& node) HWY_ATTR {
        V const depth = max(fma(lean.change, node.cosine, base.depth.at), zero);
        V const middle = fma(along, node.cosine, base.approach.at);
        V const side = across * node.sine;
        V const one = damped(depth, middle + side);
        V const other = damped(depth, middle - side);
        V const both = node.weight * (one + other);
        return Damping{both, node.cosine * both, node.weight * (node.sine * (one - other))};
    };
    auto const with_opposite = [&](std::size_t i) HWY_ATTR {
        auto const a = at(nodes[i]);
        auto const b = at(nodes[node_pairs - 1 - i]);
        return Damping{a.press + b.press, a.along + b.along, a.across + b.across};
    };
    auto const outer = with_opposite(0);
    auto const inner = with_opposite(1);
    return {outer.press + inner.press, outer.along + inner.along, outer.across + inner.across};
}

// As damped, over the depth.
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE V RimForce<V, Stride, bears>::damped_share(V depth, V approach) const {
    constexpr double least = 1e-300;
    V const square = fma(get(State::stiffness) * depth, depth, approach * approach);
    return max(get(State::damping) * (approach / sqrt(max(square, V(least)))), V(-1));
}

// Of the disc of this radius beyond its chord at the angle p = arc.all: with s and c its sine and cosine the integrals
// of 1, x, x^2 + y^2 and x (x^2 + y^2).
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::segment_of(V middle, V slope, V radius, Arc<V> const& arc) const
    -> FaceSums {
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
template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::damping_of_face(Base const& base, Lean const& lean, V arc,
                                                                       V even) const -> Damping {
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

template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::patch_of_face(Base const& base) const -> Patch {
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
        auto const damping = damping_of_face(base, lean, arc.all, even);
        V const share = stiffness * radius * radius;
        press = max(fma(share, damping.press, fma(press, even, press)), zero);
        along = fma(share * radius, damping.along, fma(along, even, along));
        across = share * radius * damping.across;
    }
    return {press,          along * lean.x - across * lean.y,      along * lean.y + across * lean.x, lever * lean.x,
            lever * lean.y, sqrt(max(polar - lever * lever, zero))};
}

template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::patch_of(Base const& base) const -> Patch {
    if constexpr (bears == Bears::face) {
        return patch_of_face(base);
    }
    V const zero = 0;
    auto const lean = lean_of(base);
    auto const arc = arc_of(base.depth.at, lean.change);
    V const radius = get(State::edge);
    V const stiffness = 0.5 * get(State::ring);                                 // per radian
    V const inner = min(max(arc.first_moment / arc.depths, arc.cosine), V(1));  // within the arc, however short
    V press = stiffness * arc.depths;
    V along = stiffness * arc.first_moment;
    V across = zero;
    if (any(arc.half > zero)) {
        auto const damping = damping_of(base, lean, arc.half);
        V const share = stiffness * arc.all;
        press = max(fma(share, damping.press, press), zero);
        along = fma(share, damping.along, along);
        across = share * damping.across;
    }
    V const lever = radius * inner;
    return {press,
            radius * (along * lean.x - across * lean.y),
            radius * (along * lean.y + across * lean.x),
            lever * lean.x,
            lever * lean.y,
            radius * sqrt(1.0 - inner * inner)};
}

template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::begin(Motion& start) -> Depths {
    start_ = base_of(start, get(State::height));
    patch_ = patch_of(start_);
    V const most = get(State::hold) * patch_.press / get(State::stiffness);
    V const square = dot(start.shear, start.shear);
    if (M const slips = square > most * most; any(slips)) {
        V const share = choose(slips, most / sqrt(square), V(1));
        start.shear = share * start.shear;
    }
    V const change = lean_of(start_).change;
    return {start_.depth.at - change, start_.depth.at + change};
}

template <class V, int Stride, Bears bears>
OVERTURN_LANES_INLINE auto RimForce<V, Stride, bears>::pulled(Patch const& patch, Base const& base, Motion const& at,
                                                              Shaking const& by) const -> Pull {
    auto const [first, second, third] = axes_of(at.turn);
    V const turning = fma(first.z, at.spin.x, second.z * at.spin.y) + third.z * at.spin.z;
    Triple<V> const rate{base.x_rate.of(patch.x, patch.y), base.y_rate.of(patch.x, patch.y), patch.gyration * turning};
    V const spring = -get(State::tangential_ratio) * get(State::stiffness);
    V const drag = -get(State::tangential_damping) * get(State::stiffness);
    Triple<V> held = fma(spring, at.shear, drag * rate);
    V const limit = get(State::friction) * patch.press;
    V const square = dot(held, held);
    if (M const slips = square > limit * limit; any(slips)) {
        held = choose(slips, limit / sqrt(square), V(1)) * held;
    }
    Sums const sums{{held.x, held.y, patch.press},
                    {patch.x * held.x, patch.x * held.y, patch.by_x},
                    {patch.y * held.x, patch.y * held.y, patch.by_y}};
    auto pull = pull_of(sums, at, by);
    V const twist = patch.gyration * held.z;
    pull.spin = {fma(twist * first.z, get(State::mass_over_inertia_x), pull.spin.x),
                 fma(twist * second.z, get(State::mass_over_inertia_y), pull.spin.y),
                 fma(twist * third.z, get(State::mass_over_inertia_z), pull.spin.z)};
    pull.shear = rate;
    return pull;
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
