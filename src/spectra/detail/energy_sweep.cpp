#include "spectra/detail/energy_sweep.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/energy_sweep.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

// 12 coefficients and three states each: two registers of them are what 32 registers hold.
using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;

template <class V> struct Coefficients {
    V of_y, of_v, of_a0, of_a1;

    OVERTURN_LANES_INLINE V operator()(V y, V v, V a0, V a1) const {
        return fma(y, of_y, fma(v, of_v, fma(of_a1, a1, of_a0 * a0)));
    }
};

template <class V> void sweep_some(std::span<double const> acceleration, EnergyLanes& lanes, std::size_t lane) {
    auto const from = [lane](simd::LaneValues<> const& values) HWY_ATTR { return V::load(values.data() + lane); };
    Coefficients<V> const displacement{from(lanes.yy), from(lanes.yv), from(lanes.ya0), from(lanes.ya1)};
    Coefficients<V> const velocity{from(lanes.vy), from(lanes.vv), from(lanes.va0), from(lanes.va1)};
    Coefficients<V> const mean_displacement{from(lanes.my), from(lanes.mv), from(lanes.ma0), from(lanes.ma1)};
    V y = 0;
    V v = 0;
    V energy = 0;
    for (std::size_t n = 1; n < acceleration.size(); ++n) {
        double const a0 = acceleration[n - 1];
        double const a1 = acceleration[n];
        V const next = displacement(y, v, a0, a1);
        V const mean = mean_displacement(y, v, a0, a1);
        v = velocity(y, v, a0, a1);
        // int a y' over the step, by parts: a0 (y1 - y0) + (a1 - a0) (y1 - mean y).
        energy = energy - (a0 * (next - y) + (a1 - a0) * (next - mean));
        y = next;
    }
    energy.store(lanes.energy.data() + lane);
}

void sweep_all(std::span<double const> acceleration, EnergyLanes& lanes) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
        sweep_some<SomeLanes>(acceleration, lanes, lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sweep_all);

void sweep_energy(std::span<double const> acceleration_mps2, EnergyLanes& lanes) {
    HWY_DYNAMIC_DISPATCH(sweep_all)(acceleration_mps2, lanes);
}

}  // namespace overturn
#endif
