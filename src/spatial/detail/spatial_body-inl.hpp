// What a body in space is to the forces on its base, in any vector width: lanes, balance of momentum. Included once per
// instruction set, so without a #pragma once; by point_force-inl.hpp, continuous_base-inl.hpp and patch_force-inl.hpp
// only.
#if defined(OVERTURN_SPATIAL_BODY) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_SPATIAL_BODY
#undef OVERTURN_SPATIAL_BODY
#else
#define OVERTURN_SPATIAL_BODY
#endif

#include "simd/lanes-inl.hpp"
#include "spatial/detail/base_motion-inl.hpp"
#include "spatial/detail/spatial_state.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

template <class V, int Stride> class SpatialBody {
  public:
    using Value = V;
    using M = typename V::Mask;
    using Motion = spatial::HWY_NAMESPACE::Motion<V>;
    using Line = spatial::HWY_NAMESPACE::Line<V>;
    using Base = spatial::HWY_NAMESPACE::Base<V>;
    struct Shaking {
        V x, y, weight;  // horizontal accelerations; gravity with the vertical one
    };
    struct Pull {
        Triple<V> move, spin;  // accelerations
        V press;               // sum of the normal forces
        Triple<V> shear;       // rate of Motion::shear
    };
    struct Depths {
        V least, most;  // of the places that stand highest and lowest; of the latter without crush
    };

  protected:
    struct Sums {
        Triple<V> all, by_x, by_y;  // of forces; of forces times x and y of their points
    };

    explicit SpatialBody(SpatialLanes<Stride>& lanes)
        : body_(lanes.body.values.data()), samples_(lanes.body.samples.data()) {}

    template <class Name> [[nodiscard]] static constexpr std::ptrdiff_t row(Name name) {
        return static_cast<std::ptrdiff_t>(name) * Stride;
    }
    [[nodiscard]] OVERTURN_LANES_INLINE V get(State field) const { return V::load(body_ + row(field)); }
    OVERTURN_LANES_INLINE void put(State field, V value) { value.store(body_ + row(field)); }
    OVERTURN_LANES_INLINE void fetch_wave(Wave wave, V index, V& here, V& next) const {
        fetch(samples_ + row(wave), index, here, next);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE Pull pull_of(Sums const& sums, Motion const& at, Shaking const& by) const;

  private:
    double* body_;
    double const* const* samples_;
};

template <class V, int Stride>
OVERTURN_LANES_INLINE auto SpatialBody<V, Stride>::pull_of(Sums const& sums, Motion const& at, Shaking const& by) const
    -> Pull {
    auto const& [all, by_x, by_y] = sums;
    auto const [first, second, third] = axes_of(at.turn);
    V const h = get(State::height);
    V const zero = 0;
    // (X, Y, -h) x F in the body's own axes, over all points
    V const turn_x = dot(third, by_y) + h * dot(second, all);
    V const turn_y = -(dot(third, by_x) + h * dot(first, all));
    V const turn_z = dot(second, by_x) - dot(first, by_y);
    V const ix = get(State::inertia_x);
    V const iy = get(State::inertia_y);
    V const iz = get(State::inertia_z);
    auto const& w = at.spin;
    return {{all.x - by.x, all.y - by.y, all.z - by.weight},
            {(turn_x - (iz - iy) * (w.y * w.z)) * get(State::mass_over_inertia_x),
             (turn_y - (ix - iz) * (w.z * w.x)) * get(State::mass_over_inertia_y),
             (turn_z - (iy - ix) * (w.x * w.y)) * get(State::mass_over_inertia_z)},
            all.z,
            {zero, zero, zero}};
}

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
