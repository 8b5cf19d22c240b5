// Vectors, quaternions and axes of bodies in space, in any vector width. Included once per instruction set, so without
// a #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_ROTATION) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_ROTATION
#undef OVERTURN_ROTATION
#else
#define OVERTURN_ROTATION
#endif

#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

template <class V> struct Triple { V x, y, z; };

template <class V> OVERTURN_LANES_INLINE Triple<V> operator*(V factor, Triple<V> const& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}
template <class V> OVERTURN_LANES_INLINE Triple<V> operator+(Triple<V> const& a, Triple<V> const& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V> OVERTURN_LANES_INLINE Triple<V> operator-(Triple<V> const& a, Triple<V> const& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// factor a + b
template <class V> OVERTURN_LANES_INLINE Triple<V> fma(V factor, Triple<V> const& a, Triple<V> const& b) {
    return {fma(factor, a.x, b.x), fma(factor, a.y, b.y), fma(factor, a.z, b.z)};
}
template <class V> OVERTURN_LANES_INLINE V dot(Triple<V> const& a, Triple<V> const& b) {
    return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
// Unfused: the cross product of equals is zero to the last bit.
template <class V> OVERTURN_LANES_INLINE Triple<V> cross(Triple<V> const& a, Triple<V> const& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class V> struct Quaternion { V w, x, y, z; };

/// The body's own axes in space: the columns of its rotation matrix.
template <class V> struct Axes { Triple<V> first, second, third; };

// Unfused products of equal numbers cancel; a body that turns about one axis alone keeps exact zeros.
template <class V> OVERTURN_LANES_INLINE Axes<V> axes_of(Quaternion<V> const& q) {
    V const x = q.x + q.x;
    V const y = q.y + q.y;
    V const z = q.z + q.z;
    V const xx = x * q.x;
    V const yy = y * q.y;
    V const zz = z * q.z;
    return {{1.0 - (yy + zz), x * q.y + z * q.w, x * q.z - y * q.w},
            {x * q.y - z * q.w, 1.0 - (xx + zz), y * q.z + x * q.w},
            {x * q.z + y * q.w, y * q.z - x * q.w, 1.0 - (xx + yy)}};
}

/// Turned by a rotation vector u about the body's own axes: q exp(u / 2), for the turns of a step. The first terms that
/// the sums leave out are (|u|/2)^8 / 8! of the cosine and (|u|/2)^9 / 9! of the sine: below rounding (2^-53) up to
/// |u| = 0.076 rad. How large the turn of a step can be: bounds, in src/contact/README.md.
template <class V> OVERTURN_LANES_INLINE Quaternion<V> turned(Quaternion<V> const& q, Triple<V> const& u) {
    V const square = fma(u.x, u.x, fma(u.y, u.y, u.z * u.z));
    // sin(|u|/2) / |u| and 1 - cos(|u|/2)
    V const sine = fma(square, fma(square, fma(square, -1.0 / 645120, 1.0 / 3840), -1.0 / 48), 0.5);
    V const versine = square * fma(square, fma(square, 1.0 / 46080, -1.0 / 384), 0.125);
    V const x = sine * u.x;
    V const y = sine * u.y;
    V const z = sine * u.z;
    // The small change is made up first: q keeps its digits.
    return {q.w - (q.w * versine + (q.x * x + q.y * y + q.z * z)),
            q.x + ((q.w * x - q.x * versine) + (q.y * z - q.z * y)),
            q.y + ((q.w * y - q.y * versine) + (q.z * x - q.x * z)),
            q.z + ((q.w * z - q.z * versine) + (q.x * y - q.y * x))};
}

/// To unit length, from as near to it as rounding leaves it.
template <class V> OVERTURN_LANES_INLINE Quaternion<V> normalised(Quaternion<V> const& q) {
    V const square = q.w * q.w + (q.x * q.x + (q.y * q.y + q.z * q.z));
    V const factor = fma(square, -0.5, 1.5);
    return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

/// Rate of a rotation vector u about the body's axes, less the angular velocity: u x w / 2 + u x (u x w) / 12, of
/// Magnus' series as far as a method of fourth order needs it (Iserles et al. 2000).
template <class V> OVERTURN_LANES_INLINE Triple<V> turning_excess(Triple<V> const& u, Triple<V> const& w) {
    auto const once = cross(u, w);
    auto const twice = cross(u, once);
    return {fma(twice.x, 1.0 / 12, 0.5 * once.x), fma(twice.y, 1.0 / 12, 0.5 * once.y),
            fma(twice.z, 1.0 / 12, 0.5 * once.z)};
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
