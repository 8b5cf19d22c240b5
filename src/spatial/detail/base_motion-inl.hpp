// How the base of a body moves with it, in any vector width. Included once per instruction set, so without a #pragma
// once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_BASE_MOTION) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_BASE_MOTION
#undef OVERTURN_BASE_MOTION
#else
#define OVERTURN_BASE_MOTION
#endif

#include "simd/lanes-inl.hpp"
#include "spatial/detail/rotation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

template <class V> struct Motion {
    Triple<V> at;  // x, y, rise of the centre of gravity
    Quaternion<V> turn;
    Triple<V> velocity;
    Triple<V> spin;   // about the body's own axes
    Triple<V> shear;  // of the springs under a rim: along x and y, and by its twist times the arc's radius of gyration
};

/// A quantity that changes evenly over the base.
template <class V> struct Line {
    V by_x, by_y, at;  // per metre along the body's own axes; at the base's centre

    [[nodiscard]] OVERTURN_LANES_INLINE V of(V x, V y) const { return fma(by_x, x, fma(by_y, y, at)); }
};

/// The base of a moving body: how deep it lies, how fast it comes down, where it is, and how fast it slides.
template <class V> struct Base { Line<V> depth, approach, x, y, x_rate, y_rate; };

/// \param h of the centre of gravity above the base
template <class V> OVERTURN_LANES_INLINE Base<V> base_of(Motion<V> const& body, V h) {
    auto const [first, second, third] = axes_of(body.turn);
    auto const& w = body.spin;
    Triple<V> const spin{fma(first.x, w.x, second.x * w.y) + third.x * w.z,
                         fma(second.y, w.y, first.y * w.x) + third.y * w.z,
                         fma(third.z, w.z, first.z * w.x + second.z * w.y)};
    auto const arm = cross(spin, third);
    auto const first_rate = cross(spin, first);
    auto const second_rate = cross(spin, second);
    V const versine = 2.0 * fma(body.turn.x, body.turn.x, body.turn.y * body.turn.y);
    auto const& at = body.at;
    auto const& velocity = body.velocity;
    return {{-first.z, -second.z, -fma(h, versine, at.z)},
            {-first_rate.z, -second_rate.z, h * arm.z - velocity.z},
            {first.x, second.x, at.x - h * third.x},
            {first.y, second.y, at.y - h * third.y},
            {first_rate.x, second_rate.x, velocity.x - h * arm.x},
            {first_rate.y, second_rate.y, velocity.y - h * arm.y}};
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
