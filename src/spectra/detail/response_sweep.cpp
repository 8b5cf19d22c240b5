#include "spectra/detail/response_sweep.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/response_sweep.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;

template <class V, SweptPeaks Peaks, ForcingTerm Term>
void sweep_some(std::span<double const> acceleration, int steps, ResponseLanes& lanes, std::size_t lane) {
    auto const from = [lane](simd::LaneValues<> const& values) HWY_ATTR { return V::load(values.data() + lane); };
    V const zz = from(lanes.zz);
    V const zu = from(lanes.zu);
    V const za = from(lanes.za);
    V const ya = from(lanes.ya);
    V const uz = from(lanes.uz);
    V const uu = from(lanes.uu);
    V const ua = from(lanes.ua);
    V const va = from(lanes.va);
    V const cv = from(lanes.cv);
    V const cy = from(lanes.cy);
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
    z.store(lanes.end_z.data() + lane);
    u.store(lanes.end_u.data() + lane);
    y2.store(lanes.y2.data() + lane);
    v2.store(lanes.v2.data() + lane);
    a2.store(lanes.a2.data() + lane);
}

template <SweptPeaks Peaks>
void sweep_peaks(std::span<double const> acceleration, int steps, ForcingTerm forcing, ResponseLanes& lanes) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
        forcing == ForcingTerm::factor
            ? sweep_some<SomeLanes, Peaks, ForcingTerm::factor>(acceleration, steps, lanes, lane)
            : sweep_some<SomeLanes, Peaks, ForcingTerm::unit>(acceleration, steps, lanes, lane);
    }
}

void sweep_all(std::span<double const> acceleration, int steps, SweptPeaks peaks, ForcingTerm forcing,
               ResponseLanes& lanes) {
    peaks == SweptPeaks::all ? sweep_peaks<SweptPeaks::all>(acceleration, steps, forcing, lanes)
                             : sweep_peaks<SweptPeaks::displacement>(acceleration, steps, forcing, lanes);
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sweep_all);

void sweep_response(std::span<double const> acceleration_mps2, int steps, SweptPeaks peaks, ForcingTerm forcing,
                    ResponseLanes& lanes) {
    HWY_DYNAMIC_DISPATCH(sweep_all)(acceleration_mps2, steps, peaks, forcing, lanes);
}

}  // namespace overturn
#endif
