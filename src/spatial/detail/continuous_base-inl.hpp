// What a continuous rim, disc or ring is to its pressure, in any vector width. Included once per instruction set, so
// without a #pragma once; by rim_pressure-inl.hpp and face_pressure-inl.hpp only.
#if defined(OVERTURN_CONTINUOUS_BASE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_CONTINUOUS_BASE
#undef OVERTURN_CONTINUOUS_BASE
#else
#define OVERTURN_CONTINUOUS_BASE
#endif

#include "simd/lanes-inl.hpp"
#include "spatial/detail/spatial_body-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// What the pressures of a continuous base have in common, along its rim or with all of its face.
template <class V, int Stride> class ContinuousBase : protected SpatialBody<V, Stride> {
  public:
    using Body = SpatialBody<V, Stride>;
    using typename Body::Base;
    using typename Body::M;

  protected:
    using Body::get;

    /// Towards the lowest point, along the body's own axes, and how much lower than the middle that is.
    struct Lean {
        V x, y, change;
    };
    /// Pressure on the base, and the place where it grips.
    struct Patch {
        V press;           // sum of the normal forces
        V by_x, by_y;      // of these times x and y of where they act
        V x, y, gyration;  // centre of the elastic pressure, radius of gyration about it
    };
    /// What damping presses over the stiffness of what touches; moments over the radius, towards the lowest point and
    /// across.
    struct Damping {
        V press, along, across;
    };

    explicit ContinuousBase(SpatialLanes<Stride>& lanes) : Body(lanes) {}
    [[nodiscard]] OVERTURN_LANES_INLINE Lean lean_of(Base const& base) const;
};

// Upright it leans nowhere: there the way in which it begins to lean takes its place, so that what is done to the
// motion, a turn or a mirror, is done to the nodes.
template <class V, int Stride>
OVERTURN_LANES_INLINE auto ContinuousBase<V, Stride>::lean_of(Base const& base) const -> Lean {
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

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
