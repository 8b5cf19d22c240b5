#include "spectra/detail/response_sweep.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/response_sweep.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"
#include "spectra/detail/side_by_side-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;

// Some lanes of a group, from `lane` on.
template <class V> struct OneResponse {
    ResponseLanes& lanes;
    std::size_t lane;

    [[nodiscard]] OVERTURN_LANES_INLINE V of(simd::LaneValues<> ResponseLanes::*values) const {
        return V::load((lanes.*values).data() + lane);
    }
    OVERTURN_LANES_INLINE void put(simd::LaneValues<> ResponseLanes::*values, V found) const {
        found.store((lanes.*values).data() + lane);
    }
};

// All lanes of two groups.
struct TwoResponses {
    ResponseLanes& lanes;
    ResponseLanes& others;

    [[nodiscard]] OVERTURN_LANES_INLINE TwoGroupsLanes of(simd::LaneValues<> ResponseLanes::*values) const {
        return load_two(lanes.*values, others.*values);
    }
    OVERTURN_LANES_INLINE void put(simd::LaneValues<> ResponseLanes::*values, TwoGroupsLanes found) const {
        store_two(found, (lanes.*values).data(), (others.*values).data());
    }
};

template <class V, SweptPeaks Peaks, ForcingTerm Term, class Responses>
void sweep_some(std::span<double const> acceleration, int steps, Responses lanes) {
    V const zz = lanes.of(&ResponseLanes::zz);
    V const zu = lanes.of(&ResponseLanes::zu);
    V const za = lanes.of(&ResponseLanes::za);
    V const ya = lanes.of(&ResponseLanes::ya);
    V const uz = lanes.of(&ResponseLanes::uz);
    V const uu = lanes.of(&ResponseLanes::uu);
    V const ua = lanes.of(&ResponseLanes::ua);
    V const va = lanes.of(&ResponseLanes::va);
    V const cv = lanes.of(&ResponseLanes::cv);
    V const cy = lanes.of(&ResponseLanes::cy);
    double const before = acceleration.empty() ? 0 : acceleration[0];
    V z = ya * -before;
    V u = va * -before;
    V y2 = 0;
    V v2 = 0;
    V a2 = 0;
    double const part = 1.0 / steps;
    for (std::size_t n = 1; n < acceleration.size(); ++n) {
        double const rise = acceleration[n] - acceleration[n - 1];
        double a0 = acceleration[n - 1];
        for (int s = 1; s <= steps; ++s) {
            double const a1 = s == steps ? acceleration[n] : acceleration[n - 1] + rise * (s * part);
            V const z0 = Term == ForcingTerm::factor ? za * a0 : V(a0);
            V const u0 = Term == ForcingTerm::factor ? ua * a0 : V(a0);
            V const next = fma(z, zz, fma(u, zu, z0));
            u = fma(z, uz, fma(u, uu, u0));
            z = next;
            V const y = fma(ya, a1, next);
            y2 = max(y * y, y2);
            if constexpr (Peaks == SweptPeaks::all) {
                V const v = fma(va, a1, u);
                V const absolute = fma(v, cv, cy * y);
                v2 = max(v * v, v2);
                a2 = max(absolute * absolute, a2);
            }
            a0 = a1;
        }
    }
    lanes.put(&ResponseLanes::end_z, z);
    lanes.put(&ResponseLanes::end_u, u);
    lanes.put(&ResponseLanes::y2, y2);
    lanes.put(&ResponseLanes::v2, v2);
    lanes.put(&ResponseLanes::a2, a2);
}

template <class V, class Responses>
void sweep_term(std::span<double const> acceleration, ResponseForm const& form, Responses lanes) {
    bool const factor = form.forcing == ForcingTerm::factor;
    if (form.peaks == SweptPeaks::all) {
        factor ? sweep_some<V, SweptPeaks::all, ForcingTerm::factor>(acceleration, form.steps, lanes)
               : sweep_some<V, SweptPeaks::all, ForcingTerm::unit>(acceleration, form.steps, lanes);
    } else {
        factor ? sweep_some<V, SweptPeaks::displacement, ForcingTerm::factor>(acceleration, form.steps, lanes)
               : sweep_some<V, SweptPeaks::displacement, ForcingTerm::unit>(acceleration, form.steps, lanes);
    }
}

void sweep_one(std::span<double const> acceleration, ResponseForm const& form, ResponseLanes& lanes) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
        sweep_term<SomeLanes>(acceleration, form, OneResponse<SomeLanes>{lanes, lane});
    }
}

void sweep_two(std::span<double const> acceleration, ResponseForm const& form, ResponseLanes& lanes,
               ResponseLanes& others) {
    if constexpr (pairs_win) {
        sweep_term<TwoGroupsLanes>(acceleration, form, TwoResponses{lanes, others});
    } else {
        sweep_one(acceleration, form, lanes);
        sweep_one(acceleration, form, others);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sweep_one);
HWY_EXPORT(sweep_two);

void sweep_response(std::span<double const> acceleration_mps2, ResponseForm const& form, ResponseLanes& lanes) {
    HWY_DYNAMIC_DISPATCH(sweep_one)(acceleration_mps2, form, lanes);
}

void sweep_response(std::span<double const> acceleration_mps2, ResponseForm const& form, ResponseLanes& lanes,
                    ResponseLanes& others) {
    HWY_DYNAMIC_DISPATCH(sweep_two)(acceleration_mps2, form, lanes, others);
}

}  // namespace overturn
#endif
