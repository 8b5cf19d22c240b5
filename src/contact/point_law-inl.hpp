// How one point presses and what it remembers, in any vector width: the one law of the planar and the spatial code.
// Included once per instruction set, so without a #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_POINT_LAW) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_POINT_LAW
#undef OVERTURN_POINT_LAW
#else
#define OVERTURN_POINT_LAW
#endif

#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

/// Depth of the spring, which yields from `yield` on. [length]
template <class V> OVERTURN_LANES_INLINE V elastic_depth(V depth, V yield) { return min(max(depth, V(0)), yield); }

/// Force over stiffness: elastic up to the yield depth, damped in proportion to it up to a cap, never a pull (after
/// Hunt & Crossley 1975). \param gain y / v, v the approach speed at touch \param cap of damping, y / w_v
template <class V> OVERTURN_LANES_INLINE V normal_depth(V depth, V approach, V yield, V gain, V cap) {
    V const elastic = elastic_depth(depth, yield);
    V const damping = min(gain * elastic, cap);
    return max(fma(damping, approach, elastic), V(0));
}

/// The same of an element of a rim, homogeneous of degree one in depth and approach: it remembers no speed. Where it is
/// loaded slowly, as under a rim that rolls, it is a spring with a damper y k / w_v.
/// \param damping y \param stiffness w_v^2
template <class V> OVERTURN_LANES_INLINE V element_depth(V depth, V approach, V yield, V damping, V stiffness) {
    constexpr double least = 1e-300;
    V const elastic = elastic_depth(depth, yield);
    V const square = fma(stiffness * elastic, elastic, approach * approach);
    return max(fma(damping * elastic, approach / sqrt(max(square, V(least))), elastic), V(0));
}

/// The gain of a point that is away from the ground: it goes by the speed at which the point comes down.
/// \param damping y
template <class V> OVERTURN_LANES_INLINE V gain_of_approach(V approach, V damping, V least_approach) {
    return damping / max(approach, least_approach);
}

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
