// What the points of a base do to the body, in any vector width. Included once per instruction set, so without a
// #pragma once; by contact_step-inl.hpp only.
#if defined(OVERTURN_CONTACT_FORCE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_CONTACT_FORCE
#undef OVERTURN_CONTACT_FORCE
#else
#define OVERTURN_CONTACT_FORCE
#endif

#include "contact/detail/contact_step.hpp"
#include "contact/point_law-inl.hpp"
#include "contact/rest_gate.hpp"
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

/// \tparam Points of the base; 0: as many as the argument states
template <class V, int Stride, int Points> class ContactForce {
  public:
    using M = typename V::Mask;

    struct Motion {
        V sway, rise, sine, cosine, sway_speed, rise_speed, spin;
    };
    struct Shaking {
        V across, weight;  // horizontal acceleration; gravity with the vertical one
    };
    struct Pull {
        V sway, rise, spin;    // accelerations
        V press, least_depth;  // sum of the normal forces; of the point that stands highest
    };

    explicit ContactForce(ContactLanes<Stride>& lanes)
        : body_(lanes.body.values.data()),
          bed_(lanes.bed.data()),
          samples_(lanes.body.samples.data()),
          points_(Points > 0 ? Points : lanes.points),
          of_rim_(Points == 0 && lanes.of_rim) {}

  protected:
    [[nodiscard]] OVERTURN_LANES_INLINE V get(ContactField field) const { return V::load(body_ + row(field)); }
    OVERTURN_LANES_INLINE void put(ContactField field, V value) { value.store(body_ + row(field)); }
    OVERTURN_LANES_INLINE void fetch_wave(ContactWave wave, V index, V& here, V& next) const {
        fetch(samples_ + row(wave), index, here, next);
    }

    [[nodiscard]] OVERTURN_LANES_INLINE Pull now(Motion const& at, Shaking const& by) const {
        return pulled<false>(at, by, bed_);
    }
    /// Also brings what the points remember up to date; that changes no force.
    OVERTURN_LANES_INLINE Pull now_and_remember(Motion const& at, Shaking const& by) {
        return pulled<true>(at, by, bed_);
    }

  private:
    template <class Name> [[nodiscard]] static constexpr std::ptrdiff_t row(Name name) {
        return static_cast<std::ptrdiff_t>(name) * Stride;
    }
    [[nodiscard]] static OVERTURN_LANES_INLINE V spot(double const* point, Spot field) {
        return V::load(point + row(field));
    }
    static OVERTURN_LANES_INLINE void set_spot(double* point, Spot field, V value) { value.store(point + row(field)); }
    template <bool Remember> OVERTURN_LANES_INLINE Pull pulled(Motion const& at, Shaking const& by, double* bed) const;
    OVERTURN_LANES_INLINE void remember_touch(double* point, V depth, V approach) const;
    OVERTURN_LANES_INLINE V remember_anchor(double* point, V here, V shift, V most) const;

    double* body_;
    double* bed_;
    double const* const* samples_;
    int points_;
    bool of_rim_;  // two corners never are
};

// The approach speed until it touches; the crush that it leaves.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE void ContactForce<V, Stride, Points>::remember_touch(double* point, V depth, V approach) const {
    if (M const away = depth <= V(0); any(away)) {
        V const fresh = gain_of_approach(approach, get(ContactField::damping), get(ContactField::least_approach));
        set_spot(point, Spot::gain, choose(away, fresh, spot(point, Spot::gain)));
    }
    V const excess = depth - spot(point, Spot::yield);
    if (any(excess > V(0))) {
        set_spot(point, Spot::crush, spot(point, Spot::crush) + max(excess, V(0)));
    }
}

// An anchor that friction cannot hold follows its point. Returns the shift that is left.
template <class V, int Stride, int Points>
OVERTURN_LANES_INLINE V ContactForce<V, Stride, Points>::remember_anchor(double* point, V here, V shift, V most) const {
    M const drags = abs(shift) > most;
    V const held = max(-most, min(most, shift));
    if (any(drags)) {
        set_spot(point, Spot::anchor, choose(drags, here - held, spot(point, Spot::anchor)));
    }
    return held;
}

template <class V, int Stride, int Points>
template <bool Remember>
OVERTURN_LANES_INLINE auto ContactForce<V, Stride, Points>::pulled(Motion const& at, Shaking const& by,
                                                                   double* bed) const -> Pull {
    V const zero = 0;
    V const h = get(ContactField::height);
    V const turning = at.spin * at.sine;
    V const rolling = at.spin * at.cosine;
    V const lift = fma(h, 1.0 - at.cosine, at.rise);  // of the middle of the base
    V const lift_speed = fma(h, turning, at.rise_speed);
    V const slide = at.sway_speed - h * rolling;
    V const base = at.sway - h * at.sine;
    V const friction = get(ContactField::friction);
    V const ratio = get(ContactField::tangential_ratio);
    V const drag = get(ContactField::tangential_damping);
    V const cap = get(ContactField::most_damping);
    V press = zero;
    V grip = zero;
    V press_moment = zero;
    V grip_moment = zero;
    V least_depth = 1e300;
    for (int i = 0; i < (Points > 0 ? Points : points_); ++i) {
        double* const point = bed + i * row(Spot::count);
        V const offset = spot(point, Spot::offset);
        V const yield = spot(point, Spot::yield);
        V const depth = fma(at.sine, offset, -lift) - spot(point, Spot::crush);
        V const approach = fma(rolling, offset, -lift_speed);
        if constexpr (Remember) {
            remember_touch(point, depth, approach);
            least_depth = min(depth, least_depth);
        }
        V const normal =
            of_rim_ ? element_depth(depth, approach, yield, get(ContactField::damping), get(ContactField::stiffness))
                    : normal_depth(depth, approach, yield, spot(point, Spot::gain), cap);
        V const here = fma(at.cosine, offset, base);
        V shift = here - spot(point, Spot::anchor);
        if constexpr (Remember) {
            shift = remember_anchor(point, here, shift, get(ContactField::hold) * normal);
        }
        V const limit = friction * normal;
        V const wanted = fma(ratio, shift, drag * fma(-turning, offset, slide));
        V const held = max(-limit, min(limit, wanted));  // against the motion
        V const stiffness = spot(point, Spot::stiffness);
        V const lever = spot(point, Spot::lever);
        // Unfused: what two corners do equally cancels to the last bit.
        press = press + stiffness * normal;
        grip = grip + stiffness * held;
        press_moment = press_moment + lever * normal;
        grip_moment = grip_moment + lever * held;
    }
    V const moment = at.sine * grip_moment - at.cosine * press_moment + h * fma(at.cosine, grip, at.sine * press);
    return {-(grip + by.across), press - by.weight, moment * get(ContactField::mass_over_inertia), press, least_depth};
}

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
