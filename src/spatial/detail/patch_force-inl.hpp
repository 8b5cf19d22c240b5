// What a continuous rim, disc or ring does to a body in space: its pressure, and how it grips, in any vector width.
// Included once per instruction set, so without a #pragma once; by spatial_step-inl.hpp only.
#if defined(OVERTURN_PATCH_FORCE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_PATCH_FORCE
#undef OVERTURN_PATCH_FORCE
#else
#define OVERTURN_PATCH_FORCE
#endif

#include "simd/lanes-inl.hpp"
#include "spatial/detail/spatial_body-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

/// A continuous base on its pad. It grips as one patch at the centre of the elastic pressure: springs that roll with
/// it, by two displacements and a twist, up to mu N together. \tparam Pressure of its rim or face
template <class Pressure> class PatchForce : protected Pressure {
  public:
    static constexpr bool shears = true;  ///< Motion::shear is what its springs are stretched by

    using Body = typename Pressure::Body;
    using Value = typename Body::Value;
    using typename Pressure::Base;
    using Depths = typename Body::Depths;
    using Line = typename Body::Line;
    using M = typename Body::M;
    using Motion = typename Body::Motion;
    using Pull = typename Body::Pull;
    using Shaking = typename Body::Shaking;

    template <class Lanes> explicit PatchForce(Lanes& lanes) : Pressure(lanes) {}
    void complete() {}

  protected:
    using Pressure::get;
    using Pressure::patch_of;
    using Pressure::pull_of;

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
    using V = Value;
    using typename Pressure::Patch;
    using Sums = typename Body::Sums;

    [[nodiscard]] OVERTURN_LANES_INLINE Pull pulled(Patch const& patch, Base const& base, Motion const& at,
                                                    Shaking const& by) const;

    Base start_;
    Patch patch_;
};

template <class Pressure> OVERTURN_LANES_INLINE auto PatchForce<Pressure>::begin(Motion& start) -> Depths {
    start_ = base_of(start, get(State::height));
    patch_ = patch_of(start_);
    V const most = get(State::hold) * patch_.press / get(State::stiffness);
    V const square = dot(start.shear, start.shear);
    if (M const slips = square > most * most; any(slips)) {
        V const share = choose(slips, most / sqrt(square), V(1));
        start.shear = share * start.shear;
    }
    V const change = Pressure::lean_of(start_).change;
    return {start_.depth.at - change, start_.depth.at + change};
}

template <class Pressure>
OVERTURN_LANES_INLINE auto PatchForce<Pressure>::pulled(Patch const& patch, Base const& base, Motion const& at,
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
