#include "spectra/detail/close_reading.hpp"

#include "simd/targets.hpp"
#include "spectra/detail/tile_bounds.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/close_reading.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using ReadLanes = simd::HWY_NAMESPACE::SweepDoubles<1>;

// Products and sums are rounded one by one, as in the step of one oscillator.
void states_all(CloseReading& reading) {
    using V = ReadLanes;
    auto const& step = reading.step;
    auto const& chord = reading.chord;
    for (std::size_t lane = 0; lane < reading.count; lane += V::count) {
        auto const of = [&](simd::LaneValues<> const& values) HWY_ATTR { return V::load(values.data() + lane); };
        V const yy = of(step.yy);
        V const yv = of(step.yv);
        V const ya0 = of(step.ya0);
        V const ya1 = of(step.ya1);
        V const vy = of(step.vy);
        V const vv = of(step.vv);
        V const va0 = of(step.va0);
        V const va1 = of(step.va1);
        V const real_a0 = of(chord.real_a0);
        V const real_a1 = of(chord.real_a1);
        V const imaginary_y = of(chord.imaginary_y);
        V const imaginary_v = of(chord.imaginary_v);
        V const imaginary_a0 = of(chord.imaginary_a0);
        V const imaginary_a1 = of(chord.imaginary_a1);
        V const scale = of(chord.scale);
        V y = of(reading.y[0]);
        V v = of(reading.v[0]);
        V a0 = of(reading.ground[0]);
        V most = 0;
        V furthest = 0;
        for (std::size_t n = 0; n < CloseReading::samples; ++n) {
            V const a1 = of(reading.ground[n + 1]);
            V const y1 = yy * y + yv * v + (ya0 * a0 + ya1 * a1);
            V const v1 = vy * y + vv * v + (va0 * a0 + va1 * a1);
            V const real = y + (real_a0 * a0 + real_a1 * a1);
            V const imaginary = imaginary_y * y + imaginary_v * v + (imaginary_a0 * a0 + imaginary_a1 * a1);
            V const reach = max(abs(y), abs(y1)) * (1 + bound_error) + scale * (abs(real) + abs(imaginary));
            reach.store(reading.reach[n].data() + lane);
            y1.store(reading.y[n + 1].data() + lane);
            v1.store(reading.v[n + 1].data() + lane);
            most = max(abs(y1), most);
            furthest = max(reach, furthest);
            y = y1;
            v = v1;
            a0 = a1;
        }
        most.store(reading.most.data() + lane);
        furthest.store(reading.furthest.data() + lane);
    }
}

void recursion_all(CloseReading& reading) {
    using V = ReadLanes;
    auto& recursion = reading.recursion;
    for (std::size_t lane = 0; lane < reading.count; lane += V::count) {
        auto const of = [&](simd::LaneValues<> const& values) HWY_ATTR { return V::load(values.data() + lane); };
        V const ahead = of(recursion.ahead);
        V const behind = of(recursion.behind);
        V const now = of(recursion.now);
        V const last = of(recursion.last);
        V const unit = of(recursion.unit);
        V w = of(recursion.w);
        V d = of(recursion.d);
        V most = 0;
        for (std::size_t n = 0; n < CloseReading::samples; ++n) {
            V const next = ahead * d + (behind * w + of(reading.ground[n + 1]));
            V const before = w;
            w = w + d;
            d = next;
            V const y = unit * (now * w + (last * before + d));
            y.store(reading.y[n + 1].data() + lane);
            most = max(abs(y), most);
        }
        w.store(recursion.w.data() + lane);
        d.store(recursion.d.data() + lane);
        most.store(reading.most.data() + lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(states_all);
HWY_EXPORT(recursion_all);

void read_states(CloseReading& reading) { HWY_DYNAMIC_DISPATCH(states_all)(reading); }

void read_recursion(CloseReading& reading) { HWY_DYNAMIC_DISPATCH(recursion_all)(reading); }

}  // namespace overturn
#endif
