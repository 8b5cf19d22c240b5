// The arc over which a tilted rim lies in the ground, in any vector width. Included once per instruction set, so
// without a #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_ARC) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_ARC
#undef OVERTURN_ARC
#else
#define OVERTURN_ARC
#endif

#include <numbers>

#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// asin(sqrt(square)) of 0 <= square <= 1, to 2 units in the last place: the rational of musl's asin (Sun Microsystems
/// 1993) below sine 1/2, and pi/2 - 2 asin(sqrt((1 - sine) / 2)) above.
template <class V> OVERTURN_LANES_INLINE V angle_of(V square) {
    V const sine = sqrt(square);
    auto const large = sine > V(0.5);
    V const z = choose(large, 0.5 - 0.5 * sine, square);
    V const s = choose(large, sqrt(z), sine);
    V const above = fma(
        z,
        fma(z,
            fma(z, fma(z, fma(z, 3.47933107596021167570e-05, 7.91534994289814532176e-04), -4.00555345006794114027e-02),
                2.01212532134862925881e-01),
            -3.25565818622400915405e-01),
        1.66666666666666657415e-01);
    V const below =
        fma(z,
            fma(z, fma(z, fma(z, 7.70381505559019352791e-02, -6.88283971605453293030e-01), 2.02094576023350569471e+00),
                -2.40339491173441421878e+00),
            1.0);
    V const angle = fma(s, z * above / below, s);
    return choose(large, 0.5 * std::numbers::pi - 2.0 * angle, angle);
}

/// sin of 0 <= angle <= pi/2 by Taylor's series: what it leaves out is below angle^21 / 21! = 2.6e-16.
template <class V> OVERTURN_LANES_INLINE V sine_of(V angle) {
    V const z = angle * angle;
    V sum = fma(z, -1.0 / 121645100408832000.0, 1.0 / 355687428096000.0);
    for (double const factor :
         {-1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6}) {
        sum = fma(z, sum, factor);
    }
    return fma(angle * z, sum, angle);
}

/// Depth h0 + h1 cos(phi) round a rim, where it is positive: |phi| <= 2 half.
template <class V> struct Arc {
    V half;                  ///< of half the arc: 0, it is away; pi/2, all of it touches
    V all, sine, cosine;     ///< 2 half, and its sine and cosine
    V depths, first_moment;  ///< over the arc: of the depth, and of the depth times cos(phi)
};

/// \param middle, change h0 and h1 >= 0
template <class V> OVERTURN_LANES_INLINE Arc<V> arc_of(V middle, V change) {
    constexpr double least = 1e-300;
    V const square = min(max((middle + change) / (2.0 * max(change, V(least))), V(0)), V(1));
    V const half = angle_of(square);
    V const all = half + half;
    V const sine = 2.0 * sqrt(square * (1.0 - square));
    V const cosine = 1.0 - (square + square);
    return {half,
            all,
            sine,
            cosine,
            2.0 * fma(middle, all, change * sine),
            2.0 * fma(middle, sine, 0.5 * change * fma(sine, cosine, all))};
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
