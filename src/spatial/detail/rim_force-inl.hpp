// What a continuous rim does to a body in space, in any vector width. Included once per instruction set, so without a
// #pragma once; by spatial_step-inl.hpp only.
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

/// A rim presses where it touches, evenly per length: its elastic force in closed form, its damping by Gauss nodes that
/// turn with the tilt, so that no direction differs from another. It grips as one patch at the centre of the elastic
/// pressure: springs that roll with it, by two displacements and a twist, up to mu N together.
template <class V, int Stride> class RimForce : protected SpatialBody<V, Stride> {
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
    struct Damping {
        V press, along,
            across;  // of damping, over k pc / pi; moments over the radius, towards the lowest point and across
    };

    [[nodiscard]] OVERTURN_LANES_INLINE Lean lean_of(Base const& base) const;
    [[nodiscard]] OVERTURN_LANES_INLINE V damped(V depth, V approach) const;
    [[nodiscard]] static OVERTURN_LANES_INLINE std::array<Node, node_pairs> nodes_of(V half);
    [[nodiscard]] OVERTURN_LANES_INLINE Damping damping_of(Base const& base, Lean const& lean, V half) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Patch patch_of(Base const& base) const;
    [[nodiscard]] OVERTURN_LANES_INLINE Pull pulled(Patch const& patch, Base const& base, Motion const& at,
                                                    Shaking const& by) const;

    Base start_;
    Patch patch_;
};

// Upright it leans nowhere: there the way in which it begins to lean takes its place, so that what is done to the
// motion, a turn or a mirror, is done to the nodes.
template <class V, int Stride> OVERTURN_LANES_INLINE auto RimForce<V, Stride>::lean_of(Base const& base) const -> Lean {
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
template <class V, int Stride> OVERTURN_LANES_INLINE V RimForce<V, Stride>::damped(V depth, V approach) const {
    constexpr double least = 1e-300;
    V const square = fma(get(State::stiffness) * depth, depth, approach * approach);
    return max(get(State::damping) * depth * (approach / sqrt(max(square, V(least)))), -depth);
}

// Gauss-Legendre on an arc; evenly spread round a rim that touches everywhere, where what is even cancels to the last
// bit. Cosine and sine of phi by those of its half.
template <class V, int Stride>
OVERTURN_LANES_INLINE auto RimForce<V, Stride>::nodes_of(V half) -> std::array<Node, node_pairs> {
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

template <class V, int Stride>
OVERTURN_LANES_INLINE auto RimForce<V, Stride>::damping_of(Base const& base, Lean const& lean, V half) const
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

template <class V, int Stride>
OVERTURN_LANES_INLINE auto RimForce<V, Stride>::patch_of(Base const& base) const -> Patch {
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

template <class V, int Stride> OVERTURN_LANES_INLINE auto RimForce<V, Stride>::begin(Motion& start) -> Depths {
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

template <class V, int Stride>
OVERTURN_LANES_INLINE auto RimForce<V, Stride>::pulled(Patch const& patch, Base const& base, Motion const& at,
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
