// How a continuous rim presses, in any vector width. Included once per instruction set, so without a #pragma once; by
// spatial_step-inl.hpp only.
#if defined(OVERTURN_RIM_PRESSURE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_RIM_PRESSURE
#undef OVERTURN_RIM_PRESSURE
#else
#define OVERTURN_RIM_PRESSURE
#endif

#include <array>
#include <cstddef>
#include <numbers>

#include "simd/lanes-inl.hpp"
#include "spatial/detail/arc-inl.hpp"
#include "spatial/detail/continuous_base-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// A rim presses where it touches, evenly per length: its elastic force in closed form, its damping by Gauss nodes that
/// turn with the tilt, so that no direction differs from another.
template <class V, int Stride> class RimPressure : protected ContinuousBase<V, Stride> {
  public:
    using Common = ContinuousBase<V, Stride>;
    using typename Common::Base;
    using typename Common::M;

  protected:
    using Common::get;
    using Common::lean_of;
    using typename Common::Patch;

    explicit RimPressure(SpatialLanes<Stride>& lanes) : Common(lanes) {}
    [[nodiscard]] OVERTURN_LANES_INLINE Patch patch_of(Base const& base) const;

  private:
    using typename Common::Damping;  // over k pc / pi
    using typename Common::Lean;

    struct Node {
        V cosine, sine, weight;  // of phi, which stands for -phi as well
    };
    static constexpr std::size_t node_pairs = 4;

    [[nodiscard]] OVERTURN_LANES_INLINE V damped(V depth, V approach) const;
    [[nodiscard]] static OVERTURN_LANES_INLINE std::array<Node, node_pairs> nodes_of(V half);
    [[nodiscard]] OVERTURN_LANES_INLINE Damping damping_of(Base const& base, Lean const& lean, V half) const;
};

// y d d' / sqrt(d'^2 + w^2 d^2) of an element, which never pulls: homogeneous of degree one in depth and approach.
template <class V, int Stride> OVERTURN_LANES_INLINE V RimPressure<V, Stride>::damped(V depth, V approach) const {
    constexpr double least = 1e-300;
    V const square = fma(get(State::stiffness) * depth, depth, approach * approach);
    return max(get(State::damping) * depth * (approach / sqrt(max(square, V(least)))), -depth);
}

// Gauss-Legendre on an arc; evenly spread round a rim that touches everywhere, where what is even cancels to the last
// bit. Cosine and sine of phi by those of its half.
template <class V, int Stride>
OVERTURN_LANES_INLINE auto RimPressure<V, Stride>::nodes_of(V half) -> std::array<Node, node_pairs> {
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
OVERTURN_LANES_INLINE auto RimPressure<V, Stride>::damping_of(Base const& base, Lean const& lean, V half) const
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
OVERTURN_LANES_INLINE auto RimPressure<V, Stride>::patch_of(Base const& base) const -> Patch {
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

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
